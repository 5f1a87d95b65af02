using System;
using Rabit.Core;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>What the rules judge a manager by.</summary>
internal readonly struct ManagerFacts(string name, in ManagerStatus status, bool hasFaultedLately, TimeSpan quietFor)
{
    public string Name { get; } = name;

    public ManagerState State { get; } = status.State;

    public TimeSpan WakeUpDelay { get; } = status.WakeUpDelay;

    public long Faults { get; } = status.Faults;

    public bool HasFaultedLately { get; } = hasFaultedLately;

    /// <summary>Since its last unit of work began; before its first, since ours.</summary>
    public TimeSpan QuietFor { get; } = quietFor;
}
