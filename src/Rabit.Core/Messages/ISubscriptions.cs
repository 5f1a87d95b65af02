using Rabit.Core.WakeUp;

namespace Rabit.Core.Messages;

/// <summary>The subscriptions of a message. Any thread; each call is done, for all, when it returns.</summary>
internal interface ISubscriptions<TSync>
    where TSync : struct, ISyncPoints
{
    void Add(Subscription<TSync> subscription);

    void Remove(Subscription<TSync> subscription);
}
