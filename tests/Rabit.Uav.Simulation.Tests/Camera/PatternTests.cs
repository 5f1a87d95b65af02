using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Camera;

/// <summary>What is not of one colour, in the simulated pictures.</summary>
public sealed class PatternTests
{
    private static readonly SimulatedCameraOptions Camera = new() { NoiseSigma = 1 };

    private readonly byte[] _pixels = new byte[640 * 480 * 3];
    private double _height;

    // Right way round and the right way up, seen from above: read by the detector, whose codes are not symmetric.
    [Theory]
    [InlineData(SimulatedTargetKind.ArUcoMarker, 0)]
    [InlineData(SimulatedTargetKind.ArUcoMarker, 130)]
    [InlineData(SimulatedTargetKind.AprilTagMarker, 40)]
    [InlineData(SimulatedTargetKind.AprilTagMarker, -75)]
    public void Marker_AnyHeading_IsReadWithItsIdAndItsTopForward(SimulatedTargetKind kind, double headingDegrees)
    {
        SimulatedTarget target = Lying(kind, headingDegrees);
        Render(target, height: 25);
        byte[] grey = new byte[640 * 480];
        GreyPixels.FromRgb(_pixels, grey);
        MarkerFamily family = target.Declared!.Marker!.Family;
        var detector = new MarkerDetector(new MarkerDetectorOptions { Families = [family] });

        DetectedMarker marker = Assert.Single(detector.Find(grey, 640, 480).ToArray());
        Assert.Equal(target.MarkerId, marker.Id);

        // North is up in the picture.
        double dx = marker.Corners.TopLeft.X - marker.Corners.BottomLeft.X;
        double dy = marker.Corners.TopLeft.Y - marker.Corners.BottomLeft.Y;
        double heading = Math.Atan2(dx, -dy) / Scene.Degrees(1);
        Assert.Equal(0, Math.IEEERemainder(heading - headingDegrees, 360), 2.0);
        double side = Math.Sqrt((dx * dx) + (dy * dy));
        Assert.Equal(1.6 * 530 / 25, side, 1.0);
    }

    [Fact]
    public void Car_FromAbove_IsItsPaintWithDarkWindows()
    {
        SimulatedTarget car = Lying(SimulatedTargetKind.Car, 0);
        Render(car, height: 20);

        (int red, int green, int blue) = At(0, 0);
        Assert.InRange(red - car.Surface.Red, -40, 30);
        Assert.InRange(green - car.Surface.Green, -40, 30);
        Assert.InRange(blue - car.Surface.Blue, -40, 30);
        Assert.True(At(north: 0.9, east: 0).Red < 80, $"the windscreen is {At(0.9, 0)}");
    }

    [Fact]
    public void TwoColoured_Panel_HasBothColours()
    {
        var pattern = SurfacePattern.Of([new SurfaceColour(200, 20, 20), new SurfaceColour(20, 20, 200)], "0", "1");
        SimulatedTarget panel = new() { Pattern = pattern, SideMetres = 1, WidthMetres = 1 };
        Render(panel, height: 20);

        Assert.True(At(0.25, 0).Red > 150 && At(0.25, 0).Blue < 60, $"ahead {At(0.25, 0)}");
        Assert.True(At(-0.25, 0).Blue > 150 && At(-0.25, 0).Red < 60, $"behind {At(-0.25, 0)}");
    }

    [Fact]
    public void Open_Cells_ShowTheGround()
    {
        SimulatedTarget person = Lying(SimulatedTargetKind.Person, 0);
        Render(person, height: 10);
        (int, int, int) beside = At(0.82, -0.27);
        Render(new SimulatedTarget { Position = new NedPosition(50, 50, 0) }, height: 10);

        Assert.Equal(At(0.82, -0.27), beside);
    }

    // As a plain sheet, where it has one colour: the two ways of painting agree.
    [Fact]
    public void Pattern_OfOneColour_IsPaintedAsASheet()
    {
        var colour = new SurfaceColour(212, 36, 150);
        var plain = new SimulatedTarget { Surface = colour, Heading = Angle.FromDegrees(33) };
        Render(plain, height: 30);
        byte[] expected = (byte[])_pixels.Clone();
        Render(
            new SimulatedTarget { Pattern = SurfacePattern.Of(colour), Heading = Angle.FromDegrees(33) }, height: 30);

        int different = Enumerable.Range(0, expected.Length).Count(i => Math.Abs(expected[i] - _pixels[i]) > 1);
        Assert.Equal(0, different);
    }

    [Fact]
    public void Render_Patterns_AllocatesNothing()
    {
        SimulatedTarget[] things =
            [Lying(SimulatedTargetKind.AprilTagMarker, 20), Lying(SimulatedTargetKind.Person, 20)];
        var renderer = new PictureRenderer(Camera, things, seed: 3);
        var pose = new CameraPose(Scene.Pose(20), Camera);
        void Work() => renderer.Render(pose, pose, pose, 1, _pixels);
        Work();

        Assert.Equal(0, Allocated.By(Work));
    }

    private static SimulatedTarget Lying(SimulatedTargetKind kind, double headingDegrees)
    {
        TargetLook look = TargetLooks.Of(kind, number: 2, seed: 11);
        return new SimulatedTarget
        {
            Class = look.Declared.Name,
            Declared = look.Declared,
            Heading = Angle.FromDegrees(headingDegrees),
            SideMetres = look.SideMetres,
            WidthMetres = look.WidthMetres,
            MarkerId = look.MarkerId,
            Surface = look.Pattern.Main,
            Pattern = look.Pattern,
        };
    }

    private void Render(SimulatedTarget thing, double height)
    {
        _height = height;
        var pose = new CameraPose(Scene.Pose(height), Camera);
        new PictureRenderer(Camera, [thing], seed: 3).Render(pose, pose, pose, 1, _pixels);
    }

    private (int Red, int Green, int Blue) At(double north, double east)
    {
        // The camera is 0.1 m before the origin and 0.05 m below the pose.
        double focal = Camera.Camera.FocalX / (_height - 0.05);
        int u = (int)Math.Round(Camera.Camera.CentreX + (focal * east));
        int v = (int)Math.Round(Camera.Camera.CentreY - (focal * (north - 0.1)));
        int at = ((v * 640) + u) * 3;
        return (_pixels[at], _pixels[at + 1], _pixels[at + 2]);
    }
}
