using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace Rabit.Core.Tests.Contracts;

/// <summary>
/// A manager made of delegates, with everything that a derived class may use made public. Its timer is an hour, so that
/// a test sees only the wakes that it means.
/// </summary>
internal sealed class ScriptedManager : RabitManager
{
    private readonly TestBoard _board;
    private readonly Queue<Job> _jobs = new();             // under _board.Gate
    private readonly List<WakeUpCauses> _causes = [];      // same
    private int _startups;
    private int _units;
    private int _shutdowns;

    public ScriptedManager(string name, TestBoard board)
        : base(name)
    {
        _board = board;
        WakeUpDelay = TimeSpan.FromHours(1);
    }

    public Action? OnStartup { get; set; }

    public Action? OnUnit { get; set; }

    public Action? OnShutdown { get; set; }

    public int Startups => Volatile.Read(ref _startups);

    /// <summary>Units of work that have begun.</summary>
    public int Units => Volatile.Read(ref _units);

    public int Shutdowns => Volatile.Read(ref _shutdowns);

    public new TimeSpan WakeUpDelay
    {
        get => base.WakeUpDelay;
        set => base.WakeUpDelay = value;
    }

    public new TimeSpan SpinBeforeSleep
    {
        get => base.SpinBeforeSleep;
        set => base.SpinBeforeSleep = value;
    }

    public new bool RunsOnReaders
    {
        get => base.RunsOnReaders;
        set => base.RunsOnReaders = value;
    }

    public new TimeSpan? Period
    {
        get => base.Period;
        set => base.Period = value;
    }

    public new TimeSpan? UnitOfWorkDeadline
    {
        get => base.UnitOfWorkDeadline;
        set => base.UnitOfWorkDeadline = value;
    }

    public Action<TimeSpan>? OnLate { get; set; }

    public new string? Doing
    {
        get => base.Doing;
        set => base.Doing = value;
    }

    public new bool DelaysStop
    {
        get => base.DelaysStop;
        set => base.DelaysStop = value;
    }

    public new bool IsStopRequested => base.IsStopRequested;

    public TimeSpan Time => Now;

    public TimeProvider RunClock => Clock;

    public WakeUpCauses CausesNow => WakeUpCauses;

    /// <summary>Why each unit of work ran, the first one first.</summary>
    public IReadOnlyList<WakeUpCauses> Causes
    {
        get
        {
            lock (_board.Gate)
                return _causes.ToArray();
        }
    }

    public new MessagePublisher<T> Publish<T>(string name) => base.Publish<T>(name);

    public new MessagePublisher<T> Publish<T>(string name, T initial, bool allowOtherPublishers = false)
        => base.Publish(name, initial, allowOtherPublishers);

    public new MessageSubscriber<T> Subscribe<T>(string name, bool wakeOnPost = false, bool optional = false)
        => base.Subscribe<T>(name, wakeOnPost, optional);

    public new MessageSubscriber<ManagerStatus> SubscribeToStatus(string managerName, bool wakeOnPost = false)
        => base.SubscribeToStatus(managerName, wakeOnPost);

    public new QueueReceiver<T> Receive<T>(
        string name, int capacity = 100, QueueFullMode whenFull = QueueFullMode.Reject, bool wakeOnPush = true,
        TimeSpan? maxWait = null)
        => base.Receive<T>(name, capacity, whenFull, wakeOnPush, maxWait);

    public new QueueSender<T> Send<T>(string name, bool wakeOnPop = false) => base.Send<T>(name, wakeOnPop);

    public new BlockingReader<T> AttachReader<T>(
        string name,
        IReaderSource<T> source,
        int capacity = 100,
        QueueFullMode whenFull = QueueFullMode.Wait,
        TimeSpan? maxWait = null,
        ReconnectPolicy? reconnect = null)
        => base.AttachReader(name, source, capacity, whenFull, maxWait, reconnect);

    public new BlockingWriter<T> AttachWriter<T>(
        string name,
        IWriterTarget<T> target,
        int capacity = 100,
        QueueFullMode whenFull = QueueFullMode.Reject,
        ReconnectPolicy? reconnect = null)
        => base.AttachWriter(name, target, capacity, whenFull, reconnect);

    public void Say(string text) => Log(text);

    public void StopAll(string reason) => StopSystem(reason);

    /// <summary>Makes each call of start-up or unit of work throw, after something that the test does.</summary>
    public void ThrowIn(ManagerStage stage, Action? before = null)
    {
        void Fail()
        {
            before?.Invoke();
            throw new InvalidOperationException("boom");
        }

        if (stage == ManagerStage.Startup)
            OnStartup = Fail;
        else
            OnUnit = Fail;
    }

    /// <summary>Adds something to do in the next unit of work.</summary>
    internal Job Enqueue(Action action)
    {
        var job = new Job(action);
        lock (_board.Gate)
            _jobs.Enqueue(job);
        return job;
    }

    protected override void Startup()
    {
        Interlocked.Increment(ref _startups);
        OnStartup?.Invoke();
        _board.Changed();
    }

    protected override void ExecuteUnitOfWork()
    {
        lock (_board.Gate)
            _causes.Add(WakeUpCauses);
        Interlocked.Increment(ref _units);
        while (NextJob() is { } job)
        {
            job.Do();
            _board.Changed();
        }

        _board.Changed();
        OnUnit?.Invoke();
    }

    protected override void OnLateUnitOfWork(TimeSpan responseTime) => OnLate?.Invoke(responseTime);

    protected override void Shutdown()
    {
        Interlocked.Increment(ref _shutdowns);
        OnShutdown?.Invoke();
        _board.Changed();
    }

    private Job? NextJob()
    {
        lock (_board.Gate)
            return _jobs.Count == 0 ? null : _jobs.Dequeue();
    }

    /// <summary>Something that a test lets a manager do; what it throws is for the test, not for the manager.</summary>
    internal sealed class Job(Action action)
    {
        private bool _isDone;
        private ExceptionDispatchInfo? _thrown;

        public bool IsDone => Volatile.Read(ref _isDone);

        public void Do()
        {
            try
            {
                action();
            }
            catch (Exception e)
            {
                // Rethrown on the thread of the test.
                _thrown = ExceptionDispatchInfo.Capture(e);
            }

            Volatile.Write(ref _isDone, true);
        }

        public void Rethrow() => _thrown?.Throw();
    }
}
