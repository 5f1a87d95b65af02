using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core.Devices;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Reactors;
using Rabit.Core.Supervision;
using Rabit.Core.Time;

namespace Rabit.Core;

/// <summary>
/// Runs managers: checks their wiring, starts them in order, waits until all have started up, lets them work until the
/// run is stopped, stops them in reverse order, and returns how each ended. For one run. Disposed, it stops: a test
/// that fails between <see cref="Start"/> and <see cref="Finish"/> leaves no threads behind.
/// </summary>
/// <example>
/// <code>
/// var reactor = new RabitReactor { new Counter(), new Display() };
/// ReactorResult result = reactor.Run();   // until Ctrl-C, SIGTERM or Stop
/// Environment.Exit(result.ExitCode);
/// </code>
/// </example>
public sealed partial class RabitReactor : IEnumerable<RabitManager>, IDisposable
{
    private const string Source = "reactor";

    private readonly ReactorOptions _options;
    private readonly RunClock _clock;
    private readonly RabitLog _log;
    private readonly ReactorEngine _engine;
    private readonly StopDelay _stop;
    private readonly List<RabitManager> _managers = [];
    private readonly List<ManagerActivity> _activities = [];   // filled by Start, then read only
    private ReactorSupervision? _supervision;                  // written by Start before _isWired, then read only

    // Guards the eight fields below: a stop comes from any thread.
    private readonly object _gate = new();
    private bool _isDisposed;
    private bool _isRunAsAWhole;   // by a Run that was not refused, which finishes what it starts
    private bool _hasStarted;
    private bool _isWired;
    private bool _isFinished;      // by Finish or Dispose, which is done with it at _hasEnded
    private bool _hasEnded;
    private string? _stopReason;
    private Exception? _failure;

    /// <summary>A reactor in real time.</summary>
    public RabitReactor()
        : this(new ReactorOptions())
    {
    }

    /// <summary>A reactor in the given time, otherwise with the default options.</summary>
    /// <param name="time">Real or virtual; used by this reactor only.</param>
    public RabitReactor(RabitTime time)
        : this(new ReactorOptions { Time = Require.NotNull(time, nameof(time)) })
    {
    }

    /// <summary>A reactor with options.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public RabitReactor(ReactorOptions options)
    {
        Require.NotNull(options, nameof(options)).Validate(nameof(options));
        _options = options = options.Copy();
        _clock = new RunClock(options.Time.Clock);
        _log = new RabitLog(
            options.Log, options.LogRuns, _clock, options.Time.CreateEventLog(_clock, Fail),
            new StandardErrorLog(options.Name));
        _engine = options.Time.CreateEngine(new EngineContext(_clock, _log, Fail));
        _stop = new StopDelay(options.MaxStopDelay, _clock, _log, _engine);
    }

    /// <summary>Where the managers meet; also gives endpoints to code outside managers.</summary>
    public RabitWorkspace Workspace { get; } = new();

    /// <summary>
    /// Time since the reactor was made, on the monotonic clock of the run; the same as <see cref="RabitManager.Now"/>.
    /// Any thread.
    /// </summary>
    public TimeSpan Now => _clock.Now;

    /// <summary>
    /// Whether the managers are wired: endpoints that <see cref="Workspace"/> made may be used from now on. Any thread.
    /// </summary>
    public bool IsWired
    {
        get
        {
            lock (_gate)
                return _isWired;
        }
    }

    /// <summary>Adds a manager; they start in the order in which they were added. Before the start only.</summary>
    /// <param name="manager">In one reactor only.</param>
    /// <exception cref="InvalidOperationException">
    /// The reactor has started, or the manager is in it already.
    /// </exception>
    public void Add(RabitManager manager)
    {
        Require.NotNull(manager, nameof(manager));
        lock (_gate)
        {
            if (_hasStarted)
                throw new InvalidOperationException(
                    $"The reactor has started: manager '{manager.Name}' comes too late.");
            if (_managers.Contains(manager))
                throw new InvalidOperationException($"Manager '{manager.Name}' is in the reactor already.");
            _managers.Add(manager);
        }
    }

