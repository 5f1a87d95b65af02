using System;
using System.Collections.Concurrent;
using System.Threading;
using System.Threading.Channels;

namespace Rabit.Latency.Throughput;

/// <summary>The queues of others, as pairs of ends.</summary>
internal static class BaselineQueues
{
    public readonly struct Concurrent<T>(ConcurrentQueue<T> queue) : IPush<T>, IPop<T>
    {
        public bool TryPush(in T value)
        {
            queue.Enqueue(value);
            return true;
        }

        public bool TryPop(out T value) => queue.TryDequeue(out value!);
    }

    public readonly struct Blocking<T>(BlockingCollection<T> queue) : IPush<T>, IPop<T>
    {
        public bool TryPush(in T value) => queue.TryAdd(value);

        public bool TryPop(out T value) => queue.TryTake(out value!);
    }

    public readonly struct ChannelEnds<T>(Channel<T> channel) : IPush<T>, IPop<T>
    {
        public bool TryPush(in T value) => channel.Writer.TryWrite(value);

        public bool TryPop(out T value) => channel.Reader.TryRead(out value!);
    }

    /// <summary>A ring under a lock.</summary>
    public readonly struct Locked<T>(LockedRing<T> ring) : IPush<T>, IPop<T>
    {
        public bool TryPush(in T value) => ring.TryPush(value);

        public bool TryPop(out T value) => ring.TryPop(out value);
    }

    public readonly struct Multi<T>(MpscRing<T> ring) : IPush<T>, IPop<T>
    {
        public bool TryPush(in T value) => ring.TryPush(value);

        public bool TryPop(out T value) => ring.TryPop(out value);
    }

    public readonly struct Sequenced<T>(SequencedSpscRing<T> ring) : IPush<T>, IPop<T>
    {
        public bool TryPush(in T value) => ring.TryPush(value);

        public bool TryPop(out T value) => ring.TryPop(out value);
    }

    public readonly struct Single<T>(SpscRing<T> ring) : IPush<T>, IPop<T>, IPushBatch<T>, IPopBatch<T>
    {
        public bool TryPush(in T value) => ring.TryPush(value);

        public bool TryPop(out T value) => ring.TryPop(out value);

        public int PushFrom(ReadOnlySpan<T> values) => ring.PushFrom(values);

        public int PopInto(Span<T> target) => ring.PopInto(target);
    }
}
