using System;
using System.Collections.Generic;
using Rabit.Mavlink;

namespace Rabit.Uav.Simulation;

/// <summary>Frames on their way: each is late by the latency and a jitter, and none overtakes another.</summary>
internal sealed class DelayedFrames(SimulationRandom random, TimeSpan latency)
{
    private const double JitterSeconds = 0.004;   // mean; exponential
    private const double MaxJitter = 0.03;

    private readonly Queue<(TimeSpan Due, MavlinkFrame Frame)> _frames = new();
    private TimeSpan _lastDue;

    /// <summary>When the next one arrives; the far future where there is none.</summary>
    public TimeSpan NextDue => _frames.Count == 0 ? TimeSpan.MaxValue : _frames.Peek().Due;

    /// <param name="frame">What is sent.</param>
    /// <param name="now">When.</param>
    /// <param name="more">How much longer than usual it takes.</param>
    public void Add(in MavlinkFrame frame, TimeSpan now, TimeSpan more = default)
    {
        double jitter = Math.Min(MaxJitter, -Math.Log(1 - random.Uniform()) * JitterSeconds);
        if (latency == TimeSpan.Zero)
            jitter = 0;
        TimeSpan due = now + latency + more + TimeSpan.FromTicks((long)(jitter * TimeSpan.TicksPerSecond));
        _lastDue = due > _lastDue ? due : _lastDue;
        _frames.Enqueue((_lastDue, frame));
    }

    public bool TryTake(TimeSpan now, out MavlinkFrame frame)
    {
        frame = default;
        if (NextDue > now)
            return false;
        frame = _frames.Dequeue().Frame;
        return true;
    }
}
