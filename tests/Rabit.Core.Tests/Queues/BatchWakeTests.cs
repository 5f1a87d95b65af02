using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Queues;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Queues;

/// <summary>Contract 3.2: a batch wakes its receiver once, also one that runs at once at every wake.</summary>
public sealed class BatchWakeTests
{
    public static IEnumerable<object[]> Kinds()
        =>
        [
            [QueueKinds.Pair], [QueueKinds.Ring], [QueueKinds.Rejects], [QueueKinds.DropsOldest],
            [QueueKinds.DropsNewest], [QueueKinds.Waits],
        ];

    [Theory, Trait("Clause", "3.2")]
    [MemberData(nameof(Kinds))]
    public void PushFrom_PlainValues_WakesTheReceiverOnce(string kind)
        => Assert.Equal(1, CountWakes(kind, Enumerable.Range(0, 20).ToArray()));

    [Theory, Trait("Clause", "3.2")]
    [MemberData(nameof(Kinds))]
    public void PushFrom_DisposableValues_WakesTheReceiverOnce(string kind)
        => Assert.Equal(1, CountWakes(kind, Enumerable.Range(0, 20).Select(_ => new Picture(null)).ToArray()));

    [Theory, Trait("Clause", "3.1")]
    [InlineData(QueueKinds.DropsOldest, new[] { 0, 1, 2, 3, 4, 5, 6 }, new[] { 7, 8, 9 })]
    [InlineData(QueueKinds.DropsNewest, new[] { 2, 3, 4, 5, 6, 7, 8 }, new[] { 0, 1, 9 })]
    public void PushFrom_DisposableValuesThatDrop_DisposesThemInOrderOutsideTheLock(
        string kind, int[] disposed, int[] left)
    {
        var seen = new List<int>();
        MessageQueue<Picture, SyncPoints> queue = QueueKinds.Create<Picture>(kind, capacity: 3, new WakeUpEvent());
        Picture[] all = new Picture[10];
        for (int i = 0; i < all.Length; i++)
        {
            int number = i;
            all[i] = new Picture(() =>
            {
                // On another thread: a lock that is held may let its holder in again.
                QueueCounters counters = default;
                var asker = new Thread(() => counters = queue.Counters);
                asker.Start();
                Assert.True(asker.Join(TestTimeout.Limit));
                Assert.Equal(3, counters.Resident);
                seen.Add(number);
            });
        }

        queue.Push(all[0]);
        queue.Push(all[1]);
        Assert.Equal(8, queue.PushFrom(all.AsSpan(2)));

        Assert.Equal(disposed, seen);
        Assert.Equal(
            new QueueCounters(pushed: 10, popped: 0, dropped: 7, rejected: 0, resident: 3, highWater: 3, capacity: 3),
            queue.Counters);
        foreach (int number in left)
        {
            Assert.True(queue.TryPop(out Picture? picture));
            Assert.Same(all[number], picture);
        }
    }

    [Fact, Trait("Clause", "3.5")]
    public void PushFrom_DisposableValuesWhoseDisposalClosesTheQueue_RejectsTheRest()
    {
        MessageQueue<Picture, SyncPoints> queue = QueueKinds.Create<Picture>(
            QueueKinds.DropsOldest, capacity: 2, new WakeUpEvent());
        Picture[] all = [new(queue.Close), new(null), new(null), new(null), new(null)];

        Assert.Equal(3, queue.PushFrom(all));

        Assert.Equal(
            new QueueCounters(pushed: 3, popped: 0, dropped: 1, rejected: 2, resident: 2, highWater: 2, capacity: 2),
            queue.Counters);
    }

    private static int CountWakes<T>(string kind, T[] values)
    {
        var receiver = new WakeUpEvent();
        var signal = new EagerSleeper(receiver);
        receiver.Connect(signal, new RunClock(TimeProvider.System));
        Assert.True(receiver.TryPrepareToWait(WakeUpEvent.Any));
        MessageQueue<T, SyncPoints> queue = QueueKinds.Create<T>(kind, capacity: 8, receiver);
        queue.PushFrom(values);
        return signal.Wakes;
    }

    private sealed class Picture(Action? onDispose) : IDisposable
    {
        public void Dispose() => onDispose?.Invoke();
    }

    /// <summary>A receiver that is woken, takes its wake-ups and sleeps again within the call of the sender.</summary>
    private sealed class EagerSleeper(WakeUpEvent sleeper) : IWakeSignal
    {
        public int Wakes { get; private set; }

        public void Set()
        {
            Wakes++;
            sleeper.Consume();
            Assert.True(sleeper.TryPrepareToWait(WakeUpEvent.Any));
        }
    }
}
