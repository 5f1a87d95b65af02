using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// A camera whose rows are exposed one after the other, on a vehicle that flies 20 m/s and turns: 48 ms from the first
/// row to the last are a metre.
/// </summary>
public sealed class RollingShutterTests
{
    private const double Exposed = 1;
    private const double SpeedMetresPerSecond = 20;
    private const double TurnRadiansPerSecond = 0.7;
    private const double North = -6;
    private const double East = -4;

    private static readonly TimeSpan Readout = TimeSpan.FromTicks(480 * 1000);
    private static readonly TestView Still = new();
    private static readonly LocalNedFrame World = LocalNedFrame.IgnoringGeoid(Still.Position);

    [Fact]
    public void Frame_RollingShutter_IsReportedByThePoseOfItsRow()
    {
        (byte[] picture, double row) = Paint();
        using ImagingRig rig = Search(picture, Readout);
        AddPoses(rig, until: 3);
        rig.Camera!.Add(0, Exposed, deliveredAt: 1.15);
        rig.Run(2);

        TargetReport report = Assert.Single(rig.Sink.Reports);
        NedPosition ned = World.ToNed(report.Position);
        Assert.Equal(North, ned.North, 0.05);
        Assert.Equal(East, ned.East, 0.05);
        Assert.Equal(Exposed + (row / 480 * Readout.TotalSeconds), report.Time.TotalSeconds, 0.2e-3);
        CameraObservation observation = Assert.Single(rig.Sink.Observations);
        Assert.Equal(Exposed + (479 / 960.0 * Readout.TotalSeconds), observation.Time.TotalSeconds, 1e-6);
        AssertShown(observation.TopLeft, 0, 0);
        AssertShown(observation.BottomRight, 639, 479);
    }

    [Fact]
    public void Frame_TakenForAGlobalShutter_IsMuchWorse()
    {
        using ImagingRig rig = Search(Paint().Picture, TimeSpan.Zero);
        AddPoses(rig, until: 3);
        rig.Camera!.Add(0, Exposed, deliveredAt: 1.15);
        rig.Run(2);
        TargetReport report = Assert.Single(rig.Sink.Reports);
        Assert.True(
            Math.Abs(World.ToNed(report.Position).North - North) > 0.5,
            "the picture does not need the rows' own poses: the other test tests nothing");
        Assert.Equal(Exposed, report.Time.TotalSeconds, 1e-6);
    }

    [Fact]
    public void Frame_PoseOfTheLastRowMissing_WaitsForIt()
    {
        using ImagingRig rig = Search(Paint().Picture, Readout);
        AddPoses(rig, until: 1.04);
        rig.Camera!.Add(0, Exposed, deliveredAt: 1.1);
        rig.Run(1.2);
        Assert.Empty(rig.Sink.Observations);
        AddPoses(rig, from: 1.06, until: 1.06);
        rig.Run(0.05);
        Assert.Single(rig.Sink.Observations);
    }

    [Fact]
    public void Frame_LastRowsBeyondAllPoses_AreDrawnOnAndLessCertain()
    {
        (byte[] picture, _) = Paint();
        HorizontalCovariance known = Located(2, picture).Covariance;
        TargetReport drawnOn = Located(1.02, picture);
        Assert.Equal(North, World.ToNed(drawnOn.Position).North, 0.05);
        Assert.True(drawnOn.Covariance.NorthNorth > known.NorthNorth);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(501)]
    public void Constructor_ImpossibleReadout_IsRefused(int milliseconds)
    {
        var options = new ImageProcessingOptions { Camera = CameraWith(TimeSpan.FromMilliseconds(milliseconds)) };
        Assert.Contains(
            "picture is read in", Assert.Throws<ArgumentException>(() => new PixelGeolocator(options)).Message);
    }

    private static TargetReport Located(double posesUntil, byte[] picture)
    {
        using ImagingRig rig = Search(picture, Readout);
        AddPoses(rig, posesUntil);
        rig.Camera!.Add(0, Exposed, deliveredAt: 1.1);
        rig.Run(3);
        return Assert.Single(rig.Sink.Reports);
    }

    private static ImagingRig Search(byte[] picture, TimeSpan readout)
        => ImagingRig.Search(picture, new ImageProcessingOptions { Camera = CameraWith(readout) });

    private static CameraModel CameraWith(TimeSpan readout) => new()
    {
        Width = Still.Camera.Width,
        Height = Still.Camera.Height,
        FocalX = Still.Camera.FocalX,
        FocalY = Still.Camera.FocalY,
        CentreX = Still.Camera.CentreX,
        CentreY = Still.Camera.CentreY,
        K1 = Still.Camera.K1,
        K2 = Still.Camera.K2,
        P1 = Still.Camera.P1,
        P2 = Still.Camera.P2,
        Readout = readout,
    };

    // Fifty a second.
    private static void AddPoses(ImagingRig rig, double until, double from = 0)
    {
        for (int i = (int)Math.Round(from * 50); i <= (int)Math.Round(until * 50); i++)
        {
            TestView view = At(i / 50.0);
            rig.AddPose(
                i / 50.0, view.Position, new NedVector(SpeedMetresPerSecond, 0, 0), view.Attitude,
                BodyRates.FromRadiansPerSecond(0, 0, TurnRadiansPerSecond));
        }
    }

    private static TestView At(double seconds) => new()
    {
        Position = World.ToGeodetic(new NedPosition(NorthAt(seconds), 0, 0)),
        Attitude = EulerAngles.FromRadians(0, 0, TurnRadiansPerSecond * (seconds - Exposed)),
    };

    private static double NorthAt(double seconds) => SpeedMetresPerSecond * (seconds - Exposed);

    // The row where the panel is decides when it is seen, and that where it is.
    private static (byte[] Picture, double Row) Paint()
    {
        double row = 240;
        double column = 0;
        for (int i = 0; i < 20; i++)
        {
            double time = Exposed + (row / 480 * Readout.TotalSeconds);
            Assert.True(At(time).TryProject(North - NorthAt(time), East, out column, out row));
        }

        var painting = new Painting(21);
        painting.Panel(DefaultTargetClasses.Red, column, row, Still.Camera.FocalX / Still.HeightMetres, 0.4);
        return (painting.Finish(), row);
    }

    private static void AssertShown(GeodeticPosition corner, double column, double row)
    {
        double time = Exposed + (row / 480 * Readout.TotalSeconds);
        NedPosition ned = World.ToNed(corner);
        At(time).TryProject(ned.North - NorthAt(time), ned.East, out double shownColumn, out double shownRow);
        Assert.Equal(column, shownColumn, 0.01);
        Assert.Equal(row, shownRow, 0.01);
    }
}
