using System.Collections.Generic;

namespace Rabit.Core.Tests.Queues;

/// <summary>What a queue must do, said as simply as can be.</summary>
internal sealed class QueueModel(int capacity, QueueFullMode whenFull)
{
    private readonly List<int> _values = [];
    private readonly Queue<int> _waiting = new();
    private long _pushed;
    private long _popped;
    private long _dropped;
    private long _rejected;
    private int _highWater;

    public int Waiting => _waiting.Count;

    public (long Pushed, long Popped, long Dropped, long Rejected, int Resident, int HighWater) Counters
        => (_pushed, _popped, _dropped, _rejected, _values.Count, _highWater);

    public PushResult Push(int value)
    {
        PushResult result = PushResult.Queued;
        if (_values.Count == capacity)
        {
            switch (whenFull)
            {
                case QueueFullMode.DropOldest:
                    _values.RemoveAt(0);
                    _dropped++;
                    result = PushResult.QueuedDroppedOldest;
                    break;
                case QueueFullMode.DropNewest:
                    _values.RemoveAt(capacity - 1);
                    _dropped++;
                    result = PushResult.QueuedDroppedNewest;
                    break;
                default:
                    _rejected++;
                    return PushResult.Rejected;
            }
        }

        PutIn(value);
        return result;
    }

    /// <summary>All of them; those behind the first that is rejected are rejected too.</summary>
    public int PushFrom(int[] values)
    {
        int pushed = 0;
        foreach (int value in values)
            pushed += Push(value) == PushResult.Rejected ? 0 : 1;
        return pushed;
    }

    public void PushOrWait(int value)
    {
        if (_values.Count == capacity)
            _waiting.Enqueue(value);
        else
            PutIn(value);
    }

    public bool TryPop(out int value)
    {
        value = 0;
        if (_values.Count == 0)
            return false;
        value = _values[0];
        _values.RemoveAt(0);
        _popped++;
        if (_waiting.Count > 0)
            PutIn(_waiting.Dequeue());
        return true;
    }

    public int[] PopUpTo(int count)
    {
        var popped = new List<int>();
        while (popped.Count < count && TryPop(out int value))
            popped.Add(value);
        return popped.ToArray();
    }

    private void PutIn(int value)
    {
        _values.Add(value);
        _pushed++;
        if (_values.Count > _highWater)
            _highWater = _values.Count;
    }
}
