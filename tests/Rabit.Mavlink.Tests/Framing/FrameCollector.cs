using System;
using System.Collections.Generic;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>What a reader found, as a line per frame that compares and prints well.</summary>
internal static class FrameCollector
{
    public static List<FoundFrame> Read(byte[] bytes, int chunk, MavlinkFrameReader reader, bool flush = true)
    {
        var found = new List<FoundFrame>();
        for (int start = 0; start < bytes.Length; start += chunk)
        {
            ReadOnlySpan<byte> part = bytes.AsSpan(start, Math.Min(chunk, bytes.Length - start));
            while (reader.TryRead(ref part, out MavlinkFrame frame, out MavlinkFrameInfo info))
                found.Add(new FoundFrame(frame, info));
        }
        while (flush && reader.TryFlush(out MavlinkFrame frame, out MavlinkFrameInfo info))
            found.Add(new FoundFrame(frame, info));
        return found;
    }
}

/// <summary>A frame and where it was.</summary>
internal readonly struct FoundFrame
{
    public FoundFrame(in MavlinkFrame frame, in MavlinkFrameInfo info)
    {
        Frame = frame;
        Info = info;
    }

    public MavlinkFrame Frame { get; }

    public MavlinkFrameInfo Info { get; }

    public override string ToString() => FormattableString.Invariant(
        $"{Info.StreamOffset} +{Frame.WireLength} {Frame.Version} id {Frame.MessageId} {Frame.SystemId}/{Frame.ComponentId} seq {Frame.Sequence} signed {Frame.IsSigned} checked {Info.IsChecked}");
}
