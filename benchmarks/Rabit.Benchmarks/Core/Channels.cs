using System.Threading.Channels;

namespace Rabit.Benchmarks.Core;

/// <summary>The channels that messages and queues are compared with.</summary>
internal static class Channels
{
    /// <summary>The nearest to a publish-subscribe message: room for one, a new value replaces it.</summary>
    public static Channel<T> LatestValue<T>()
        => Channel.CreateBounded<T>(new BoundedChannelOptions(1) { FullMode = BoundedChannelFullMode.DropOldest });

    /// <summary>The nearest to a message queue: bounded, one reader.</summary>
    public static Channel<T> Queue<T>(int capacity, int senders = 1)
        => Channel.CreateBounded<T>(
            new BoundedChannelOptions(capacity) { SingleReader = true, SingleWriter = senders == 1 });
}
