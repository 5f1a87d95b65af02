using Rabit.Core.Messages;

namespace Rabit.Core.Tests.Exploration;

/// <summary>The subscription of the library.</summary>
internal sealed class ProductionSubscription : SubscriptionUnderTest, ISubscriptions<ExploredSyncPoints>
{
    private readonly Explored _subscription = new();

    public override void Join() => _subscription.Join(this);

    public override void End() => _subscription.Dispose();

    public void Add(Subscription<ExploredSyncPoints> subscription) => AddToList();

    public void Remove(Subscription<ExploredSyncPoints> subscription) => RemoveFromList();

    protected override bool HasEnded => _subscription.HasEnded;

    private sealed class Explored : Subscription<ExploredSyncPoints>;
}
