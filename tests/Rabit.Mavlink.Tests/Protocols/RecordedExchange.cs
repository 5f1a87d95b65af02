using System;
using System.Collections.Generic;
using System.IO;

namespace Rabit.Mavlink.Tests.Protocols;

/// <summary>A recorded log as a sequence of frames with times.</summary>
internal sealed class RecordedExchange
{
    public RecordedExchange(string name)
    {
        using FileStream file = File.OpenRead(TestData.PathOf(name + ".tlog"));
        var log = new TlogReader(file, MavlinkDialect.All);
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
            Frames.Add((new TimeSpan(record.TimeMicroseconds * 10), frame));
    }

    public List<(TimeSpan At, MavlinkFrame Frame)> Frames { get; } = [];

    /// <summary>
    /// Gives what the vehicle sent, in a range of records, to a client, and collects what the client sends.
    /// </summary>
    public List<MavlinkFrame> Replay(
        int first, int last, ProtocolWorld.HandleFrame handle, ProtocolWorld.TakeFrame take)
    {
        var sent = new List<MavlinkFrame>();
        for (int i = first; i <= last && i < Frames.Count; i++)
        {
            (TimeSpan at, MavlinkFrame frame) = Frames[i];
            Drain(at, take, sent);
            if (frame.ComponentId == 1)
                handle(frame, at);
            Drain(at, take, sent);
        }

        return sent;
    }

    private static void Drain(TimeSpan now, ProtocolWorld.TakeFrame take, List<MavlinkFrame> sent)
    {
        while (take(now, out MavlinkFrame frame))
            sent.Add(frame);
    }
}
