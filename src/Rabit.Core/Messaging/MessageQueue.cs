using System.Diagnostics.CodeAnalysis;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;

namespace Rabit.Core.Messaging;

/// <summary>
/// A bounded first-in first-out queue: many senders, one receiver, a ring under a lock. Wakes go out, and what was dropped is disposed,
/// after the lock is released.
/// </summary>
internal sealed class MessageQueue<T>(string name, int capacity, QueueFullMode fullMode, WakeUpEvent? receiverWakeUp, RabitLog log)
    : IMessageQueue
{
    private readonly object _gate = new();
    private readonly T[] _ring = new T[capacity];

    // All under _gate.
    private int _head;
    private int _count;
    private long _pushed;
    private long _popped;
    private long _dropped;
    private long _rejected;
    private WakeUpEvent? _waitingSender;
    private bool _isClosed;

    private WakeUpEvent[] _popTargets = [];   // written while wiring, then read only

    public string Name { get; } = name;

    public QueueFullMode FullMode { get; } = fullMode;

    public int Capacity => _ring.Length;

    public int Count
    {
        get
        {
            lock (_gate)
                return _count;
        }
    }

    public QueueCounters Counters
    {
        get
        {
            lock (_gate)
                return new QueueCounters(_pushed, _popped, _dropped, _rejected, _count, _ring.Length);
        }
    }

    public void AddPopTarget(WakeUpEvent sender) => _popTargets = [.. _popTargets, sender];

    public PushResult Push(in T value)
    {
        if (Discarded<T>.Matters)
            return PushAndDispose(value);
        PushResult result;
        lock (_gate)
        {
            result = _count < _ring.Length ? PushResult.Queued : WhenFull();
            if (result != PushResult.Rejected)
                PutIn(value);
        }

        if (result != PushResult.Rejected)
            receiverWakeUp?.Wake(WakeUpCauses.Push);
        return result;
    }

    /// <summary>Puts a value in, or notes who waits for room: the next pop wakes it. Nothing is counted as rejected.</summary>
    public bool TryPushOrWait(in T value, WakeUpEvent sender)
    {
        lock (_gate)
        {
            if (_count == _ring.Length || _isClosed)
            {
                // One reader feeds one queue, so there is never a second sender to remember.
                _waitingSender = sender;
                return false;
            }

            PutIn(value);
        }

        receiverWakeUp?.Wake(WakeUpCauses.Push);
        return true;
    }

    public bool TryPop([MaybeNullWhen(false)] out T value)
    {
        WakeUpEvent? waiting;
        lock (_gate)
        {
            if (_count == 0)
            {
                value = default;
                return false;
            }

            value = TakeOut();
            _popped++;
            waiting = _waitingSender;
            _waitingSender = null;
        }

        waiting?.Wake(WakeUpCauses.Pop);
        foreach (WakeUpEvent sender in _popTargets)
            sender.Wake(WakeUpCauses.Pop);
        return true;
    }

    /// <summary>Disposes what is left, if it can be disposed, and takes nothing more of that kind: a push is rejected.</summary>
    public void Close()
    {
        if (!Discarded<T>.Matters)
            return;
        while (TryDropOldest(out T value))
            Discarded<T>.Dispose(value, Name, log);
    }

    private bool TryDropOldest(out T value)
    {
        lock (_gate)
        {
            _isClosed = true;
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

    // Apart from Push, which for all other types needs neither room for what was dropped nor the mark.
    private PushResult PushAndDispose(in T value)
    {
        PushResult result = PushResult.Queued;
        T dropped = default!;
        lock (_gate)
        {
            if (_count == _ring.Length && FullMode == QueueFullMode.DropOldest)
            {
                dropped = TakeOut();
                _dropped++;
                result = PushResult.QueuedDroppedOldest;
            }

            if (_isClosed || _count == _ring.Length)
                result = Reject();
            else
                PutIn(value);
        }

        if (result != PushResult.Rejected)
            receiverWakeUp?.Wake(WakeUpCauses.Push);
        if (result == PushResult.QueuedDroppedOldest)
            Discarded<T>.Dispose(dropped, Name, log);
        return result;
    }

    private PushResult WhenFull()
    {
        if (FullMode != QueueFullMode.DropOldest)
            return Reject();
        TakeOut();
        _dropped++;
        return PushResult.QueuedDroppedOldest;
    }

    private PushResult Reject()
    {
        _rejected++;
        return PushResult.Rejected;
    }

    private void PutIn(in T value)
    {
        int tail = _head + _count;
        if (tail >= _ring.Length)
            tail -= _ring.Length;
        _ring[tail] = value;
        _count++;
        _pushed++;
    }

    private T TakeOut()
    {
        T value = _ring[_head];
        _ring[_head] = default!;
        if (++_head == _ring.Length)
            _head = 0;
        _count--;
        return value;
    }
}
