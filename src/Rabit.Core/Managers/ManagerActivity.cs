using System;
using System.Diagnostics.Tracing;
using System.Linq;
using System.Threading;
using Rabit.Core.Devices;
using Rabit.Core.Diagnostics;
using Rabit.Core.Reactors;
using Rabit.Core.Statistics;
using Rabit.Core.Supervision;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Managers;

/// <summary>
/// Runs one manager: marks it as the running one, keeps its status, turns what it throws into faults and does what its
/// fault policy says. All on the manager's thread, but for <see cref="Doing"/>, <see cref="HasBegun"/>,
/// <see cref="HasStoppedAlone"/> and the lists, which the reactor reads, and <see cref="Hangs"/>, by which the watchdog
/// looks at it.
/// </summary>
internal sealed partial class ManagerActivity(RabitManager manager, ManagerRun run, bool lends = false)
    : Activity(manager.Name, manager.WakeUpEvent)
{
    private readonly FaultFollowUp _followUp = new(manager, run);
    private readonly ManagerStatistics _statistics = new();
    private bool _hasBegun;           // written by the manager's thread, read by the reactor's
    private bool _hasStoppedAlone;    // same
    private bool _isUp;               // a start-up that has no shutdown yet
    private ManagerStage _stage;      // as last entered
    private ManagerState _state;      // as last posted
    private KeptWakeUps _kept;
    private TimeSpan _lastEnd;        // when the last stage ended: read from the clock once, used for all
    private TimeSpan _due;            // when the timer is to wake, set with each run
    private bool _isOnGrid;           // whether that is a deadline of a fixed period
    private PeriodGrid _grid;         // the deadlines of a manager with a fixed period

    public override string Doing => Hangs.Doing;

    public bool HasBegun => Volatile.Read(ref _hasBegun);

    /// <summary>Whether a fault ended it, and only it. Its devices need not begin then.</summary>
    public bool HasStoppedAlone => Volatile.Read(ref _hasStoppedAlone);

    public RabitManager Manager => manager;

    public BoundedList<ManagerFault> Faults => _followUp.Faults;

    /// <summary>The requests to stop; null where no reactor runs it.</summary>
    public StopDelay? Stop => run.StopDelay;

    public HangWatch Hangs { get; } = new(manager, run);

    /// <summary>Read by the reactor when the manager has ended.</summary>
    public long Runs { get; private set; }

    /// <summary>As <see cref="Runs"/>.</summary>
    public long Restarts { get; private set; }

    /// <summary>Lets its readers and writers know the run. Before anything begins.</summary>
    public void ConnectDevices()
    {
        foreach (DeviceActivity device in manager.Readers.Concat(manager.Writers))
            device.Connect(run.Clock, run.Log, this);
    }

    public override void Begin()
    {
        Volatile.Write(ref _hasBegun, true);
        if (!StartUp())
            AfterFault();
    }

    public override NextStep RunStep(ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        NextStep next = HasLoanLeft(ref wakes) ? _afterLoan : Step(wakes, wokenAt);
        _ownDue = next.Due;
        return next;
    }

    // On the manager's thread, or that of a reader that has borrowed it.
    private NextStep Step(ConsumedWakeUps wakes, TimeSpan? wokenAt, bool isLent = false)
    {
        ComeBack();
        if (_followUp.IsHalted)
            return NextStep.Never;

        // A wake that a spin found is answered by a clock read less.
        TimeSpan begin = wakes.SpunUntil > TimeSpan.Zero ? wakes.SpunUntil : run.Clock.Now;
        if (_followUp.IsRestarting)
        {
            // The barrier opens for one whose start-up threw, too; its time comes later.
            return _kept.TryWait(wakes, begin, _followUp.ResumeAt, out NextStep next) ? next : Restart();
        }

        wakes = _kept.Take(wakes);
        if (run.Log.LogsRuns)
            run.Log.Write(RabitLogKind.Run, Name, $"runs, woken by {wakes.Causes}");
        if (!Execute(ManagerStage.UnitOfWork, ManagerState.Running, begin, wakes, wokenAt))
            return isLent ? LeaveFault() : AfterFault();
        _followUp.OnSuccessfulRun();
        return NextStep.At(_due, notBefore: _lastEnd, manager.SpinBeforeSleep, LendsItself);
    }

    public override void End()
    {
        CutModelled();
        if (_isUp)
            ShutDown(ManagerState.Stopped);
        else
            PostState(ManagerState.Stopped);
    }

    private bool StartUp()
    {
        _isUp = true;
        return Execute(ManagerStage.Startup, ManagerState.Starting, run.Clock.Now);
    }

    private void ShutDown(ManagerState state)
    {
        _isUp = false;
        Execute(ManagerStage.Shutdown, state, run.Clock.Now);
    }

    private NextStep Restart()
    {
        Restarts++;
        _followUp.Resume();
        _grid = default;
        run.Log.Write(
            RabitLogKind.Lifecycle, Name, FormattableString.Invariant($"starts up again, restart {Restarts}"));
        return StartUp() ? _kept.StartedAgain(_lastEnd) : AfterFault();
    }

    private NextStep AfterFault()
    {
        _isOnGrid = false;
        switch (_followUp.Action)
        {
            case FaultAction.StopManager:
                StopAlone();
                return NextStep.Never;
            case FaultAction.Restart:
                ShutDown(ManagerState.Restarting);
                return NextStep.OnlyAt(_followUp.ResumeAt);
            case FaultAction.CarryOn:
                return NextStep.OnlyAt(_followUp.ResumeAt);
            default:
                return NextStep.Never;
        }
    }

    // As the reactor does it, but for the waiting: a manager never waits for its devices.
    private void StopAlone()
    {
        Volatile.Write(ref _hasStoppedAlone, true);
        foreach (DeviceActivity reader in manager.Readers)
            reader.StopAlone();
        ShutDown(ManagerState.Faulted);
        foreach (DeviceActivity writer in manager.Writers)
            writer.StopAlone();
        run.Log.Write(RabitLogKind.Lifecycle, Name, "is stopped alone; the others continue");
    }

    private bool Execute(
        ManagerStage stage, ManagerState state, TimeSpan begin, ConsumedWakeUps wakes = default,
        TimeSpan? wokenAt = null)
    {
        var scope = new RunningScope();
        scope.Enter(manager.Owner);
        _stage = stage;
        Hangs.Enter(stage, begin);
        Exception? thrown = null;
        try
        {
            Call(stage, wakes.Causes, wokenAt ?? begin);
        }
        catch (Exception e)
        {
            // The supervisor's place: whatever leaves the user's code becomes a fault, and its policy decides.
            thrown = e;
        }

        Leave(stage, begin);
        ref ManagerStatus status = ref manager.StatusPublisher.Value;
        if (thrown is not null)
            _followUp.OnFault(new ManagerFault(Name, stage, run.Clock.Now, thrown), _lastEnd, ref status);
        if (stage == ManagerStage.UnitOfWork)
            CountRun(ref status, begin, wakes, wokenAt);
        else if (stage == ManagerStage.Shutdown)
            _statistics.FillPercentiles(ref status);
        PostStatus(ref status, stage == ManagerStage.Shutdown || thrown is null ? state : ManagerState.Faulted);
        scope.Leave();
        return thrown is null;
    }

    private void Call(ManagerStage stage, WakeUpCauses causes, TimeSpan due)
    {
        switch (stage)
        {
            case ManagerStage.Startup:
                manager.RunStartup();
                break;
            case ManagerStage.UnitOfWork:
                manager.RunUnitOfWork(causes, due, ModelledDuration);
                break;
            case ManagerStage.Shutdown:
                manager.RunShutdown();
                break;
        }
    }

    private void CountRun(ref ManagerStatus status, TimeSpan begin, ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        if (run.TakeReset())
            _statistics.Reset(ref status);
        Runs++;
        status.Runs++;
        status._wakeUps.Count(wakes.Causes, wakes.Count);
        status.SpinTime += wakes.Spun;
        status.LastRunAt = begin;
        TimeSpan? deadline = _isOnGrid && (wakes.Causes & WakeUpCauses.Timer) != 0 ? _due : null;
        PeriodGrid grid = _grid;
        long missed = SetTimer(begin);
        if (ModelledDuration > TimeSpan.Zero)
            _modelled = new ModelledRun(
                begin, _lastEnd, wokenAt, deadline, grid, manager.Period, missed, Hangs.IsInModelledWork);
        if (!_modelled.IsToBeCounted)
        {
            CountTimes(ref status, begin, _lastEnd, wokenAt, deadline);
            status.MissedDeadlines += missed;
        }

        if (manager.TakeLate())
            status.LateUnitsOfWork++;
    }

    private void CountTimes(
        ref ManagerStatus status, TimeSpan begin, TimeSpan end, TimeSpan? wokenAt, TimeSpan? deadline)
    {
        if (!run.KeepsStatistics)
            return;
        _statistics.CountRun(ref status, begin, end, wokenAt, deadline);
        if (RabitEventSource.Instance.IsEnabled()
            && RabitEventSource.Instance.IsEnabled(EventLevel.Verbose, EventKeywords.None))
            RabitEventSource.Instance.UnitOfWork(
                Name, Microseconds(end - begin), wokenAt is { } at ? Microseconds(begin - at) : -1);
    }

    /// <returns>The deadlines that have passed.</returns>
    private long SetTimer(TimeSpan begin)
    {
        if (manager.Period is not { } period)
        {
            _isOnGrid = false;
            _grid = default;
            _due = Times.LaterOrNever(_lastEnd, manager.WakeUpDelay);
            return 0;
        }

        _isOnGrid = true;
        _due = _grid.Next(period, begin, _lastEnd, out long missed);
        return missed;
    }

    private void PostState(ManagerState state)
    {
        var scope = new RunningScope();
        scope.Enter(manager.Owner);
        _lastEnd = run.Clock.Now;
        PostStatus(ref manager.StatusPublisher.Value, state);
        scope.Leave();
    }

    private void PostStatus(ref ManagerStatus status, ManagerState state)
    {
        status.State = _state = state;
        status.WakeUpDelay = manager.Period ?? manager.WakeUpDelay;
        status.Restarts = Restarts;
        Hangs.Describe(ref status);
        manager.StatusPublisher.PostStamped(_lastEnd);
    }

    private static int Microseconds(TimeSpan time) => (int)Math.Min(int.MaxValue, time.Ticks / 10);
}
