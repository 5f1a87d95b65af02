using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core.Devices;
using Rabit.Core.Managers;
using Rabit.Core.Messages;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core;

/// <summary>
/// One of the things that a control program has going on at once. Derive from it, say in the constructor what it
/// publishes, fetches, sends and receives, and write its unit of work. It runs on a thread of its own (in steps of its
/// own in virtual time) and meets others only through messages and queues.
/// </summary>
/// <remarks>
/// <see cref="Startup"/>, <see cref="ExecuteUnitOfWork"/> and <see cref="Shutdown"/> run on the manager's thread (units
/// of work also on those of its readers, where it allows that: <see cref="RunsOnReaders"/>).
/// Between units of work it sleeps until something wakes it: the timer, a post, push or pop that it asked to be woken
/// by, or <see cref="WakeUp"/>. Wake-ups do not stack: any number that come during a unit of work cause exactly one
/// more.
/// </remarks>
/// <example>
/// <code>
/// public sealed class Counter : RabitManager
/// {
///     private readonly MessagePublisher&lt;int&gt; _count;
///
///     public Counter() : base("counter")
///     {
///         _count = Publish&lt;int&gt;("count");
///         Period = TimeSpan.FromMilliseconds(20);
///     }
///
///     protected override void ExecuteUnitOfWork()
///     {
///         _count.Value++;   // fill in the local copy ...
///         _count.Post();    // ... and post it
///     }
/// }
/// </code>
/// </example>
public abstract partial class RabitManager
{
    private const string StatusSuffix = "/status";

    private readonly EndpointOwner _owner;
    private TimeSpan _wakeUpDelay = TimeSpan.FromSeconds(1);
    private TimeSpan? _period;
    private FaultPolicy _faultPolicy = FaultPolicy.StopSystem;
    private TimeSpan? _stopTimeout;
    private string? _doing;   // written by the manager's thread, read by the watchdog
    private ManagerRun? _run;

    /// <summary>
    /// Names the manager. Derived constructors record what it posts, fetches, sends and receives; nothing runs yet.
    /// </summary>
    /// <param name="name">Unique within its reactor; also the name of its thread.</param>
    /// <exception cref="ArgumentException">The name is empty or has a line break.</exception>
    protected RabitManager(string name)
    {
        Name = Require.Name(name, nameof(name), "A manager");
        WakeUpEvent = new WakeUpEvent();
        _owner = new EndpointOwner(Name, isManager: true, WakeUpEvent);
        StatusPublisher = new MessagePublisher<ManagerStatus>(Declare(
            new MessageBinding<ManagerStatus>(_owner, EndpointRole.Publish, StatusMessageName(Name))
            {
                IsBuiltIn = true
            }));
    }

    /// <summary>The name, unique within its reactor.</summary>
    public string Name { get; }

    /// <summary>
    /// How long the manager sleeps before its timer wakes it, from the moment it goes to sleep. 1 s by default. The
    /// unit of work may change it at any time; the change holds from the next sleep.
    /// <see cref="Timeout.InfiniteTimeSpan"/> for no timer: only events wake the manager then.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Zero or negative, and not infinite.</exception>
    public TimeSpan WakeUpDelay
    {
        get => _wakeUpDelay;
        protected set
        {
            // Units of work set it too: the text is made only where it is needed.
            if (value <= TimeSpan.Zero && value != Timeout.InfiniteTimeSpan)
                Require.Positive(value, nameof(value), $"The wake-up delay of manager '{Name}'");
            _wakeUpDelay = value;
        }
    }

    /// <summary>
    /// A fixed period instead of <see cref="WakeUpDelay"/>: deadlines on a grid that begins with the unit of work that
    /// first runs with this period, so that they do not drift, however long the work takes and whatever else wakes the
    /// manager. A deadline that passes during a unit of work is missed (<see cref="ManagerStatus.MissedDeadlines"/>):
    /// one run follows at once, and the grid continues; there is never a burst. Null, the default, for
    /// <see cref="WakeUpDelay"/>. The unit of work may change it; the change holds from the next sleep.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Zero or negative.</exception>
    public TimeSpan? Period
    {
        get => _period;
        protected set
        {
            if (value is { } period && period <= TimeSpan.Zero)
                Require.Positive(period, nameof(value), $"The period of manager '{Name}'");
            _period = value;
        }
    }

    /// <summary>
    /// What follows an exception that left the manager's code; by default the system stops. Set before the start.
    /// </summary>
    public FaultPolicy FaultPolicy
    {
        get => _faultPolicy;
        set => _faultPolicy = Require.NotNull(value, nameof(value));
    }

    /// <summary>
    /// How long this manager may be in its code, and what follows when it does not return. Set before the start.
    /// </summary>
    /// <value>Null, the default, for that of the reactor (<see cref="ReactorOptions.HangPolicy"/>).</value>
    public HangPolicy? HangPolicy { get; set; }

