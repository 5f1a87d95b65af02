using System.Collections.Concurrent;
using System.Threading.Channels;
using System.Threading.Tasks;

namespace Rabit.Latency.Throughput;

/// <summary>The queues of others whose receiver sleeps while there is nothing, as pairs of ends.</summary>
internal static class WakingQueues
{
    /// <summary>A ring that wakes its receiver where it sleeps: the limit.</summary>
    public readonly struct Ring<TEnds, T>(TEnds ring, RingWaker waker) : IPush<T>, IPopWaiting<T>
        where TEnds : struct, IPush<T>, IPop<T>
    {
        public bool TryPush(in T value)
        {
            TEnds end = ring;
            if (!end.TryPush(value))
                return false;
            waker.AfterPush();
            return true;
        }

        public T Pop()
        {
            TEnds end = ring;
            T value;
            while (!end.TryPop(out value))
            {
                waker.Announce();
                if (end.TryPop(out value))
                {
                    waker.Withdraw();
                    break;
                }

                waker.Wait();
            }

            return value;
        }
    }

    /// <summary>A ring under a lock, with Wait and Pulse.</summary>
    public readonly struct Locked<T>(LockedRing<T> ring) : IPush<T>, IPopWaiting<T>
    {
        public bool TryPush(in T value) => ring.TryPush(value);

        public T Pop() => ring.Pop();
    }

    public readonly struct Blocking<T>(BlockingCollection<T> queue) : IPush<T>, IPopWaiting<T>
    {
        public bool TryPush(in T value) => queue.TryAdd(value);

        public T Pop() => queue.Take();
    }

    /// <summary>A channel whose reader is a thread.</summary>
    public readonly struct ChannelEnds<T>(Channel<T> channel) : IPush<T>, IPopWaiting<T>
    {
        public bool TryPush(in T value) => channel.Writer.TryWrite(value);

        public T Pop()
        {
            T? value;
            while (!channel.Reader.TryRead(out value))
            {
                ValueTask<bool> came = channel.Reader.WaitToReadAsync();
                if (!came.IsCompleted)
                    came.AsTask().Wait();
            }

            return value;
        }
    }
}
