using System;
using Rabit.Core;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>What is remembered of one manager between two looks.</summary>
internal sealed class ManagerWatch(string name, MessageSubscriber<ManagerStatus> status)
{
    private readonly WindowedIncrease _faults = new();

    public string Name { get; } = name;

    public ManagerFacts Look(TimeSpan now, TimeSpan watchedSince, HealthOptions options)
    {
        // Of its own status a manager gets no news: it has the same local copy.
        status.Fetch();
        ref readonly ManagerStatus value = ref status.Value;
        TimeSpan lastSign = value.Runs > 0 && value.LastRunAt > watchedSince ? value.LastRunAt : watchedSince;
        bool faultedLately = _faults.Take(value.Faults, now, options.RememberedFor);
        return new ManagerFacts(Name, value.State, value.WakeUpDelay, value.Faults, faultedLately, now - lastSign, value.HangingSince);
    }
}
