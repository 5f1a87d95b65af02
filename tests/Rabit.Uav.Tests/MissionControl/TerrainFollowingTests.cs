using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

public class TerrainFollowingTests(ITestOutputHelper output)
{
    private const double Height = 40;

    private static readonly PlanePolygon Fence = new(
    [
        new PlanePoint(-50, -150), new PlanePoint(-50, 250), new PlanePoint(350, 250), new PlanePoint(350, -150),
    ]);

    [Theory]
    [InlineData(10, 10)]
    [InlineData(2, 8)]
    [InlineData(30, 4)]
    public void HeightAboveHome_RoughTerrain_ClearsItWithinTheSlope(double postMetres, double speed)
    {
        const int Seed = 7000;
        output.WriteLine($"seed {Seed}");
        var random = new Random(Seed);
        double[] phases = [.. Enumerable.Range(0, 8).Select(_ => random.NextDouble() * 6.3)];
        TerrainGrid grid = TestTerrain.Around(
            MissionRig.Home,
            (n, e) => (30 * Math.Sin((n / 90) + phases[0])) + (25 * Math.Sin((e / 70) + phases[1]))
                + (4 * Math.Sin((n / 17) + (e / 23) + phases[2])) - (25 * Math.Sin(phases[1]))
                - (30 * Math.Sin(phases[0])) - (4 * Math.Sin(phases[2])),
            postMetres, halfMetres: 600);
        TerrainFollowing heights = Create(grid, speed);
        PlanePoint last = default;
        for (int i = 0; i < 20_000; i++)
        {
            var at = new PlanePoint(-50 + (400 * random.NextDouble()), -150 + (400 * random.NextDouble()));
            double height = heights.HeightAboveHome(at, 1000);
            Assert.True(height >= 1000 + heights.GroundMetres(at) - 0.3, $"{at.North} {at.East}");

            // A chamfer of eight directions makes slopes up to 8 % steeper in between.
            double rise = Math.Abs(height - heights.HeightAboveHome(last, 1000));
            Assert.InRange(rise, 0, (1.09 * heights.MaxSlope * at.DistanceTo(last)) + 1e-3);
            double ofTheWay = heights.HeightAboveHome(at, last, 1000);
            Assert.True(ofTheWay + 0.01 >= Math.Max(height, heights.HeightAboveHome(last, 1000)));
            last = at;
        }
    }

    [Fact]
    public void HeightAboveHome_LevelGround_IsTheHeight()
    {
        TerrainFollowing heights = Create(TestTerrain.Around(MissionRig.Home, (_, _) => 0), 8);
        Assert.Equal(Height, heights.HeightAboveHome(new PlanePoint(100, 100), Height), 1e-3);
        Assert.Equal((0, Height), Rounded(heights.ClimbBetween(default, new PlanePoint(300, 0), Height)));
    }

    // Lines of nodes are 5 m apart, and never on those of the posts.
    [Theory]
    [InlineData(6)]
    [InlineData(7.3)]
    [InlineData(9.9)]
    [InlineData(31)]
    [InlineData(2.3)]
    public void HeightAboveHome_SinglePostsAndWalls_AreCleared(double postMetres)
    {
        Func<int, int, bool> isHigh = (row, column) => (row % 7 == 3 && column % 5 == 2) || column % 41 == 11;
        int posts = (int)(1200 / postMetres) + 1;
        TerrainGrid grid = TestTerrain.Around(
            MissionRig.Home,
            (n, e) => Math.Abs(n) < 40 && Math.Abs(e) < 40 ? 0
                : isHigh((int)Math.Round((n + 600) / postMetres), (int)Math.Round((e + 600) / postMetres)) ? 35 : 0,
            postMetres, halfMetres: 600);
        TerrainFollowing heights = Create(grid, speed: 8);
        Assert.InRange(posts, 30, 600);
        for (double n = -50; n <= 350; n += 1.1)
        {
            for (double e = -150; e <= 250; e += 1.3)
            {
                var at = new PlanePoint(n, e);
                Assert.True(
                    heights.HeightAboveHome(at, 1000) >= 1000 + heights.GroundMetres(at) - 0.1, $"{n} {e}");
            }
        }
    }

