using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Queues;

/// <summary>
/// Contract 3.5 with real threads: senders that go on while the run ends, and the counters that it reports.
/// </summary>
[Trait("Category", "Stress")]
public sealed class QueueCloseStressTests
{
    private static TimeSpan MaxWait => TestTimeout.Limit + TestTimeout.Limit;

    public static IEnumerable<object[]> Kinds()
        =>
        [
            [QueueKinds.Pair], [QueueKinds.Ring], [QueueKinds.Rejects], [QueueKinds.DropsOldest],
            [QueueKinds.DropsNewest],
        ];

    [Theory, Trait("Clause", "3.5")]
    [MemberData(nameof(Kinds))]
    public void Close_SendersFlatOut_EveryPushIsRejectedOrInTheCounters(string kind)
    {
        for (int round = 0; round < 40; round++)
        {
            MessageQueue<int, SyncPoints> queue = QueueKinds.Create<int>(
                kind, capacity: 1 << 16, new WakeUpEvent(), start: -100);
            int senders = kind == QueueKinds.Pair ? 1 : 2;
            long[] accepted = new long[senders];
            using var begun = new CountdownEvent(senders);
            var hasEnded = new ManualResetEventSlim();
            Thread[] threads = [.. Enumerable.Range(0, senders).Select(s => new Thread(() =>
            {
                begun.Signal();
                while (!hasEnded.IsSet)
                {
                    if (queue.Push(1) != PushResult.Rejected)
                        accepted[s]++;
                }
            }))];
            foreach (Thread thread in threads)
                thread.Start();
            Assert.True(begun.Wait(MaxWait));
            Thread.SpinWait(50 * (round % 20));

            queue.Close();
            QueueCounters reported = queue.Counters;
            hasEnded.Set();
            Assert.All(threads, thread => Assert.True(thread.Join(MaxWait)));

            Assert.Equal(accepted.Sum(), reported.Pushed);
            Assert.Equal(reported.Pushed, queue.Counters.Pushed);
        }
    }

    [Theory, Trait("Clause", "3.5")]
    [InlineData(QueueFullMode.Reject)]
    [InlineData(QueueFullMode.DropOldest)]
    public void Run_OutsideSenderThatGoesOn_EveryPushIsRejectedOrInTheResult(QueueFullMode whenFull)
    {
        for (int round = 0; round < 30; round++)
        {
            var receiver = new Receiver(whenFull);
            var reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false }) { receiver };
            QueueSender<int> sender = reactor.Workspace.Send<int>("numbers");
            long accepted = 0;
            bool hasEnded = false;
            reactor.Start();
            var thread = new Thread(() =>
            {
                while (!Volatile.Read(ref hasEnded))
                {
                    if (sender.Push(1) != PushResult.Rejected)
                        accepted++;
                }
            });
            thread.Start();
            Assert.True(receiver.HasWorked.Wait(MaxWait));

            reactor.Stop();
            QueueCounters reported = reactor.Finish().Queues.Single(q => q.Name == "numbers").Counters;
            Volatile.Write(ref hasEnded, true);
            Assert.True(thread.Join(MaxWait));

            Assert.Equal(accepted, reported.Popped + reported.Dropped + reported.Resident);
            Assert.Equal(receiver.Popped, reported.Popped);
        }
    }

    private sealed class Receiver : RabitManager
    {
        private readonly QueueReceiver<int> _numbers;

        public Receiver(QueueFullMode whenFull)
            : base("receiver") => _numbers = Receive<int>("numbers", 1000, whenFull);

        public ManualResetEventSlim HasWorked { get; } = new();

        public long Popped { get; private set; }

        // Not for ever: a sender that is never slower than the receiver would keep it in its unit of work.
        protected override void ExecuteUnitOfWork()
        {
            for (int i = 0; i < 1000 && _numbers.TryPop(out _); i++)
                Popped++;
            if (Popped > 0)
                HasWorked.Set();
        }
    }
}
