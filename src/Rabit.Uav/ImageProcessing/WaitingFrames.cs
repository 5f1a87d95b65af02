using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The few pictures that wait for a pose of their time, in the order of arrival. Owns their buffers; for one thread.
/// </summary>
internal sealed class WaitingFrames(int capacity)
{
    private readonly CameraFrame[] _frames = new CameraFrame[capacity];
    private readonly TimeSpan[] _since = new TimeSpan[capacity];

    public int Count { get; private set; }

    public bool IsFull => Count == capacity;

    public ref readonly CameraFrame this[int index] => ref _frames[index];

    /// <summary>When it arrived.</summary>
    public TimeSpan Since(int index) => _since[index];

    /// <summary>How long until one has waited for the timeout, at most <paramref name="longest"/>.</summary>
    public TimeSpan DelayUntil(TimeSpan now, TimeSpan timeout, TimeSpan longest)
    {
        TimeSpan delay = longest;
        for (int i = 0; i < Count; i++)
        {
            TimeSpan left = _since[i] + timeout - now;
            delay = left < delay ? left : delay;
        }

        return delay;
    }

    public void Add(in CameraFrame frame, TimeSpan now)
    {
        _frames[Count] = frame;
        _since[Count++] = now;
    }

    /// <summary>Takes one out, which is the caller's from now on.</summary>
    public CameraFrame TakeOut(int index)
    {
        CameraFrame frame = _frames[index];
        Count--;
        for (int i = index; i < Count; i++)
        {
            _frames[i] = _frames[i + 1];
            _since[i] = _since[i + 1];
        }

        _frames[Count] = default;
        return frame;
    }

    /// <summary>Gives all their buffers back.</summary>
    public void Clear()
    {
        while (Count > 0)
            TakeOut(Count - 1).Dispose();
    }
}
