using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Reporting.Tests.Group;

/// <summary>How much of the area all vehicles have seen together: 120 by 160 m, of which each sees a part.</summary>
public sealed class GroupCoverageTests
{
    [Fact]
    public void Coverage_EachSeesAnotherPart_IsThatOfBoth()
        => Assert.Equal(0.75, Coverage(Record(0.5, (20, 100)), Record(0.5, (60, 140 - 30))), tolerance: 0.01);

    [Fact]
    public void Coverage_OneKnowsOfMore_IsWhatThatOneKnows()
        => Assert.Equal(0.9, Coverage(Record(0.9, (20, 50)), Record(0.1)), tolerance: 0.001);

    [Fact]
    public void Coverage_KeepOut_IsNoPartOfTheArea()
    {
        SearchPlan plan = Plan([.. Rectangle(20, 80)]);
        Assert.Equal(0.5, Coverage(Record(0, plan, (80, 110)), Record(0, plan)), tolerance: 0.01);
    }

    [Fact]
    public void Coverage_NoPlan_IsZero() => Assert.Equal(0, Coverage(new FlightRecord()));

    private static double Coverage(params FlightRecord[] records) => new GroupFlightSummary(
        records.Select((r, i) => new GroupVehicleSummary((byte)(i + 1), new FlightSummary(r))).ToArray()).Coverage;

    private static FlightRecord Record(double coverage, params (double South, double North)[] seen)
        => Record(coverage, MadeUpSite.Plan, seen);

    private static FlightRecord Record(
        double coverage, SearchPlan plan, params (double South, double North)[] seen) => new()
        {
            Mission = new MissionStatus { Plan = plan, Coverage = coverage },
            Observations = seen.Select(s => Rectangle(s.South, s.North).ToArray()).Select(c => new CameraObservation
            {
                BottomLeft = c[0],
                TopLeft = c[1],
                TopRight = c[2],
                BottomRight = c[3],
            }).ToArray(),
        };

    // Over the whole width of the area, and beyond.
    private static ImmutableArray<GeodeticPosition> Rectangle(double south, double north)
        => [.. new[] { (south, 10.0), (north, 10.0), (north, 190.0), (south, 190.0) }
            .Select(c => MadeUpSite.Frame.ToGeodetic(new NedPosition(c.Item1, c.Item2, 0)))];

    private static SearchPlan Plan(ImmutableArray<GeodeticPosition> keepOut) => new()
    {
        Area = MadeUpSite.Plan.Area,
        Home = MadeUpSite.Plan.Home,
        KeepOuts = [keepOut],
    };
}
