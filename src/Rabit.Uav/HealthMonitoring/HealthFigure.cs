namespace Rabit.Uav.HealthMonitoring;

/// <summary>The figure that people want to know with a finding.</summary>
internal delegate long HealthFigure<T>(in T facts);
