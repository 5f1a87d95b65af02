using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.7: a manager that is stopped alone.</summary>
public abstract class StopManagerContract(TimeKind kind) : ContractTests(kind)
{
    [Theory, Trait("Clause", "1.7")]
    [InlineData(ManagerStage.Startup)]
    [InlineData(ManagerStage.UnitOfWork)]
    public void StopManager_Fault_ShutsItDownAtOnceAndTheOthersGoOn(ManagerStage stage)
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        ScriptedManager other = run.Add("other");
        faulty.FaultPolicy = FaultPolicy.StopManager;
        faulty.ThrowIn(stage);

        run.Start();
        run.Until(() => faulty.Shutdowns == 1 && run.StatusOf(faulty).State == ManagerState.Faulted, "it is stopped");
        run.OnAndSettle(other, faulty.WakeUp);
        run.OnAndSettle(other, () => { });
        ReactorResult result = run.Finish("enough");

        Assert.Equal((1, 1), (faulty.Startups, faulty.Shutdowns));
        Assert.Equal(stage == ManagerStage.Startup ? 0 : 1, faulty.Units);
        Assert.Equal("enough", result.StopReason);
        Assert.Equal(ManagerOutcome.StoppedAlone, result.Managers[0].Outcome);
        Assert.Equal(ManagerOutcome.Ended, result.Managers[1].Outcome);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("StoppedAlone", result.ToString(), StringComparison.Ordinal);
        Assert.Contains(run.Log, e => e.Source == "faulty" && e.Text == "is stopped alone; the others continue");
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "3.1")]
    public void StopManager_ItsQueueAndMessages_StayAndAreCorrect()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        ScriptedManager other = run.Add("other");
        faulty.FaultPolicy = FaultPolicy.StopManager;
        faulty.Receive<int>("inbox", capacity: 2);
        MessagePublisher<int> published = faulty.Publish<int>("height");
        MessageSubscriber<int> seen = other.Subscribe<int>("height");
        QueueSender<int> outbox = other.Send<int>("inbox");
        faulty.OnUnit = () =>
        {
            published.Value = 42;
            published.Post();
            throw new InvalidOperationException("boom");
        };

        run.Start();
        run.Until(() => faulty.Shutdowns == 1 && run.StatusOf(faulty).State == ManagerState.Faulted, "it is stopped");
        run.OnAndSettle(other, () =>
        {
            Assert.Equal(
                [PushResult.Queued, PushResult.Queued, PushResult.Rejected],
                new[] { outbox.Push(1), outbox.Push(2), outbox.Push(3) });
            seen.Fetch();
            Assert.Equal(42, seen.Value);
        });
        run.Finish();

        Assert.Equal(1, faulty.Units);
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.8")]
    public void StopManager_ItsDevices_AreStoppedWithItAndTheWriterWritesWhatIsLeft()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        faulty.FaultPolicy = FaultPolicy.StopManager;
        var target = new ScriptedTarget(run.Board);
        BlockingReader<int> reader = faulty.AttachReader(
            "in", new ScriptedSource(run.Board, TimeSpan.Zero) { AtTheEnd = ReaderStep.WaitForSignal });
        BlockingWriter<int> writer = faulty.AttachWriter("out", target);
        faulty.OnShutdown = () => writer.Push(2);
        faulty.OnUnit = () =>
        {
            if (run.Board.Count("open") < 2)
                return;
            writer.Push(1);
            throw new InvalidOperationException("boom");
        };

        run.Start();
        run.Until(() => run.Board.Count("open") == 2, "both devices are open");
        faulty.WakeUp();
        run.Until(() => reader.State == DeviceState.Stopped && writer.State == DeviceState.Stopped, "both are stopped");
        Assert.Equal([1, 2], target.Written);
        ReactorResult result = run.Finish();

        Assert.Equal(2, run.Board.Count("close"));
        Assert.Empty(result.Managers[0].NotStopped);
        Assert.Equal((0, 0), (reader.Discarded, writer.Discarded));
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.8")]
    public void StopManager_StartupThrows_ItsDevicesAreNeverOpened()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        ScriptedManager other = run.Add("other");
        faulty.FaultPolicy = FaultPolicy.StopManager;
        faulty.AttachReader("in", new ScriptedSource(run.Board, TimeSpan.Zero, 1));
        faulty.ThrowIn(ManagerStage.Startup);

        run.Start();
        run.OnAndSettle(other, () => { });
        run.Finish();

        Assert.Empty(run.Board.Entries);
    }
}

public sealed class StopManagerInRealTime() : StopManagerContract(TimeKind.Real);

public sealed class StopManagerInVirtualTime() : StopManagerContract(TimeKind.Virtual);
