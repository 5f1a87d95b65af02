using System.Linq;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Lanes that are left out since they are seen from the lanes beside them.</summary>
public sealed class LaneThinningTests
{
    private const double Spacing = 30;

    [Theory]
    [InlineData(20, 5, new[] { 0, 1, 2, 3, 4 })]
    [InlineData(29, 5, new[] { 0, 1, 2, 3, 4 })]
    [InlineData(31, 5, new[] { 0, 2, 4 })]
    [InlineData(31, 4, new[] { 0, 2, 3 })]
    [InlineData(31, 1, new[] { 0 })]
    [InlineData(47, 4, new[] { 1, 3 })]
    public void Thin_NothingSeen_KeepsWhatIsNeeded(double seenToEachSide, int lanes, int[] kept)
        => Assert.Equal(kept, Thin(Lanes(lanes), seenToEachSide, _ => true));

    [Theory]
    [InlineData(20, 1)]
    [InlineData(29, 1)]
    [InlineData(31, 2)]
    [InlineData(44, 2)]
    [InlineData(45, 3)]
    [InlineData(0, 1)]
    public void LanesPerPass_OfWhatIsSeen(double seenToEachSide, int lanes)
        => Assert.Equal(lanes, LaneThinning.LanesPerPass(seenToEachSide, Spacing));

    [Fact]
    public void Thin_EachPlaceIsSeenFromALaneThatIsKept()
    {
        for (double seen = 16; seen < 80; seen += 3)
        {
            LaneSegment[] all = Lanes(9);
            LaneSegment[] kept = Thin(all, seen, _ => true).Select(i => all[i]).ToArray();
            for (double east = 0.5; east < 9 * Spacing; east++)
                Assert.Contains(kept, l => l.DistanceTo(new PlanePoint(100, east)) <= seen + 1);
        }
    }

    [Fact]
    public void Thin_PartIsSeen_OnlyTheRestCounts()
        => Assert.Equal([2], Thin(Lanes(5), 31, p => p.East > 62 && p.East < 100));

    // A lane is not left out for one that is too short to show its end.
    [Fact]
    public void Thin_NeighbourIsShort_KeepsTheLane()
    {
        LaneSegment[] lanes = Lanes(3);
        lanes[0] = new LaneSegment(default(PlanePoint) + new PlanePoint(0, 15), new PlanePoint(60, 15));
        lanes[2] = new LaneSegment(new PlanePoint(0, 75), new PlanePoint(60, 75));
        Assert.Contains(1, Thin(lanes, 31, _ => true));
    }

    private static int[] Thin(
        LaneSegment[] lanes, double seenToEachSide, System.Func<PlanePoint, bool> isWanted)
        => LaneThinning.Thin(lanes, System.Math.PI / 2, Spacing / 2, seenToEachSide, 1, isWanted)
            .Select(l => System.Array.IndexOf(lanes, l)).ToArray();

    // To the north, beside each other to the east.
    private static LaneSegment[] Lanes(int count) => Enumerable.Range(0, count)
        .Select(i => new LaneSegment(
            new PlanePoint(0, (i + 0.5) * Spacing), new PlanePoint(200, (i + 0.5) * Spacing))).ToArray();
}
