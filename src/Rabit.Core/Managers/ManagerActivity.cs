using System;
using System.Collections.Generic;
using System.Threading;

namespace Rabit.Core.Managers;

/// <summary>
/// Runs one manager: marks it as the running one, keeps its status, and turns what it throws into faults. All on the manager's
/// thread, but for <see cref="Doing"/>, <see cref="HasBegun"/> and <see cref="Faults"/>, which the reactor reads.
/// </summary>
internal sealed class ManagerActivity(RabitManager manager, ManagerRun run) : Activity(manager.Name, manager.WakeUpEvent)
{
    private readonly object _gate = new();                 // guards _faults
    private readonly List<ManagerFault> _faults = [];      // the first few: a manager that always throws must not fill the memory
    private long _faultCount;                              // under _gate
    private int _stage = -1;                               // written by the manager's thread, read by all; -1: idle
    private bool _hasBegun;                                // same
    private TimeSpan _faultDelay;
    private TimeSpan _lastEnd;                             // when the last stage ended: read from the clock once, used for all
    private TimeSpan _due;                                 // when the timer is to wake, set with each run
    private PeriodGrid _grid;                              // the deadlines of a manager with a fixed period
    private bool _isHalted;

    private const int FaultsKept = 10;

    public override string Doing => Volatile.Read(ref _stage) switch
    {
        (int)ManagerStage.Startup => "Startup",
        (int)ManagerStage.UnitOfWork => "ExecuteUnitOfWork",
        (int)ManagerStage.Shutdown => "Shutdown",
        _ => "sleeping",
    };

    public bool HasBegun => Volatile.Read(ref _hasBegun);

    public RabitManager Manager => manager;

    public (IReadOnlyList<ManagerFault> First, long Count) Faults
    {
        get
        {
            lock (_gate)
                return (_faults.ToArray(), _faultCount);
        }
    }

    public long Runs { get; private set; }

    public override void Begin()
    {
        Volatile.Write(ref _hasBegun, true);
        Execute(ManagerStage.Startup, WakeUpCauses.None, ManagerState.Starting);
    }

    public override NextTurn TakeTurn(WakeUps wakes, TimeSpan? wokenAt)
    {
        if (_isHalted)
            return NextTurn.Never;

        TimeSpan begin = run.Clock.Now;
        if (run.Log.LogsRuns)
            run.Log.Write(RabitLogKind.Run, Name, $"runs, woken by {wakes.Causes}");

        bool isSound = Execute(ManagerStage.UnitOfWork, wakes.Causes, ManagerState.Running, begin, wakes.Count, wokenAt);
        TimeSpan end = _lastEnd;
        if (isSound)
        {
            _faultDelay = TimeSpan.Zero;
            return NextTurn.At(_due, notBefore: end);
        }

        return _isHalted ? NextTurn.Never : NextTurn.OnlyAt(Later(end, _faultDelay));
    }

    public override void End() => Execute(ManagerStage.Shutdown, WakeUpCauses.None, ManagerState.Stopped);

    private bool Execute(
        ManagerStage stage, WakeUpCauses causes, ManagerState state, TimeSpan begin = default, int wakes = 0, TimeSpan? wokenAt = null)
    {
        EndOwner? outer = RunningManager.Current;
        RunningManager.Current = manager.Owner;
        Volatile.Write(ref _stage, (int)stage);
        Exception? thrown = null;
        try
        {
            Call(stage, causes);
        }
        catch (Exception e)
        {
            // The supervisor's place: whatever leaves the user's code becomes a fault, and its policy decides.
            thrown = e;
        }

        _lastEnd = EndOf(stage, begin);
        if (thrown is not null)
            OnFault(stage, thrown);
        ref ManagerStatus status = ref manager.StatusPublisher.Value;
        if (stage == ManagerStage.UnitOfWork)
            CountRun(ref status, causes, begin, wakes, wokenAt);
        PostStatus(ref status, stage == ManagerStage.Shutdown || thrown is null ? state : ManagerState.Faulted);
        Volatile.Write(ref _stage, -1);
        RunningManager.Current = outer;
        return thrown is null;
    }

    private void Call(ManagerStage stage, WakeUpCauses causes)
    {
        switch (stage)
        {
            case ManagerStage.Startup:
                manager.RunStartup();
                break;
            case ManagerStage.UnitOfWork:
                manager.RunUnitOfWork(causes);
                break;
            case ManagerStage.Shutdown:
                manager.RunShutdown();
                break;
        }
    }

    private void CountRun(ref ManagerStatus status, WakeUpCauses causes, TimeSpan begin, int wakes, TimeSpan? wokenAt)
    {
        if (run.TakeReset())
            status = new ManagerStatus { Faults = status.Faults, LastFault = status.LastFault };
        Runs++;
        status.Runs++;
        WakeUpCounts counts = status.WakeUps;
        counts.Count(causes, wakes);
        status.WakeUps = counts;
        status.LastRunAt = begin;
        status.UnitOfWorkTime = status.UnitOfWorkTime.With(_lastEnd - begin);
        if (wokenAt is { } at)
            status.WakeLatency = status.WakeLatency.With(begin - at);
        status.Slips += SetTimer(begin);
    }

    /// <returns>The deadlines that have passed.</returns>
    private long SetTimer(TimeSpan begin)
    {
        if (manager.Period is not { } period)
        {
            _grid = default;
            _due = Later(_lastEnd, manager.WakeUpDelay);
            return 0;
        }

        _due = _grid.Next(period, begin, _lastEnd, out long slips);
        return slips;
    }

    private void PostStatus(ref ManagerStatus status, ManagerState state)
    {
        status.State = state;
        status.WakeUpDelay = manager.Period ?? manager.WakeUpDelay;
        manager.StatusPublisher.Post(_lastEnd);
    }

    private void OnFault(ManagerStage stage, Exception thrown)
    {
        var fault = new ManagerFault(Name, stage, run.Clock.Now, thrown);
        lock (_gate)
        {
            _faultCount++;
            if (_faults.Count < FaultsKept)
                _faults.Add(fault);
        }

        ref ManagerStatus status = ref manager.StatusPublisher.Value;
        status.Faults++;
        status.LastFault = fault.ToString();
        run.Log.Write(RabitLogKind.Fault, Name, fault.ToString(), thrown);

        FaultPolicy policy = manager.FaultPolicy;
        if (policy.StopsSystem)
        {
            _isHalted = true;
            run.RequestStop(fault.ToString());
        }
        else
        {
            _faultDelay = policy.DelayAfter(_faultDelay);
        }
    }

    // In virtual time the clock stands still during a unit of work; its modelled duration is added.
    private TimeSpan EndOf(ManagerStage stage, TimeSpan begin)
        => stage == ManagerStage.UnitOfWork && ModelledDuration > TimeSpan.Zero ? begin + ModelledDuration : run.Clock.Now;

    private static TimeSpan Later(TimeSpan time, TimeSpan delay) => time > TimeSpan.MaxValue - delay ? TimeSpan.MaxValue : time + delay;
}
