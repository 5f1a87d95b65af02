using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 3.2: what a push and a pop wake.</summary>
public abstract class QueueEventContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "3.2")]
    public void PushEvent_RejectedPush_DoesNotWake()
    {
        using QueuePair pair = Connect(capacity: 1, QueueFullMode.Reject, wakeOnPush: true);
        pair.Run.On(pair.Source, () => pair.Sender.Push(1));
        pair.Run.Until(() => pair.Run.StatusOf(pair.Sink).Runs == 2, "the push wakes the sink");
        pair.Run.OnAndSettle(pair.Source, () => Assert.Equal(PushResult.Rejected, pair.Sender.Push(2)));
        pair.Run.OnAndSettle(pair.Sink, () => { });

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Push, WakeUpCauses.Request], pair.Sink.Causes);
    }

    [Fact, Trait("Clause", "3.2")]
    public void PushEvent_PushThatDropsTheOldest_Wakes()
    {
        using QueuePair pair = Connect(capacity: 1, QueueFullMode.DropOldest, wakeOnPush: true);
        pair.Run.On(pair.Source, () => pair.Sender.Push(1));
        pair.Run.Until(() => pair.Run.StatusOf(pair.Sink).Runs == 2, "the push wakes the sink");
        pair.Run.On(pair.Source, () => Assert.Equal(PushResult.QueuedDroppedOldest, pair.Sender.Push(2)));
        pair.Run.Until(() => pair.Sink.Units == 3, "the second push wakes it too");

        Assert.Equal(WakeUpCauses.Push, pair.Sink.Causes[2]);
    }

    [Fact, Trait("Clause", "3.2")]
    public void PopEvent_EmptyPop_DoesNotWake()
    {
        using QueuePair pair = Connect(capacity: 1, QueueFullMode.Reject, wakeOnPop: true);
        pair.Run.OnAndSettle(pair.Sink, () => Assert.False(pair.Receiver.TryPop(out _)));
        pair.Run.OnAndSettle(pair.Source, () => { });

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request], pair.Source.Causes);
    }

    [Fact, Trait("Clause", "3.2")]
    public void PopEvent_DroppedOldest_DoesNotWake()
    {
        using QueuePair pair = Connect(capacity: 1, QueueFullMode.DropOldest, wakeOnPop: true);
        pair.Run.OnAndSettle(pair.Source, () => pair.Sender.PushFrom([1, 2, 3]));
        pair.Run.OnAndSettle(pair.Source, () => { });

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request, WakeUpCauses.Request], pair.Source.Causes);
    }

    private QueuePair Connect(int capacity, QueueFullMode whenFull, bool wakeOnPush = false, bool wakeOnPop = false)
        => new(NewRun(), capacity, whenFull, wakeOnPush, wakeOnPop);
}

public sealed class QueueEventInRealTime() : QueueEventContract(TimeKind.Real);

public sealed class QueueEventInVirtualTime() : QueueEventContract(TimeKind.Virtual);
