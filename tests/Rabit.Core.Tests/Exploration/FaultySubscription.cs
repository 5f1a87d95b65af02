namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// A small subscription, into which a fault can be put. Only for the explorer to find: nothing else uses it.
/// </summary>
internal sealed class FaultySubscription(SeededSubscriptionFault fault) : SubscriptionUnderTest
{
    private const int Joined = 1;
    private const int Ended = 2;

    private int _state;

    private static ExploredSyncPoints Sync => default;

    protected override bool HasEnded
        => fault != SeededSubscriptionFault.PostersDoNotAsk && Sync.VolatileRead(ref _state) == Ended;

    public override void Join()
    {
        if (fault != SeededSubscriptionFault.JoinedBeforeItIsListed)
            AddToList();
        bool hasEnded = HasEndedBefore();
        if (fault == SeededSubscriptionFault.JoinedBeforeItIsListed && !hasEnded)
            AddToList();
        else if (hasEnded && fault != SeededSubscriptionFault.EndedStaysListed)
            RemoveFromList();
    }

    public override void End()
    {
        int before;
        if (fault == SeededSubscriptionFault.EndWithoutAnExchange)
        {
            before = Sync.VolatileRead(ref _state);
            Sync.VolatileWrite(ref _state, Ended);
        }
        else
        {
            before = Sync.Exchange(ref _state, Ended);
        }

        if (before == Joined)
            RemoveFromList();
    }

    // Marks it as joined, unless it has ended.
    private bool HasEndedBefore()
    {
        if (fault != SeededSubscriptionFault.JoinWithoutASwap)
            return Sync.CompareExchange(ref _state, Joined, 0) == Ended;
        if (Sync.VolatileRead(ref _state) == Ended)
            return true;
        Sync.VolatileWrite(ref _state, Joined);
        return false;
    }
}
