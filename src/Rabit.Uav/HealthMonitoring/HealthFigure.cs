namespace Rabit.Uav.HealthMonitoring;

/// <summary>The figure that is reported with a finding.</summary>
internal delegate long HealthFigure<T>(in T facts);
