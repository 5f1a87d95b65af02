using System;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Messages;

/// <summary>
/// Whether a subscription is part of a message. It joins once; it may end before that, meanwhile, while posts go on,
/// and more than once at a time, on any threads.
/// </summary>
/// <remarks>
/// The race it closes: it ends while it joins. It is put among the message's subscriptions first and marked as joined
/// then, by a compare-and-swap; the end is an exchange. So either the end finds it joined and takes it out, or the join
/// finds it ended and does. Until it is out posters see that it has ended. The tests explore every interleaving of this
/// very code (docs/concepts/proof.md).
/// </remarks>
internal abstract class Subscription<TSync> : IDisposable
    where TSync : struct, ISyncPoints
{
    private const int Joined = 1;
    private const int Ended = 2;

    private int _state;                       // 0: neither
    private ISubscriptions<TSync>? _message;  // written before it joins, read by the end that finds it joined

    /// <summary>Asked by posters.</summary>
    public bool HasEnded => default(TSync).VolatileRead(ref _state) == Ended;

    /// <summary>Makes it part of a message, unless it has ended.</summary>
    public void Join(ISubscriptions<TSync> message)
    {
        _message = message;
        message.Add(this);
        if (default(TSync).CompareExchange(ref _state, Joined, 0) == Ended)
            message.Remove(this);
    }

    public void Dispose()
    {
        if (default(TSync).Exchange(ref _state, Ended) == Joined)
            _message!.Remove(this);
    }
}
