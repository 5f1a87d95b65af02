using System;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>A duration of a rule, which may be an option.</summary>
internal delegate TimeSpan HealthDuration(HealthOptions options);
