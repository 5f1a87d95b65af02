namespace Rabit.Uav.HealthMonitoring;

/// <summary>Whether something is wrong.</summary>
internal delegate bool HealthCondition<T>(in T facts, HealthOptions options);