    /// <summary>
    /// How long this manager, and each of its readers and writers, may take to stop. Set before the start.
    /// </summary>
    /// <value>Null, the default, for that of the reactor (<see cref="ReactorOptions.StopTimeout"/>).</value>
    /// <exception cref="ArgumentOutOfRangeException">Zero or negative.</exception>
    public TimeSpan? StopTimeout
    {
        get => _stopTimeout;
        set
            => _stopTimeout = value is { } timeout
                ? Require.Positive(timeout, nameof(value), $"The time in which manager '{Name}' must stop")
                : null;
    }

    /// <summary>
    /// What the manager is doing, in a few words, for the report of a hang: set it before something that may take long.
    /// It costs a field; a constant text costs no more. Forgotten when the manager next enters its code. Set on the
    /// manager's thread, read on any.
    /// </summary>
    protected internal string? Doing
    {
        get => Volatile.Read(ref _doing);
        protected set => Volatile.Write(ref _doing, value);
    }

    /// <summary>
    /// Why the running unit of work runs. By default everything is done on every wake, and the code need not ask.
    /// </summary>
    protected WakeUpCauses WakeUpCauses { get; private set; }

    /// <summary>
    /// Time since the reactor was made, on the monotonic clock of the run: the time of all stamps. Any thread.
    /// </summary>
    /// <exception cref="InvalidOperationException">The manager is not in a reactor that has started.</exception>
    protected TimeSpan Now => Run.Clock.Now;

    /// <summary>The clock of the run, for wall time. Any thread.</summary>
    /// <exception cref="InvalidOperationException">The manager is not in a reactor that has started.</exception>
    protected TimeProvider Clock => Run.Clock.Provider;

    internal WakeUpEvent WakeUpEvent { get; }

    internal EndpointOwner Owner => _owner;

    internal MessagePublisher<ManagerStatus> StatusPublisher { get; }

    internal List<EndpointDeclaration> Declarations { get; } = [];

    internal List<DeviceActivity> Readers { get; } = [];

    internal List<DeviceActivity> Writers { get; } = [];

    private ManagerRun Run
        => _run ?? throw new InvalidOperationException($"Manager '{Name}' is not in a reactor that has started.");

    /// <summary>The name of the message by which a manager reports its <see cref="ManagerStatus"/>.</summary>
    /// <param name="managerName">The manager.</param>
    public static string StatusMessageName(string managerName) => managerName + StatusSuffix;

    /// <summary>
    /// Wakes the manager: a unit of work that starts after this call sees what the caller did before it. Any thread,
    /// never waits.
    /// </summary>
    public void WakeUp() => WakeUpEvent.Wake(WakeUpCauses.Request);

    /// <summary>Resets the figures of <see cref="ManagerStatus"/> with the next unit of work. Any thread.</summary>
    public void ResetStatistics() => _run?.ResetStatistics();

    /// <summary>Called once, before the first unit of work of any manager.</summary>
    protected virtual void Startup()
    {
    }

    /// <summary>
    /// The work: fetch, pop, compute, post, push, return. It should not block; see <see cref="AttachReader{T}"/> for
    /// devices.
    /// </summary>
    protected abstract void ExecuteUnitOfWork();

    /// <summary>Called once at the end, if <see cref="Startup"/> was called, whatever ended the run.</summary>
    protected virtual void Shutdown()
    {
    }

    /// <summary>Writes a line to the log of the run. Any thread.</summary>
    /// <param name="text">One line.</param>
    protected void Log(string text) => Run.Log.Write(RabitLogKind.Manager, Name, text);

    /// <summary>Whether the manager is in a reactor that has started: it serves no other one.</summary>
    internal bool IsAttached => _run is not null;

    internal static bool IsStatusMessageName(string name) => name.EndsWith(StatusSuffix, StringComparison.Ordinal);

    internal void Attach(ManagerRun run)
    {
        _run = run;
        if (_delaysStop)
            SetDelay(delays: true);
    }

    internal void ForgetDoing() => Volatile.Write(ref _doing, null);

    internal void RunStartup() => Startup();

    internal void RunUnitOfWork(WakeUpCauses causes, TimeSpan due, TimeSpan modelledDuration)
    {
        WakeUpCauses = causes;
        try
        {
            try
            {
                ExecuteUnitOfWork();
            }
            catch (Exception)
            {
                CheckDeadlineAfterFault(due, modelledDuration);
                throw;
            }

            if (_unitOfWorkDeadline is { } deadline)
                CheckDeadline(deadline, due, modelledDuration);
        }
        finally
        {
            WakeUpCauses = WakeUpCauses.None;
        }
    }

    internal void RunShutdown() => Shutdown();
}