    /// <summary>
    /// Runs until it is stopped, on the calling thread and those of the managers (virtual time: the calling thread
    /// alone).
    /// </summary>
    /// <returns>How each manager ended.</returns>
    /// <exception cref="RabitWiringException">The managers do not fit together; nothing was started.</exception>
    /// <exception cref="InvalidOperationException">The reactor was started before.</exception>
    public ReactorResult Run()
    {
        Claim(asAWhole: true);
        using StopSignals? signals = TakeStopSignals();
        return RunClaimed();
    }

    /// <summary>
    /// As <see cref="Run"/>, on a thread of its own. From its return on, a signal stops the run in order.
    /// </summary>
    /// <param name="stop">Stops the run when cancelled; the task then ends with the result, not as cancelled.</param>
    /// <returns>How each manager ended; or the exceptions of <see cref="Run"/>.</returns>
    public Task<ReactorResult> RunAsync(CancellationToken stop = default)
    {
        // Not an async method: a program that waits for the run in its main thread needs no pool of threads for it.
        try
        {
            Claim(asAWhole: true);
        }
        catch (InvalidOperationException refusal)
        {
            return Task.FromException<ReactorResult>(refusal);
        }

        var ended = new TaskCompletionSource<ReactorResult>(TaskCreationOptions.RunContinuationsAsynchronously);
        // Only now: the token of a call that is refused must not stop the run that is under way.
        CancellationTokenRegistration cancellation = stop.Register(() => Stop("cancelled"));
        StopSignals? signals = TakeStopSignals();
        var thread = new Thread(() =>
        {
            ReactorResult result;
            try
            {
                using (signals)
                using (cancellation)
                    result = RunClaimed();
            }
            catch (Exception e)
            {
                ended.SetException(e);
                return;
            }

            // Then the program may end; Mono ends this thread by an exception, which is no failure of the run.
            ended.SetResult(result);
        })
        { Name = Source, IsBackground = true };
        thread.Start();
        return ended.Task;
    }

    /// <summary>
    /// The first half of <see cref="Run"/>: wires, starts all managers and returns. For tests and programs that have a
    /// thread of their own to keep. Go on with <see cref="Finish"/>, in virtual time with <see cref="RunFor"/> before
    /// it.
    /// </summary>
    /// <exception cref="RabitWiringException">The managers do not fit together; nothing was started.</exception>
    /// <exception cref="InvalidOperationException">
    /// The reactor was started before, or a manager is in another one.
    /// </exception>
    public void Start()
    {
        Claim(asAWhole: false);
        StartClaimed();
    }

    /// <summary>Lets the managers work for a while and returns, or returns early when the run is stopped.</summary>
    /// <param name="duration">By the clock of the run. Zero runs what is due now (in virtual time).</param>
    /// <returns>
    /// False when the run is stopped: continue with <see cref="Finish"/>. True while managers delay the stop.
    /// </returns>
    /// <exception cref="ArgumentOutOfRangeException">Negative: time does not go back.</exception>
    /// <exception cref="InvalidOperationException">See <see cref="Finish"/>.</exception>
    public bool RunFor(TimeSpan duration)
    {
        if (duration < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(duration), duration, "A run cannot last less than no time.");
        RequireRunning(finishing: false);
        TimeSpan now = _clock.Now;
        RunUntil(duration > TimeSpan.MaxValue - now ? TimeSpan.MaxValue : now + duration);
        return !_stop.IsStopping;
    }

    /// <summary>
    /// The second half of <see cref="Run"/>: waits for a stop, stops all managers in reverse order, and returns how
    /// each ended.
    /// </summary>
    /// <exception cref="InvalidOperationException">
    /// The reactor has not started, or has finished; <see cref="Run"/>, <see cref="RunAsync"/> or another thread
    /// finishes it; or one of its managers calls this in its own code.
    /// </exception>
    public ReactorResult Finish()
    {
        RequireRunning(finishing: true);
        return End();
    }

    /// <summary>
    /// What <see cref="Start"/> would refuse, without starting anything: for programs with several reactors that name
    /// all faults together. Before the start.
    /// </summary>
    /// <returns>A line for each fault; empty where the managers fit together.</returns>
    public IReadOnlyList<string> FindWiringFaults() => Workspace.FindFaults(_managers, _options);

