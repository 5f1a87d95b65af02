using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Uav.Communications;

namespace Rabit.Uav.Tests.Communications.Sending;

/// <summary>
/// A transmitter of so many bytes a second behind a <see cref="LinkScheduler"/>, in steps of a millisecond: when the
/// last byte of each frame was sent.
/// </summary>
internal sealed class RadioModel(SendBudget budget, int signatureBytes = 0)
{
    private readonly List<(TimeSpan Time, int Bytes)> _released = [];
    private readonly Dictionary<(int Id, byte Sequence), TimeSpan> _put = [];
    private TimeSpan _freeAt;

    public LinkScheduler Scheduler { get; } = new(budget, signatureBytes);

    public TimeSpan Now { get; private set; }

    /// <summary>In the order in which they were sent, with the time from putting to the last byte.</summary>
    public List<(MavlinkFrame Frame, TimeSpan Latency, TimeSpan SentAt)> Sent { get; } = [];

    public void Put(in MavlinkFrame frame, bool isOwn = true, TimeSpan validUntil = default)
    {
        _put[(frame.MessageId, frame.Sequence)] = Now;
        Scheduler.Put(
            new FrameToSend { Frame = frame, IsOwn = isOwn, ValidUntil = validUntil },
            SendClasses.Of(frame, keepsOrder: !isOwn && frame.IsSigned), Now);
    }

    /// <summary>Goes on; what is to be put at each millisecond is put first.</summary>
    public void Run(double seconds, Action<int>? eachMillisecond = null)
    {
        int steps = (int)Math.Round(seconds * 1000);
        for (int step = 0; step < steps; step++)
        {
            eachMillisecond?.Invoke(step);
            while (Scheduler.TryTake(Now, out FrameToSend frame))
                Transmit(frame.Frame);
            Now += TimeSpan.FromMilliseconds(1);
        }
    }

    public double LatencyMilliseconds(Func<MavlinkFrame, bool> which, double percentile)
    {
        double[] latencies = Sent.Where(s => which(s.Frame)).Select(s => s.Latency.TotalMilliseconds)
            .OrderBy(l => l).ToArray();
        return latencies[(int)Math.Ceiling(percentile * latencies.Length) - 1];
    }

    public int MaxBytesInAnySecond()
    {
        int most = 0;
        int inWindow = 0;
        for (int first = 0, last = 0; last < _released.Count; last++)
        {
            inWindow += _released[last].Bytes;
            while (_released[last].Time - _released[first].Time >= TimeSpan.FromSeconds(1))
                inWindow -= _released[first++].Bytes;
            most = Math.Max(most, inWindow);
        }

        return most;
    }

    private void Transmit(in MavlinkFrame frame)
    {
        TimeSpan put = _put[(frame.MessageId, frame.Sequence)];
        _released.Add((Now, frame.WireLength));
        TimeSpan start = _freeAt > Now ? _freeAt : Now;
        _freeAt = start + TimeSpan.FromTicks(frame.WireLength * TimeSpan.TicksPerSecond / budget.BytesPerSecond);
        Sent.Add((frame, _freeAt - put, _freeAt));
    }
}
