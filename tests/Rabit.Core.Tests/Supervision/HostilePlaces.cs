using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Core.Tests.Messages;
using Rabit.Core.Tests.RealTimeKit;
using Rabit.Tests.Shared;

namespace Rabit.Core.Tests.Supervision;

/// <summary>
/// The places of a run at which the library reads the text of an exception of user code, each with a way to bring the
/// exception there. The manager of the test is "m"; <see cref="HostileExceptionTests"/> compares the list with the
/// sources.
/// </summary>
internal sealed class HostilePlaces
{
    /// <summary>What a source of a place writes on the board when it is opened.</summary>
    public const string OpenEntry = "open";

    /// <summary>Places whose fault comes from the thread of a device, at some time during the run.</summary>
    public static readonly IReadOnlyList<string> OnDeviceThread = ["reader, Open", "reader, Read", "writer, Write"];

    private static readonly HostilePlaces[] All =
    [
        new("Startup", "Supervision/ManagerFault.cs", (_, m, fail) => m.OnStartup = fail),
        new("ExecuteUnitOfWork", "Supervision/ManagerFault.cs", (_, m, fail) => m.OnUnit = Once(fail)),
        new("Shutdown", "Supervision/ManagerFault.cs", (_, m, fail) => m.OnShutdown = fail),
        new("OnLateUnitOfWork after a fault", "Managers/RabitManager.Deadline.cs", LateAfterFault),
        new("reader, Open", "Devices/DeviceActivity.cs", Reader("Open")),
        new("reader, Read", "Devices/DeviceActivity.cs", Reader("Read")),
        new("reader, Unblock", "Devices/DeviceActivity.cs", Reader("Unblock")),
        new("reader, Close", "Devices/DeviceActivity.cs", Reader("Close")),
        new("writer, Write", "Devices/DeviceActivity.cs", Writer),
        new("post handler", "Messages/SharedMessage.cs", PostHandler),
        new("post handler of a status", "Messages/SharedMessage.cs", (run, _, fail) =>
            run.Reactor.Workspace.SubscribeToStatus("m").OnPost(_ => fail())),
        new("CopyTo at a post", "Messages/SharedObject.cs", CopyTo),
        new("Dispose of a dropped value", "Queues/Discarded.cs", Dropped),
        new("callback of a hang policy", "Supervision/HangWatch.cs", HangCallback),
        new("warm-up", "RealTimeKit/RealTimeSetup.cs", (run, _, fail) => run.Reactor.Add(
            new RequestingManager("warm", new RealTimeRequest { WarmUpRuns = 1 }, fail))),
    ];

    private readonly Action<TestRun, ScriptedManager, Action> _arrange;

    private HostilePlaces(string name, string file, Action<TestRun, ScriptedManager, Action> arrange)
    {
        Name = name;
        File = file;
        _arrange = arrange;
    }

    public static IReadOnlyList<string> Names => [.. All.Select(p => p.Name)];

    public static IEnumerable<string> Files => All.Select(p => p.File);

    public string Name { get; }

    public string File { get; }

    public static void Arrange(string name, TestRun run, ScriptedManager manager, Action fail)
        => All.Single(p => p.Name == name)._arrange(run, manager, fail);

    private static Action Once(Action fail)
    {
        int calls = 0;
        return () =>
        {
            if (calls++ == 0)
                fail();
        };
    }

    private static void LateAfterFault(TestRun run, ScriptedManager manager, Action fail)
    {
        Action late = Once(fail);
        manager.UnitOfWorkDeadline = TimeSpan.FromTicks(1);
        manager.OnLate = _ => late();
        manager.OnUnit = Once(() => throw new InvalidOperationException("boom"));
    }

    private static Action<TestRun, ScriptedManager, Action> Reader(string member)
        => (run, manager, fail) => manager.AttachReader("r", new Source(run.Board, member, fail));

    private static void Writer(TestRun run, ScriptedManager manager, Action fail)
    {
        BlockingWriter<int> writer = manager.AttachWriter("w", new ScriptedTarget(run.Board) { OnWrite = _ => fail() });
        manager.OnUnit = () => writer.Push(1);
    }

    private static void PostHandler(TestRun run, ScriptedManager manager, Action fail)
    {
        MessagePublisher<int> publisher = manager.Publish<int>("number");
        run.Reactor.Workspace.Subscribe<int>("number").OnPost(_ => fail());
        manager.OnUnit = publisher.Post;
    }

    private static void CopyTo(TestRun run, ScriptedManager manager, Action fail)
    {
        MessagePublisher<TestScan> publisher = manager.Publish("scan", TestScan.Filled(1));
        manager.OnUnit = Once(() =>
        {
            publisher.Value.OnCopy = fail;
            publisher.Post();
        });
    }

    private static void Dropped(TestRun run, ScriptedManager manager, Action fail)
    {
        QueueReceiver<Value> receiver = manager.Receive<Value>(
            "values", 1, QueueFullMode.DropOldest, wakeOnPush: false);
        QueueSender<Value> sender = manager.Send<Value>("values");
        manager.OnUnit = Once(() =>
        {
            sender.Push(new Value(fail));
            sender.Push(new Value(fail));
            receiver.TryPop(out _);
        });
    }

    private static void HangCallback(TestRun run, ScriptedManager manager, Action fail)
    {
        var called = new ManualResetEventSlim();
        manager.HangPolicy = HangPolicy.Report.WithLimits(TimeSpan.FromMilliseconds(5)).AndCall(_ =>
        {
            called.Set();
            fail();
        });
        manager.OnUnit = Once(() => called.Wait(TestTimeout.Limit));
    }

    private sealed class Value(Action fail) : IDisposable
    {
        public void Dispose() => fail();
    }

    private sealed class Source(TestBoard board, string member, Action fail) : IReaderSource<int>
    {
        public bool Blocks => false;

        public void Open(ReaderContext context)
        {
            board.Write(OpenEntry);
            FailIn("Open");
        }

        public ReaderStep Read(out int value)
        {
            value = 0;
            FailIn("Read");
            return ReaderStep.WaitForSignal;
        }

        public void Unblock() => FailIn("Unblock");

        public void Close() => FailIn("Close");

        private void FailIn(string called)
        {
            if (called == member)
                fail();
        }
    }
}
