namespace Rabit.Uav.HealthMonitoring;

/// <summary>Whether a rule applies.</summary>
internal delegate bool HealthCondition<T>(in T facts, HealthOptions options);
