using System;
using Rabit.Core;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for a manager.</summary>
internal readonly struct ManagerFacts(
    string name,
    ManagerState state,
    TimeSpan wakeUpDelay,
    long faults,
    bool hasFaultedRecently,
    TimeSpan quietFor,
    TimeSpan hangingSince = default)
{
    public string Name { get; } = name;

    public ManagerState State { get; } = state;

    public TimeSpan WakeUpDelay { get; } = wakeUpDelay;

    public long Faults { get; } = faults;

    public bool HasFaultedRecently { get; } = hasFaultedRecently;

    /// <summary>Since its last unit of work began; before its first, since ours.</summary>
    public TimeSpan QuietFor { get; } = quietFor;

    /// <summary>When it entered the code in which it hangs; see <see cref="ManagerState.Hanging"/>.</summary>
    public TimeSpan HangingSince { get; } = hangingSince;
}
