using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Core.Tests.Diagnostics;
using Rabit.Core.Tests.Time;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Supervision;

/// <summary>
/// Contract 1.7: what no guard expects, here a clock of the user's that throws in the middle of the library's own code,
/// is in the result and ends no process; every manager shuts down.
/// </summary>
public sealed class LastResortTests : InterruptingTests
{
    public static IEnumerable<object[]> Engines()
        => from engine in new[] { WaitEngine.Event, WaitEngine.Best }
           from hostility in new[] { Hostility.Throws, Hostility.ReturnsNull, Hostility.IsHuge, Hostility.Interrupts }
           select new object[] { engine, hostility };

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "1.6")]
    [MemberData(nameof(Engines))]
    public void Manager_ClockThrowsOnItsThread_EndsWithTheFaultInTheResult(WaitEngine engine, Hostility hostility)
    {
        using TestRun run = NewRun(engine, out FailingClock clock);
        ScriptedManager bystander = run.Add("bystander");
        ScriptedManager manager = run.Add("m");
        manager.FaultPolicy = FaultPolicy.CarryOn;
        run.StartAndSettle();

        clock.FailOn("m", new HostileException(hostility));
        manager.WakeUp();
        ReactorResult result = run.FinishByItself();

        Assert.Equal((1, 1), (manager.Shutdowns, bystander.Shutdowns));
        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
        Assert.Equal(ManagerOutcome.Faulted, result.Managers[1].Outcome);
        Assert.IsType<HostileException>(Assert.Single(result.Managers[1].Faults).Exception);
        Assert.StartsWith("m ended unexpectedly in UnitOfWork: Host", result.StopReason, StringComparison.Ordinal);
        Assert.Equal((ManagerState.Faulted, 1), (result.Managers[1].Status.State, result.Managers[1].Status.Faults));
        Assert.Null(result.Failure);
        Assert.DoesNotContain("Shutdown", run.Reactor.StatusTable(), StringComparison.Ordinal);   // it has left it
        Assert.Contains(run.Log, e => e.Kind == RabitLogKind.Fault && e.Source == "m");
        Assert.Equal(1, result.ExitCode);
    }

    [Theory, Trait("Clause", "1.7")]
    [MemberData(nameof(Engines))]
    public void Manager_ClockThrowsBeforeItsStartup_EndsWithTheFaultInTheResult(WaitEngine engine, Hostility hostility)
    {
        using TestRun run = NewRun(engine, out FailingClock clock);
        run.Add("first");
        ScriptedManager manager = run.Add("m");
        clock.FailOn("m", new HostileException(hostility));

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Equal(0, manager.Units);
        Assert.Equal(manager.Startups, manager.Shutdowns - 1);   // it was up for all that is known
        Assert.IsType<HostileException>(Assert.Single(result.Managers[1].Faults).Exception);
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "1.6")]
    [MemberData(nameof(Engines))]
    public void Manager_ThatAlsoThrowsInItsShutdown_HasBothFaultsInTheResult(WaitEngine engine, Hostility hostility)
    {
        using TestRun run = NewRun(engine, out FailingClock clock);
        ScriptedManager manager = run.Add("m");
        manager.OnShutdown = () => throw new HostileException(hostility);
        run.StartAndSettle();

        clock.FailOn("m", new HostileException(hostility));
        manager.WakeUp();
        ManagerResult result = run.FinishByItself().Managers[0];

        Assert.Equal([ManagerStage.UnitOfWork, ManagerStage.Shutdown], result.Faults.Select(f => f.Stage));
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.6")]
    public void Manager_HangsInItsShutdownAfterItsClockThrew_IsNamedWithThat()
    {
        using var release = new ManualResetEventSlim();
        var clock = new FailingClock();
        using var run = new TestRun(TimeKind.Real, o =>
        {
            o.Time = new RealTime(clock);
            o.StopTimeout = TimeSpan.FromSeconds(1);   // short for the one that hangs
        });
        ScriptedManager manager = run.Add("m");
        manager.OnShutdown = () => release.Wait();
        run.StartAndSettle();

        clock.FailOn("m", new InvalidOperationException("boom"));
        manager.WakeUp();
        ReactorResult result = run.FinishByItself();
        release.Set();

        Assert.Equal("m: Shutdown", Assert.Single(result.Managers[0].NotStopped));
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.9")]
    public void Manager_ThatDelaysStopsWhenItsClockThrows_IsNotWaitedFor()
    {
        using TestRun run = NewRun(WaitEngine.Best, out FailingClock clock);
        ScriptedManager manager = run.Add("m");
        manager.DelaysStop = true;
        run.StartAndSettle();

        clock.FailOn("m", new InvalidOperationException("boom"));
        manager.WakeUp();

        Assert.Empty(run.FinishByItself().StillDelaying);
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "1.8")]
    [MemberData(nameof(Engines))]
    public void Reader_ClockThrowsOnItsThread_IsFaultedAndItsManagerIsWoken(WaitEngine engine, Hostility hostility)
    {
        using TestRun run = NewRun(engine, out FailingClock clock);
        ScriptedManager manager = run.Add("m");
        BlockingReader<int> reader = manager.AttachReader("reader", new ScriptedSource(run.Board, default)
        {
            OnRead = () =>
            {
                clock.FailOn(Thread.CurrentThread.Name!, new HostileException(hostility));
                throw new InvalidOperationException("the device is unplugged");
            },
        });

        run.Start();
        run.Until(() => manager.Causes.Any(c => (c & WakeUpCauses.Device) != 0), "the manager is woken");
        run.On(manager, () => { });
        ReactorResult result = run.Finish();

        Assert.Equal(DeviceState.Faulted, reader.State);
        Assert.IsType<HostileException>(reader.Fault);
        Assert.Equal(1, run.Board.Count("close"));
        Assert.Contains(
            run.Log, e => e.Text.StartsWith("ended unexpectedly: HostileException", StringComparison.Ordinal));
        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.8")]
    public void Writer_ClockThrowsOnItsThread_CountsAndReportsWhatIsLost()
    {
        using var isPushed = new ManualResetEventSlim();
        using TestRun run = NewRun(WaitEngine.Best, out FailingClock clock);
        ScriptedManager manager = run.Add("m");
        var target = new ScriptedTarget(run.Board)
        {
            OnWrite = _ =>
            {
                isPushed.Wait();
                clock.FailOn(Thread.CurrentThread.Name!, new InvalidOperationException("boom"));
                throw new InvalidOperationException("the device is unplugged");
            },
        };
        BlockingWriter<int> writer = manager.AttachWriter("radio", target);

        run.StartAndSettle();
        run.On(manager, () => Assert.Equal(4, Enumerable.Range(1, 4).Count(i => writer.Push(i) == PushResult.Queued)));
        isPushed.Set();
        run.Until(() => writer.State == DeviceState.Faulted && writer.Discarded > 0, "it has ended");
        run.Finish();

        Assert.Equal(4, writer.Discarded);
        Assert.Contains(
            run.Log, e => e.Source == "m/radio" && e.Text.EndsWith("were lost at the end", StringComparison.Ordinal));
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "4.5")]
    [MemberData(nameof(Engines))]
    public void Watchdog_ClockThrowsOnItsThread_FailsTheRunInOrder(WaitEngine engine, Hostility hostility)
    {
        using TestRun run = NewRun(engine, out FailingClock clock);
        ScriptedManager manager = run.Add("m");
        run.StartAndSettle();

        clock.FailOn("watchdog", new HostileException(hostility));
        ReactorResult result = run.FinishByItself();

        Assert.Equal(1, manager.Shutdowns);
        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
        Assert.IsType<HostileException>(result.Failure!.InnerException);
        Assert.StartsWith("watchdog ended unexpectedly: Host", result.StopReason, StringComparison.Ordinal);
        Assert.Equal(1, result.ExitCode);
    }

    private static TestRun NewRun(WaitEngine engine, out FailingClock clock)
    {
        FailingClock made = clock = new FailingClock();
        return new TestRun(TimeKind.Real, o =>
        {
            o.Time = new RealTime(made) { WaitEngine = engine };
            o.HangPolicy = HangPolicy.Report.WithLimits(TimeSpan.FromMinutes(1));
            o.MaxStopDelay = TestTimeout.Limit;
        });
    }

    /// <summary>The system's clock, that from a moment on throws on the threads of one name.</summary>
    private sealed class FailingClock : TimeProvider
    {
        private string? _thread;   // written by the test, read by all
        private Exception? _exception;

        public void FailOn(string thread, Exception exception)
        {
            _exception = exception;
            Volatile.Write(ref _thread, thread);
        }

        public override long TimestampFrequency => System.TimestampFrequency;

        public override long GetTimestamp()
            => Volatile.Read(ref _thread) is { } thread && Thread.CurrentThread.Name == thread
                ? throw _exception!
                : System.GetTimestamp();
    }
}
