using System;
using Rabit.Core;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>What the rules judge a manager by.</summary>
internal readonly struct ManagerFacts(
    string name, ManagerState state, TimeSpan wakeUpDelay, long faults, bool hasFaultedLately, TimeSpan quietFor, TimeSpan hangingSince = default)
{
    public string Name { get; } = name;

    public ManagerState State { get; } = state;

    public TimeSpan WakeUpDelay { get; } = wakeUpDelay;

    public long Faults { get; } = faults;

    public bool HasFaultedLately { get; } = hasFaultedLately;

    /// <summary>Since its last unit of work began; before its first, since ours.</summary>
    public TimeSpan QuietFor { get; } = quietFor;

    /// <summary>When it entered the code that it does not come back from; see <see cref="ManagerState.Hanging"/>.</summary>
    public TimeSpan HangingSince { get; } = hangingSince;
}
