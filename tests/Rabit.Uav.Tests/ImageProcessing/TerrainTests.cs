using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class TerrainTests(ITestOutputHelper output)
{
    [Fact]
    public void Locate_Vectors_IntersectTheTerrain()
    {
        TerrainGrid[] grids = [.. Vectors.Geolocation.Each("dems").Select(Grid)];
        (double worst, int located, int refused) = (0, 0, 0);
        foreach (JsonElement c in Vectors.Geolocation.Each("dem"))
        {
            GroundProjection projection = GroundProjectorTests.ProjectionOf(c, grids[c.GetProperty("dem").GetInt32()]);
            GeolocationError refusal = projection.Locate(c.Number("u"), c.Number("v"), out NedPosition ground);
            if (c.Text("status") != "ok")
            {
                Assert.Equal(
                    c.Text("reason") == "ray_leaves_dem"
                        ? GeolocationError.LeavesTerrain
                        : GeolocationError.NearHorizon,
                    refusal);
                refused++;
                continue;
            }

            Assert.True(refusal == GeolocationError.None, $"{c.Number("id")}: {refusal}");
            GeodeticPosition place = LocalNedFrame.IgnoringGeoid(c.Position()).ToGeodetic(ground);
            double error = Vectors.Distance(c.GetProperty("target").Position(), place);
            Assert.True(error <= 0.01, $"case {c.Number("id")} is off by {error} m");
            worst = Math.Max(worst, error);
            located++;
        }

        output.WriteLine($"{located} located, {refused} refused, at worst {worst:E1} m off");
        Assert.True(located >= 10 && refused >= 1);
    }

    [Fact]
    public void Covariances_OnASlope_AgreeWithDifferences()
    {
        const double Step = 0.01;
        int compared = 0;
        TerrainGrid[] grids = [.. Vectors.Geolocation.Each("dems").Select(Grid)];
        foreach (JsonElement c in Vectors.Geolocation.Each("dem").Where(d => d.Text("status") == "ok").Take(10))
        {
            (double u, double v) = (c.Number("u"), c.Number("v"));
            GroundProjection projection = GroundProjectorTests.ProjectionOf(
                c, grids[c.GetProperty("dem").GetInt32()], OnlyPixels);
            Assert.True(projection.TryCovariances(u, v, out HorizontalCovariance stated, out _));
            Assert.True(
                projection.TryProjectToGround(u + Step, v, out NedPosition right)
                    & projection.TryProjectToGround(u - Step, v, out NedPosition left));
            Assert.True(
                projection.TryProjectToGround(u, v + Step, out NedPosition below)
                    & projection.TryProjectToGround(u, v - Step, out NedPosition above));
            double expected =
                (Squared(right.North - left.North) + Squared(below.North - above.North)) / Squared(2 * Step);

            // Where a post's cell ends between the steps there is a kink.
            compared += Math.Abs(stated.NorthNorth - expected) < 0.05 * expected ? 1 : 0;
        }

        Assert.True(compared >= 7, $"{compared} of 10 agree");

        static double Squared(double value) => value * value;
    }

    [Fact]
    public void Locate_OverAHole_IsRefusedAndNotGuessed()
    {
        TerrainGrid whole = AsciiGrid.Read(new StringReader(Flat(hole: false)));
        TerrainGrid holed = AsciiGrid.Read(new StringReader(Flat(hole: true)));
        LocalNedFrame frame = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(47.005, 8.005, 200));
        var ray = new GroundRay(default, new NedVector(0, 0, 1));
        Assert.Equal(
            GeolocationError.None,
            TerrainRay.Intersect(ray, frame, whole, Angle.FromRadians(0.1), out NedPosition point));
        Assert.Equal(100, point.Down, 1e-4);
        Assert.Equal(
            GeolocationError.NoTerrainData, TerrainRay.Intersect(ray, frame, holed, Angle.FromRadians(0.1), out _));
        LocalNedFrame below = LocalNedFrame.IgnoringGeoid(GeodeticPosition.FromDegrees(47.005, 8.005, 90));
        Assert.Equal(
            GeolocationError.CameraBelowGround, TerrainRay.Intersect(ray, below, whole, Angle.FromRadians(0.1), out _));
    }

    private static ErrorBudget OnlyPixels => new()
    {
        AttitudeNoise = Angle.Zero,
        HeadingNoise = Angle.Zero,
        PositionNoiseMetres = 0,
        AltitudeNoiseMetres = 0,
        PixelNoise = 1,
        TimeNoise = TimeSpan.Zero,
    };

    private static TerrainGrid Grid(JsonElement dem)
    {
        int rows = dem.GetProperty("nlat").GetInt32();
        int columns = dem.GetProperty("nlon").GetInt32();
        var text = new StringBuilder();
        text.AppendLine(FormattableString.Invariant(
            $"ncols {columns}\nnrows {rows}\nxllcenter {dem.Number("lon0")}\nyllcenter {dem.Number("lat0")}\ndx {dem.Number("dlon")}\ndy {dem.Number("dlat")}"));
        foreach (JsonElement row in dem.Each("height").Reverse())
            text.AppendLine(string.Join(" ", row.EnumerateArray().Select(n => n.GetRawText())));
        return AsciiGrid.Read(new StringReader(text.ToString()));
    }

    private static string Flat(bool hole)
    {
        var text = new StringBuilder("ncols 11\nnrows 11\nxllcenter 8\nyllcenter 47\ncellsize 0.001\n");
        for (int i = 0; i < 121; i++)
            text.Append(hole && i == 60 ? "-9999 " : "100 ");
        return text.ToString();
    }
}
