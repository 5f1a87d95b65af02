using System;
using System.Buffers;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

/// <summary>
/// Bytes in several segments, as a PipeReader has them, give the frames of the same bytes in one piece.
/// </summary>
public class SequenceReadTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(100)]
    public void TryRead_Segments_FindsTheFramesOfTheWhole(int segmentLength)
    {
        byte[] bytes = TestData.Bytes("ardupilot-flight.tlog").Take(20_000).ToArray();
        string[] expected =
            FrameCollector.Read(bytes, bytes.Length, new MavlinkFrameReader(MavlinkDialect.All), flush: false)
                .Select(frame => frame.ToString()).ToArray();
        var reader = new MavlinkFrameReader(MavlinkDialect.All);
        var found = new List<string>();

        ReadOnlySequence<byte> rest = Segments(bytes, segmentLength);
        while (reader.TryRead(ref rest, out MavlinkFrame frame, out MavlinkFrameInfo info))
            found.Add(new FoundFrame(frame, info).ToString());

        Assert.True(rest.IsEmpty);
        Assert.Equal(expected, found);
    }

    [Fact]
    public void TryRead_EmptySequence_IsFalse()
    {
        ReadOnlySequence<byte> none = default;
        Assert.False(new MavlinkFrameReader(MavlinkDialect.All).TryRead(ref none, out _, out _));
    }

    // Every third segment is empty, which a sequence may have.
    private static ReadOnlySequence<byte> Segments(byte[] bytes, int length)
    {
        var first = new Segment(default, null);
        Segment last = first;
        int count = 0;
        for (int start = 0; start < bytes.Length; start += length)
        {
            last = new Segment(bytes.AsMemory(start, Math.Min(length, bytes.Length - start)), last);
            if (count++ % 3 == 0)
                last = new Segment(default, last);
        }

        return new ReadOnlySequence<byte>(first, 0, last, last.Memory.Length);
    }

    private sealed class Segment : ReadOnlySequenceSegment<byte>
    {
        public Segment(ReadOnlyMemory<byte> memory, Segment? previous)
        {
            Memory = memory;
            if (previous is null)
                return;
            RunningIndex = previous.RunningIndex + previous.Memory.Length;
            previous.Next = this;
        }
    }
}
