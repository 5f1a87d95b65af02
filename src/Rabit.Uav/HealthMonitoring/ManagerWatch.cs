using System;
using Rabit.Core;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>The state of one manager between two evaluations.</summary>
internal sealed class ManagerWatch(string name, MessageSubscriber<ManagerStatus> status)
{
    private readonly WindowedIncrease _faults = new();

    public string Name { get; } = name;

    /// <summary>What its rules keep between two evaluations.</summary>
    public HealthRuleSet<ManagerFacts> Rules { get; } = new(HealthRules.OfManagers);

    public ManagerFacts Update(TimeSpan now, TimeSpan monitoredSince, HealthOptions options)
    {
        // Its own status is never new to a manager: it has the same local copy.
        status.Fetch();
        ref readonly ManagerStatus value = ref status.Value;
        TimeSpan lastSign = value.Runs > 0 && value.LastRunAt > monitoredSince ? value.LastRunAt : monitoredSince;
        bool faultedRecently = _faults.Update(value.Faults, now, options.RecentWindow);
        return new ManagerFacts(
            Name, value.State, value.WakeUpDelay, value.Faults, faultedRecently, now - lastSign, value.HangingSince);
    }
}
