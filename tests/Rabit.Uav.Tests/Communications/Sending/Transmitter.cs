using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;

namespace Rabit.Uav.Tests.Communications.Sending;

/// <summary>
/// A transmitter of so many bytes a second behind a link in memory: when the last byte of each frame was sent, and how
/// much it was given.
/// </summary>
internal sealed class Transmitter(int bytesPerSecond)
{
    private readonly MavlinkFrameReader _reader = new(MavlinkDialect.All);
    private readonly List<(TimeSpan Time, int Bytes)> _given = [];
    private TimeSpan _freeAt;

    public List<(MavlinkFrame Frame, TimeSpan SentAt)> Sent { get; } = [];

    /// <summary>Takes bytes that came out of the link.</summary>
    public void Take(byte[] bytes, TimeSpan now)
    {
        var rest = new ReadOnlySpan<byte>(bytes);
        while (_reader.TryRead(ref rest, out MavlinkFrame frame, out _))
        {
            _given.Add((now, frame.WireLength));
            TimeSpan start = _freeAt > now ? _freeAt : now;
            _freeAt = start + TimeSpan.FromTicks(frame.WireLength * TimeSpan.TicksPerSecond / bytesPerSecond);
            Sent.Add((frame, _freeAt));
        }
    }

    public int MaxBytesInAnySecond()
    {
        int most = 0;
        int inWindow = 0;
        for (int first = 0, last = 0; last < _given.Count; last++)
        {
            inWindow += _given[last].Bytes;
            while (_given[last].Time - _given[first].Time >= TimeSpan.FromSeconds(1))
                inWindow -= _given[first++].Bytes;
            most = Math.Max(most, inWindow);
        }

        return most;
    }

    public static double Percentile(IEnumerable<double> values, double percentile)
    {
        double[] sorted = values.OrderBy(v => v).ToArray();
        return sorted[(int)Math.Ceiling(percentile * sorted.Length) - 1];
    }
}
