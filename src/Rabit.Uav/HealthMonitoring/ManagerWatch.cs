using System;
using Rabit.Core;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>What is remembered of one manager between two looks.</summary>
internal sealed class ManagerWatch(string name, MessageSubscriber<ManagerStatus> status)
{
    private readonly RecentRise _faults = new();

    public string Name { get; } = name;

    /// <param name="now">The time.</param>
    /// <param name="watchedSince">When Health Monitoring began.</param>
    /// <param name="options">How long a fault is told of.</param>
    public ManagerFacts Look(TimeSpan now, TimeSpan watchedSince, HealthOptions options)
    {
        // Of its own status a manager gets no news: it has the same local copy.
        status.Fetch();
        ref readonly ManagerStatus value = ref status.Value;
        TimeSpan lastSign = value.Runs > 0 && value.LastRunAt > watchedSince ? value.LastRunAt : watchedSince;
        return new ManagerFacts(Name, value, _faults.Take(value.Faults, now, options.RememberedFor), now - lastSign);
    }
}
