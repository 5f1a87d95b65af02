using System;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Reactors;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Managers;

/// <summary>What a manager is given of the run that it is part of.</summary>
internal sealed class ManagerRun(
    RunClock clock, RabitLog log, HangPolicy hangPolicy, bool keepsStatistics, Action<string> requestStop)
{
    private int _resetRequested;   // set by any thread, taken by the manager's

    public RunClock Clock { get; } = clock;

    public RabitLog Log { get; } = log;

    public HangPolicy HangPolicy { get; } = hangPolicy;

    public bool KeepsStatistics { get; } = keepsStatistics;

    /// <summary>Lets a stop wait for the manager; null where no reactor runs it.</summary>
    public StopDelay? StopDelay { get; init; }

    /// <summary>
    /// Wakes the watchdog of a run in virtual time, where it sleeps until a modelled duration begins. Set before the
    /// start.
    /// </summary>
    public WakeUpEvent? WatchdogWakeUp { get; set; }

    public void RequestStop(string reason) => requestStop(reason);

    public void ResetStatistics() => Volatile.Write(ref _resetRequested, 1);

    public bool TakeReset()
        => Volatile.Read(ref _resetRequested) != 0 && Interlocked.Exchange(ref _resetRequested, 0) != 0;
}
