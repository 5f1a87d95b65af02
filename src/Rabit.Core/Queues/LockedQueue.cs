using System;
using System.Diagnostics.CodeAnalysis;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Locks;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <summary>
/// The queue for every rule and every endpoint: a ring under a lock. Wakes go out, and what was dropped is disposed,
/// after the lock is released.
/// </summary>
/// <remarks>
/// A push checks inside the lock whether a wake is pending, and skips its own if so. No wake is lost by that: the
/// receiver takes its wake-ups before it pops. Had it popped in a section of the lock before ours, its take would have
/// come before our check, and we would not have seen the old wake; so its next pop comes in a section after ours and
/// sees the value.
/// </remarks>
internal sealed partial class LockedQueue<T>(
    string name, int capacity, QueueFullMode fullMode, WakeUpEvent? receiverWakeUp, TimeSpan? maxWait, RunClock clock,
    RabitLog log, bool inheritsPriority = false)
    : MessageQueue<T, SyncPoints>(name, capacity, fullMode, receiverWakeUp, maxWait)
{
    private readonly EndpointLock _gate = new(inheritsPriority);
    private readonly T[] _ring = new T[capacity];

    // All under _gate.
    private int _head;
    private int _count;
    private int _highWater;
    private long _pushed;
    private long _popped;
    private long _dropped;
    private long _rejected;
    private bool _isClosed;

    /// <summary>Whether its lock does so.</summary>
    public bool InheritsPriority => _gate.InheritsPriority;

    public override int Count
    {
        get
        {
            using (_gate.Enter())
                return _count;
        }
    }

    public override QueueCounters Counters
    {
        get
        {
            using (_gate.Enter())
                return new QueueCounters(_pushed, _popped, _dropped, _rejected, _count, _highWater, Capacity);
        }
    }

    public override PushResult Push(in T value)
    {
        if (Discarded<T>.Matters)
            return PushAndDispose(value);
        PushResult result;
        var announcement = default(Announcement);
        using (_gate.Enter())
            result = Admit(value, ref announcement);
        Announce(announcement);
        return result;
    }

    public override int PushFrom(ReadOnlySpan<T> values)
    {
        if (Discarded<T>.Matters)
            return PushAndDispose(values);
        int pushed = 0;
        var announcement = default(Announcement);
        using (_gate.Enter())
        {
            while (pushed < values.Length && Admit(values[pushed], ref announcement) != PushResult.Rejected)
                pushed++;
            if (pushed < values.Length)
                _rejected += values.Length - pushed - 1;
        }

        Announce(announcement);
        return pushed;
    }

    public override bool TryPop([MaybeNullWhen(false)] out T value)
    {
        bool serves;
        using (_gate.Enter())
        {
            if (_count == 0)
            {
                value = default;
                return false;
            }

            value = TakeOut();
            _popped++;
            serves = _hasWaiters;
        }

        if (serves)
            ServeWaiting();
        if (WakesSenders)
            WakeSenders();
        return true;
    }

    public override int PopInto(Span<T> target)
    {
        int popped = 0;
        bool serves;
        using (_gate.Enter())
        {
            serves = _hasWaiters;
            while (!serves && popped < target.Length && _count > 0)
                target[popped++] = TakeOut();
            _popped += popped;
        }

        // Each of those who wait is served by a pop.
        while (serves && popped < target.Length && TryPop(out T? value))
            target[popped++] = value;
        if (popped > 0 && WakesSenders)
            WakeSenders();
        return popped;
    }

    /// <summary>Releases all waiters, and rejects all later pushes.</summary>
    public override void Close() => EndWaiting();

    /// <inheritdoc/>
    public override void DisposeRest()
    {
        while (Discarded<T>.Matters && TryDropOldest(out T value))
            Discarded<T>.Dispose(value, Name, log);
    }

    private bool TryDropOldest(out T value)
    {
        using (_gate.Enter())
        {
            if (_count == 0)
            {
                value = default!;
                return false;
            }

            value = TakeOut();
            _dropped++;
            return true;
        }
    }

    // Apart from Push, which for all other types needs no room for what was dropped.
    private PushResult PushAndDispose(in T value)
    {
        PushResult result;
        T dropped = default!;
        var announcement = default(Announcement);
        using (_gate.Enter())
            result = Admit(value, ref announcement, ref dropped);

        Announce(announcement);
        if (result is PushResult.QueuedDroppedOldest or PushResult.QueuedDroppedNewest)
            Discarded<T>.Dispose(dropped, Name, log);
        return result;
    }

    // Leaves the lock for each value that is dropped, and announces at the end: a receiver that ran at each would do so
    // once for each value. One that sleeps sleeps until then.
    private int PushAndDispose(ReadOnlySpan<T> values)
    {
        int pushed = 0;
        AsyncWaiters? waiters = null;
        var announcement = default(Announcement);
        PushResult result = PushResult.Queued;
        while (pushed < values.Length && result != PushResult.Rejected)
        {
            T dropped = default!;
            announcement.News = null;
            using (_gate.Enter())
            {
                do
                    result = Admit(values[pushed], ref announcement, ref dropped);
                while (result == PushResult.Queued && ++pushed < values.Length);
                if (result == PushResult.Rejected)
                    _rejected += values.Length - pushed - 1;
            }

            // There are others only where the receiver has emptied the queue meanwhile, and waits again.
            if (announcement.News is not null)
                waiters?.Release(true);
            waiters = announcement.News ?? waiters;
            if (result is PushResult.Queued or PushResult.Rejected)
                continue;
            pushed++;
            Discarded<T>.Dispose(dropped, Name, log);
        }

        announcement.News = waiters;
        Announce(announcement);
        return pushed;
    }

    /// <param name="value">The value.</param>
    /// <param name="announcement">What is to be sent for it.</param>
    /// <param name="dropped">What would be, or was, dropped for it.</param>
    private PushResult Admit(in T value, ref Announcement announcement, ref T dropped)
    {
        if (_count == _ring.Length)
            dropped = _ring[FullMode == QueueFullMode.DropOldest ? _head : Place(_count - 1)];
        return Admit(value, ref announcement);
    }

    private PushResult Admit(in T value, ref Announcement announcement)
    {
        PushResult result = PushResult.Queued;
        if (_count == _ring.Length || _isClosed || _pending is not null)
        {
            result = MakeRoom();
            if (result == PushResult.Rejected)
                return result;
        }

        PutIn(value, ref announcement);
        return result;
    }

    // By the rule for a full queue.
    private PushResult MakeRoom()
    {
        switch (FullMode)
        {
            case QueueFullMode.DropOldest when !_isClosed:
                RemoveOldest();
                _dropped++;
                return PushResult.QueuedDroppedOldest;
            case QueueFullMode.DropNewest when !_isClosed:
                // The value goes into its place.
                _count--;
                _dropped++;
                return PushResult.QueuedDroppedNewest;
            default:
                _rejected++;
                return PushResult.Rejected;
        }
    }

    private void PutIn(in T value, ref Announcement announcement)
    {
        _ring[Place(_count)] = value;
        if (++_count > _highWater)
            _highWater = _count;
        _pushed++;
        announcement.WakesReceiver = ReceiverWakeUp is not null && !IsPending(ReceiverWakeUp, WakeUpCauses.Push);
        if (_news is not null)
            announcement.News = TakeNews();
    }

    // Outside the lock.
    private void Announce(in Announcement announcement)
    {
        if (announcement.WakesReceiver)
            ReceiverWakeUp!.Wake(WakeUpCauses.Push);
        announcement.News?.Release(true);
    }

    private int Place(int index)
    {
        int place = _head + index;
        return place < _ring.Length ? place : place - _ring.Length;
    }

    private T TakeOut()
    {
        T value = _ring[_head];
        RemoveOldest();
        return value;
    }

    private void RemoveOldest()
    {
        _ring[_head] = default!;
        if (++_head == _ring.Length)
            _head = 0;
        _count--;
    }

    /// <summary>The notifications of a push, sent after it has left the lock.</summary>
    private struct Announcement
    {
        public bool WakesReceiver;
        public AsyncWaiters? News;
    }
}
