using System;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Supervision;

/// <summary>
/// Contract 1.7: Thread.Interrupt on a thread of the library, as a library that a unit of work calls may do it, is an
/// early return of a wait.
/// </summary>
public sealed class InterruptTests : InterruptingTests
{
    [Theory, Trait("Clause", "1.7"), Trait("Clause", "1.4")]
    [InlineData(WaitEngine.Event)]
    [InlineData(WaitEngine.Best)]
    public void Interrupt_InAUnitOfWork_EndsNothingAndLosesNoWake(WaitEngine engine)
    {
        using TestRun run = NewRun(engine);
        var manager = new InterruptedManager(TimeSpan.FromHours(1));
        run.Reactor.Add(manager);
        run.Start();

        for (int i = 1; i <= 20; i++)
        {
            int units = i;
            run.Until(() => manager.Units >= units, "the wake is seen");
            manager.WakeUp();
        }

        ReactorResult result = run.Finish();

        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
        Assert.Equal((1, 0), (manager.Shutdowns, result.ExitCode));
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "1.3")]
    [InlineData(WaitEngine.Event)]
    [InlineData(WaitEngine.Best)]
    public void Interrupt_WithATimer_RunsNoUnitEarly(WaitEngine engine)
    {
        using TestRun run = NewRun(engine);
        var manager = new InterruptedManager(TimeSpan.FromMilliseconds(30));
        run.Reactor.Add(manager);

        run.Start();
        run.Until(() => manager.Units >= 5, "the timer wakes it");
        ReactorResult result = run.Finish();

        Assert.True(manager.MinSleep >= TimeSpan.FromMilliseconds(30), $"{manager.MinSleep}");
        Assert.Equal((1, 0), (manager.Shutdowns, result.ExitCode));
    }

    [Theory, Trait("Clause", "1.7")]
    [InlineData(WaitEngine.Event)]
    [InlineData(WaitEngine.Best)]
    public void Interrupt_InStartupAndShutdown_EndsNothing(WaitEngine engine)
    {
        using TestRun run = NewRun(engine);
        var manager = new InterruptedAtItsEnds();
        run.Reactor.Add(manager);

        run.Start();
        run.Until(() => manager.Units >= 1, "it starts up and works");
        ReactorResult result = run.Finish();

        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "1.8")]
    [InlineData(WaitEngine.Event)]
    [InlineData(WaitEngine.Best)]
    public void Interrupt_InAReader_EndsNothing(WaitEngine engine)
    {
        using TestRun run = NewRun(engine);
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, default)
        {
            OnRead = () => Thread.CurrentThread.Interrupt(),
            AtTheEnd = ReaderStep.WaitForSignal,
        };
        BlockingReader<int> reader = manager.AttachReader("r", source);

        run.StartAndSettle();
        run.Until(() => run.Board.Count("open") == 1, "the source is open");
        source.Add(7);
        int popped = 0;
        run.Until(
            () =>
            {
                run.On(manager, () => popped += reader.TryPop(out int value) ? value : 0);
                return popped == 7;
            },
            "the value comes");
        ReactorResult result = run.Finish();

        Assert.Equal(0, reader.Faults);
        Assert.Equal(0, result.ExitCode);
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "4.3")]
    public void Interrupt_OfTheReactorsThread_IsNoStop()
    {
        using TestRun run = NewRun(WaitEngine.Best);
        ScriptedManager manager = run.Add("m");
        run.StartAndSettle();
        ReactorResult? result = null;
        var thread = new Thread(() => result = run.FinishByItself());
        thread.Start();

        thread.Interrupt();
        run.On(manager, () => { });
        run.Reactor.Stop("enough");

        Assert.True(thread.Join(TestTimeout.Limit));
        Assert.Equal(("enough", 0), (result!.StopReason, result.ExitCode));
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "5.1")]
    public void Interrupt_InVirtualTimeThatIsHeldBack_EndsNothing()
    {
        using var run = new TestRun(TimeKind.Virtual, o => o.Time = new VirtualTime { Pace = 10 });
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(100);
        manager.OnUnit = () => Thread.CurrentThread.Interrupt();

        run.Start();
        Assert.True(run.Reactor.RunFor(TimeSpan.FromMilliseconds(500)));
        manager.OnUnit = null;
        ReactorResult result = run.Finish();

        Assert.Equal(6, manager.Units);
        Assert.Equal(0, result.ExitCode);
    }

    private static TestRun NewRun(WaitEngine engine)
        => new(TimeKind.Real, o => o.Time = new RealTime { WaitEngine = engine });

    /// <summary>
    /// Interrupts its own thread in each unit of work. It takes no lock: the interrupt is for the wait of the library.
    /// </summary>
    private sealed class InterruptedManager : RabitManager
    {
        private int _units;
        private int _shutdowns;
        private TimeSpan? _ended;

        public InterruptedManager(TimeSpan delay)
            : base("interrupted") => WakeUpDelay = delay;

        public int Units => Volatile.Read(ref _units);

        public int Shutdowns => Volatile.Read(ref _shutdowns);

        public TimeSpan MinSleep { get; private set; } = TimeSpan.MaxValue;

        protected override void ExecuteUnitOfWork()
        {
            if (_ended is { } ended && Now - ended < MinSleep)
                MinSleep = Now - ended;
            Interlocked.Increment(ref _units);
            _ended = Now;
            Thread.CurrentThread.Interrupt();
        }

        protected override void Shutdown() => Interlocked.Increment(ref _shutdowns);
    }

    /// <summary>Interrupts its own thread as the last thing in its start-up and its shutdown; takes no lock.</summary>
    private sealed class InterruptedAtItsEnds() : RabitManager("interrupted")
    {
        private int _units;

        public int Units => Volatile.Read(ref _units);

        protected override void Startup() => Thread.CurrentThread.Interrupt();

        protected override void ExecuteUnitOfWork() => Interlocked.Increment(ref _units);

        protected override void Shutdown() => Thread.CurrentThread.Interrupt();
    }
}