    [Fact]
    public void ClimbBetween_OverARidge_IsWhatIsClimbed()
    {
        TerrainFollowing heights = Create(
            TestTerrain.Around(MissionRig.Home, (n, _) => Math.Max(0, 20 - Math.Abs(n - 150))), speed: 1);
        (double climbed, double height) = heights.ClimbBetween(default, new PlanePoint(300, 0), Height);

        // The posts are 10 m apart: the ridge may lie between two.
        Assert.InRange(climbed, 19.5, 22);
        Assert.Equal(Height, height, 0.1);
    }

    [Fact]
    public void HeightAboveHome_GroundFarBelowHome_IsNotBelowTheLeast()
    {
        TerrainFollowing heights = Create(TestTerrain.Around(MissionRig.Home, (n, _) => -Math.Max(0, n)), 1);
        Assert.Equal(5, heights.HeightAboveHome(new PlanePoint(300, 0), Height));
        heights.AddPlaces(default, new PlanePoint(300, 0));
        Assert.InRange(heights.MaxHeightAboveGround(Height).Metres, 304.9, 345.1);
    }

    [Theory]
    [InlineData(100, 0, "the terrain grid does not cover N ", " from home (47.3")]
    [InlineData(1000, 70, "the ground at home is at 488.0 m", "the vehicle, at 558.0 m according to the terrain grid")]
    [InlineData(1000, double.NaN, "the terrain grid has no altitude of home", "")]
    public void Create_GridThatDoesNotFit_IsRefusedByName(double half, double offset, string start, string part)
    {
        TerrainGrid grid = TestTerrain.Around(MissionRig.Home, (_, _) => offset, halfMetres: half);
        Assert.Null(TerrainFollowing.Create(
            grid, LocalNedFrame.IgnoringGeoid(MissionRig.Home), Fence, 8, out string fault));
        Assert.StartsWith(start, fault, StringComparison.Ordinal);
        Assert.Contains(part, fault, StringComparison.Ordinal);
    }

    [Fact]
    public void Create_HoleInTheArea_IsRefusedWithItsPlace()
    {
        TerrainGrid grid = TestTerrain.Around(
            MissionRig.Home, (n, e) => Math.Abs(n - 200) < 6 && Math.Abs(e - 100) < 6 ? double.NaN : 0);
        Assert.Null(TerrainFollowing.Create(
            grid, LocalNedFrame.IgnoringGeoid(MissionRig.Home), Fence, 8, out string fault));
        Assert.StartsWith("the terrain grid has no altitude of N 1", fault, StringComparison.Ordinal);
        Assert.EndsWith("it must cover the fence and home", fault, StringComparison.Ordinal);
    }

    [Fact]
    public void FlightPlan_GroundThatFallsAwayTooSteeply_IsRefusedWithThePlaceAndFlownMoreSlowly()
    {
        TerrainGrid cliff = TestTerrain.Around(
            MissionRig.Home, (n, _) => 100 - Math.Min(100, 1.6 * Math.Abs(n - 100)), postMetres: 5, halfMetres: 400);
        Assert.Null(Plan(MissionRig.Mission(), cliff, out string why));
        Assert.StartsWith("over the terrain the vehicle is up to ", why, StringComparison.Ordinal);
        Assert.EndsWith("the limit is 120.0 m. Slower than 8.0 m/s it follows the ground more closely", why);
        MissionPlan slow = MissionRig.Mission().WithSpeed(1.5);
        Assert.NotNull(Plan(slow, cliff, out why));
        Assert.Empty(why);
    }

    private static FlightPlan? Plan(MissionPlan mission, TerrainGrid terrain, out string fault)
        => FlightPlan.Create(mission, MissionRig.Home, out fault, terrain: terrain);

    private static TerrainFollowing Create(TerrainGrid grid, double speed)
    {
        var heights = TerrainFollowing.Create(
            grid, LocalNedFrame.IgnoringGeoid(MissionRig.Home), Fence, speed, out string fault);
        Assert.Empty(fault);
        return heights!;
    }

    private static (double, double) Rounded((double A, double B) pair)
        => (Math.Round(pair.A, 3), Math.Round(pair.B, 3));
}
