namespace Rabit.Core.Tests.Exploration;

/// <summary>A subscription and the list that it is part of: those of the library, or a twin with a fault.</summary>
internal abstract class SubscriptionUnderTest
{
    // The list itself is guarded by a lock in the library: here each change of it is one step. Posters read it.
    private int _isListed;

    public abstract void Join();

    public abstract void End();

    /// <returns>Whether a post calls the handler.</returns>
    public bool Post() => default(ExploredSyncPoints).VolatileRead(ref _isListed) != 0 && !HasEnded;

    protected abstract bool HasEnded { get; }

    protected void AddToList()
    {
        default(ExploredSyncPoints).Exchange(ref _isListed, 1);
        ExploredSyncPoints.Note("listed", s =>
        {
            s.Require(s.Note(SubscriptionModel.IsListed) == 0, "it was put among the subscriptions twice");
            s.Note(SubscriptionModel.IsListed) = 1;
        });
    }

    protected void RemoveFromList()
    {
        default(ExploredSyncPoints).Exchange(ref _isListed, 0);
        ExploredSyncPoints.Note("taken out", s => s.Note(SubscriptionModel.IsListed) = 0);
    }
}
