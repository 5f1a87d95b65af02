using System;
using Rabit.Core;

namespace Rabit.Uav.Web.Collecting;

/// <summary>What a manager last posted of itself. Immutable.</summary>
/// <param name="PostedAt">When it did, by the clock of the run.</param>
/// <param name="Status">What it posted.</param>
internal readonly record struct ManagerMoment(TimeSpan PostedAt, ManagerStatus Status);
