using System;

namespace Rabit.Uav.Communications;

/// <summary>Frames of one class in their order; the oldest makes room. Allocates nothing after it was made.</summary>
internal sealed class FrameFifo(int capacity)
{
    private readonly FrameToSend[] _frames = new FrameToSend[capacity];
    private int _first;

    public int Count { get; private set; }

    public ref readonly FrameToSend First => ref _frames[_first];

    /// <returns>False where the oldest one was dropped for it.</returns>
    public bool Add(in FrameToSend frame)
    {
        bool hadRoom = Count < capacity;
        if (!hadRoom)
            RemoveFirst();
        _frames[(_first + Count) % capacity] = frame;
        Count++;
        return hadRoom;
    }

    public void RemoveFirst()
    {
        _first = (_first + 1) % capacity;
        Count--;
    }

    /// <returns>How many were too old.</returns>
    public int RemoveExpired(TimeSpan now)
    {
        int removed = 0;
        for (; Count > 0 && First.ValidUntil < now; removed++)
            RemoveFirst();
        return removed;
    }
}