    /// <summary>The managers, in the order of their start.</summary>
    public IEnumerator<RabitManager> GetEnumerator() => _managers.GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    private ReactorResult RunClaimed()
    {
        StartClaimed();
        return End();
    }

    private void StartClaimed()
    {
        Prepare();
        lock (_gate)
            _isWired = true;
        Supervision.Begin(_engine);
        _log.Write(RabitLogKind.Lifecycle, Source, "starts " + string.Join(", ", _managers.Select(m => m.Name)));
        foreach (ManagerActivity activity in _activities)
        {
            if (_stop.IsStopping)
                return;
            _engine.Begin(activity);
        }

        if (_stop.TryOpen(_activities))
            OpenBarrier();
    }

    private ReactorResult EndAll()
    {
        RunUntil(TimeSpan.MaxValue);
        TimeSpan duration = _clock.Now;
        string reason = _stopReason ?? string.Empty;
        TimeSpan delay = _stop.Report(duration, out IReadOnlyList<string> stillDelaying);
        _log.Write(RabitLogKind.Lifecycle, Source, "stops: " + reason);

        var ending = new ManagerEnding(_engine, _clock, _log, _options);
        List<ManagerResult> results = ending.EndAll(_activities, Supervision);
        Supervision.End(_engine, _log, _clock.Now);
        IReadOnlyList<QueueResult> queues = CloseQueues();
        foreach (string leak in Workspace.FindLeaks())
            Fail(new InvalidOperationException(leak));
        _engine.Dispose();
        Supervision.Dispose();
        _log.Close();
        return new ReactorResult(reason, _failure, duration, results, queues)
        {
            StopDelay = delay,
            StillDelaying = stillDelaying,
        };
    }

    private ReactorSupervision Supervision => _supervision!;

    private void Prepare()
    {
        if (_managers.Find(m => m.IsAttached) is { } taken)
            throw new InvalidOperationException($"Manager '{taken.Name}' is in another reactor that has started.");
        Workspace.Wire(_managers, _options, _clock, _log);
        foreach (string note in Workspace.Notes)
            _log.Write(RabitLogKind.Note, Source, note);

        var runs = new List<ManagerRun>();
        foreach (RabitManager manager in _managers)
        {
            var run = new ManagerRun(
                _clock, _log, _options.HangPolicy, _options.KeepsStatistics,
                reason => RequestStop(reason, StopUrgency.Waits))
            {
                StopDelay = _stop
            };
            manager.Attach(run);
            var activity = new ManagerActivity(manager, run, lends: _engine.HasThreads && manager.RunsOnReaders);
            activity.ConnectDevices();
            _activities.Add(activity);
            runs.Add(run);
        }

        _supervision = ReactorSupervision.Create(_options, Workspace, _clock, _activities);
        foreach (ManagerRun run in runs)
            run.WatchdogWakeUp = _supervision.WatchdogWakeUp;
    }

    private IReadOnlyList<QueueResult> CloseQueues()
    {
        if (Workspace.TimeKeeper is { } timeKeeper)
            _engine.TryEnd(timeKeeper, _options.StopTimeout, TimeSpan.MaxValue);
        IReadOnlyList<QueueResult> queues = Workspace.CloseQueues();
        foreach (QueueResult queue in queues.Where(q => q.Counters.Resident > 0 || q.Held > 0))
            _log.Write(RabitLogKind.Note, queue.Name, queue.ToString());
        return queues;
    }

    private void OpenBarrier()
    {
        if (Workspace.TimeKeeper is { } timeKeeper)
        {
            _engine.Begin(timeKeeper);
            timeKeeper.WakeUp.Wake(WakeUpCauses.Start);
        }

        List<DeviceActivity> devices = _activities
            .Where(a => !a.HasStoppedAlone)
            .SelectMany(a => a.Manager.Writers.Concat(a.Manager.Readers))
            .ToList();
        foreach (DeviceActivity device in devices)
            _engine.Begin(device);
        foreach (Activity activity in _activities.Concat<Activity>(devices))
            activity.WakeUp.Wake(WakeUpCauses.Start);
    }

    private void Fail(Exception failure)
    {
        string text = ExceptionText.MessageOf(failure);
        _log.Write(RabitLogKind.Fault, Source, text, failure);
        RequestStop(text, StopUrgency.AtOnce, failure);
    }
}
