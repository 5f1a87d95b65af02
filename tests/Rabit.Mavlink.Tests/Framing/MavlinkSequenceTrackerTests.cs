using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Mavlink.Tests.Framing;

public class MavlinkSequenceTrackerTests
{
    [Theory]
    [InlineData("5", 0, 0)]
    [InlineData("5 6 7", 0, 0)]
    [InlineData("254 255 0 1", 0, 0)]
    [InlineData("5 7", 1, 0)]
    [InlineData("250 4", 9, 0)]
    [InlineData("0 128", 127, 0)]
    [InlineData("0 129", 0, 1)]
    [InlineData("5 5", 0, 1)]
    [InlineData("5 8 6 9", 1, 1)]
    [InlineData("5 8 6 7 9", 0, 2)]
    [InlineData("5 8 6 6 9", 1, 2)]
    [InlineData("5 70 6", 64, 1)]
    [InlineData("5 68 6", 61, 1)]
    [InlineData("254 1 255 0 2", 0, 2)]
    [InlineData("1 0 2", 0, 1)]
    public void Track_Sequence_CountsGapsAndDisorder(string sequence, long missing, long outOfOrder)
    {
        var tracker = new MavlinkSequenceTracker();
        byte[] numbers = sequence.Split(' ').Select(byte.Parse).ToArray();
        foreach (byte number in numbers)
            tracker.Track(Frame(1, 1, number));

        Assert.True(tracker.TryGet(1, 1, out MavlinkSequenceStatistics figures));
        Assert.Equal((numbers.Length, missing, outOfOrder), (figures.Frames, figures.Missing, figures.OutOfOrder));
    }

    [Fact]
    public void Track_SeveralSources_KeepsThemApartInOrderOfAppearance()
    {
        var tracker = new MavlinkSequenceTracker();
        tracker.Track(Frame(1, 191, 10));
        tracker.Track(Frame(1, 1, 200));
        tracker.Track(Frame(1, 191, 11));

        Assert.Equal(2, tracker.Count);
        Assert.Equal(
            (1, 191, 2L, 0L), (tracker[0].SystemId, tracker[0].ComponentId, tracker[0].Frames, tracker[0].Missing));
        Assert.Equal((1, 1, 200), (tracker[1].SystemId, tracker[1].ComponentId, tracker[1].LastSequence));
        Assert.False(tracker.TryGet(2, 1, out _));
        Assert.Throws<ArgumentOutOfRangeException>("index", () => tracker[2]);
    }

    [Fact]
    public void Track_MoreSourcesThanRoom_CountsTheirFramesApart()
    {
        var tracker = new MavlinkSequenceTracker(maxSources: 1);
        tracker.Track(Frame(1, 1, 0));
        tracker.Track(Frame(2, 1, 0));
        tracker.Track(Frame(1, 1, 1));

        Assert.Equal((1, 1, 2), (tracker.Count, tracker.UntrackedFrames, tracker[0].Frames));
    }

    [Fact]
    public void Constructor_NoRoom_Throws() =>
        Assert.Throws<ArgumentOutOfRangeException>("maxSources", () => new MavlinkSequenceTracker(0));

    private static MavlinkFrame Frame(byte system, byte component, byte sequence) =>
        MavlinkFrame.Create(default(Heartbeat), system, component, sequence);
}
