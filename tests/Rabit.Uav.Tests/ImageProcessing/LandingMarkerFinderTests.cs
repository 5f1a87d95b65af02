using System;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Where the marker to land on is, from pictures drawn by the projection of the test.</summary>
public sealed class LandingMarkerFinderTests
{
    private const double SideMetres = 0.5;

    [Fact]
    public void Find_TurnedVehicleAndCamera_GivesThePlaceFromTheVehicle()
    {
        for (int seed = 1; seed <= 12; seed++)
        {
            var random = new Random(seed);
            TestView view = View();
            view.Attitude = EulerAngles.FromRadians(
                Spread(random, 0.15), Spread(random, 0.15), Spread(random, Math.PI));
            view.CameraPitch = (-Math.PI / 2) + Spread(random, 0.15);
            view.CameraYaw = Spread(random, 0.3);
            var tag = new PrintedTag(Spread(random, 0.4), Spread(random, 0.4), SideMetres);

            LandingTargetObservation found = Found(view, PrintedTag.Show(view, tag));

            BodyVector expected = view.ToBody(tag.North, tag.East);
            AssertNear(0.02, seed, expected.Forward, found.PositionMetres.Forward);
            AssertNear(0.02, seed, expected.Right, found.PositionMetres.Right);
            AssertNear(0.04, seed, expected.Down, found.PositionMetres.Down);
            AssertNear(0.02, seed, tag.North, found.OffsetNedMetres.North);
            AssertNear(0.02, seed, tag.East, found.OffsetNedMetres.East);
            AssertNear(0.04, seed, 5, found.OffsetNedMetres.Down);
            Assert.Equal((3L, 0), (found.PictureNumber, found.MarkerId));
            Assert.Equal(TimeSpan.FromSeconds(2.001), found.Time);
        }
    }

    [Fact]
    public void Find_SideDeclaredTwice_IsTwiceAsFar()
    {
        TestView view = View();
        byte[] picture = PrintedTag.Show(view, new PrintedTag(0.1, 0, SideMetres));
        LandingMarkerOptions wrong = Marker();
        wrong.SideMetres = 2 * SideMetres;

        LandingTargetObservation found = Found(view, picture, wrong);

        // The lever arm is known without the marker.
        Assert.Equal(0.05 + (2 * 4.95), found.PositionMetres.Down, 0.08);
    }

    [Fact]
    public void Find_TwoOfIt_RefusesBoth()
    {
        TestView view = View();
        byte[] picture = PrintedTag.Show(
            view, new PrintedTag(0.8, -0.6, SideMetres), new PrintedTag(-0.8, 0.6, SideMetres));

        Assert.Equal(LandingMarkerFinder.SeenTwice, Refusal(view, picture));
    }

    [Theory]
    [InlineData(MarkerFamily.AprilTag36h11, 1)]
    [InlineData(MarkerFamily.ArUco4x4, 0)]
    public void Find_OtherIdOrFamily_FindsNone(MarkerFamily family, int id)
    {
        TestView view = View();
        byte[] picture = PrintedTag.Show(view, new PrintedTag(0, 0, SideMetres));
        var other = new LandingMarkerOptions { Family = family, Id = id, SideMetres = SideMetres };

        Assert.Null(Refusal(view, picture, other));
    }

    [Fact]
    public void Find_NoMarker_FindsNone()
    {
        TestView view = View();
        Assert.Null(Refusal(view, PrintedTag.Show(view)));
    }

    [Fact]
    public void Find_PictureOfAnotherSizeOrWithoutPixels_IsRefused()
    {
        TestView view = View();
        byte[] picture = PrintedTag.Show(view, new PrintedTag(0, 0, SideMetres));
        LandingMarkerFinder finder = Finder(view, Marker());

        using CameraFrame frame = Frame(picture);
        CameraFrame otherSize = frame;
        otherSize.Width = 320;
        CameraFrame empty = frame;
        empty.Pixels = default;
        foreach (CameraFrame wrong in new[] { otherSize, empty })
        {
            Assert.False(finder.TryFind(wrong, PoseOf(view), view.Order, out _, out string? refusal));
            Assert.Equal(LandingMarkerFinder.NoPicture, refusal);
        }
    }

    [Fact]
    public void Find_DirectionOfTheCameraNotKnown_IsRefusedUnlessItIsFixed()
    {
        TestView view = View();
        byte[] picture = PrintedTag.Show(view, new PrintedTag(0.3, 0, SideMetres));
        using CameraFrame frame = Frame(picture);
        Assert.False(Finder(view, Marker()).TryFind(frame, PoseOf(view), null, out _, out string? refusal));
        Assert.Equal(LandingMarkerFinder.NoDirection, refusal);

        // Right in the picture is right, down in it is back.
        var mount = new CameraMount
        {
            FixedBodyFromCamera = Rotation.FromEuler(EulerAngles.FromRadians(0, 0, Math.PI / 2)),
            GimbalLeverArmMetres = view.Mount.GimbalLeverArmMetres,
        };
        var finder = new LandingMarkerFinder(Marker(), view.Camera, mount);
        Assert.True(finder.TryFind(frame, PoseOf(view), null, out LandingTargetObservation found, out _));
        Assert.Equal(0.3, found.PositionMetres.Forward, 0.02);

        // What the gimbal reports counts more than what it was pointed by.
        Pose reported = PoseOf(view);
        reported.Gimbal = GimbalAttitude.AgainstBody(Angle.FromDegrees(-90), Angle.Zero);
        ImagingCommand ahead = default;
        Assert.True(Finder(view, Marker()).TryFind(frame, reported, ahead, out found, out _));
        Assert.Equal(0.3, found.PositionMetres.Forward, 0.02);
    }

    [Theory]
    [InlineData(MarkerFamily.AprilTag36h11, 587, 0.4, "id 587")]
    [InlineData(MarkerFamily.ArUco4x4, -1, 0.4, "id -1")]
    [InlineData((MarkerFamily)9, 0, 0.4, "family 9")]
    [InlineData(MarkerFamily.ArUco4x4, 0, 0, "is 0 m")]
    [InlineData(MarkerFamily.ArUco4x4, 0, 400, "is 400 m")]
    [InlineData(MarkerFamily.ArUco4x4, 0, double.NaN, "is NaN m")]
    public void Options_Wrong_AreNamed(MarkerFamily family, int id, double sideMetres, string named)
    {
        var options = new LandingMarkerOptions { Family = family, Id = id, SideMetres = sideMetres };

        Assert.Contains(named, Assert.Single(options.FindFaults()), StringComparison.Ordinal);
    }

    internal static TestView View() => new() { Position = GeodeticPosition.FromRadians(0.8, 0.15, 505) };

    internal static LandingMarkerOptions Marker() => new() { SideMetres = SideMetres };

    private static LandingTargetObservation Found(
        TestView view, byte[] picture, LandingMarkerOptions? marker = null)
    {
        using CameraFrame frame = Frame(picture);
        Assert.True(Finder(view, marker ?? Marker()).TryFind(
            frame, PoseOf(view), view.Order, out LandingTargetObservation found, out string? refusal));
        Assert.Null(refusal);
        return found;
    }

    private static string? Refusal(TestView view, byte[] picture, LandingMarkerOptions? marker = null)
    {
        using CameraFrame frame = Frame(picture);
        Assert.False(Finder(view, marker ?? Marker()).TryFind(
            frame, PoseOf(view), view.Order, out _, out string? refusal));
        return refusal;
    }

    private static LandingMarkerFinder Finder(TestView view, LandingMarkerOptions marker)
        => new(marker, view.Camera, view.Mount);

    private static CameraFrame Frame(byte[] picture)
    {
        var pool = new BufferPool("test", 1, picture.Length);
        Assert.True(pool.TryRent("test", out BufferLease lease));
        picture.CopyTo(lease.Array, 0);
        return new CameraFrame
        {
            Number = 3,
            Width = Painting.Width,
            Height = Painting.Height,
            FrameStart = TimeSpan.FromSeconds(2),
            Exposure = TimeSpan.FromMilliseconds(2),
            Pixels = lease,
        };
    }

    private static Pose PoseOf(TestView view) => new()
    {
        Time = TimeSpan.FromSeconds(2.001),
        Position = view.Position,
        Attitude = Rotation.FromEuler(view.Attitude),
    };

    private static double Spread(Random random, double most) => ((2 * random.NextDouble()) - 1) * most;

    private static void AssertNear(double tolerance, int seed, double expected, double actual)
        => Assert.True(
            Math.Abs(expected - actual) <= tolerance, $"seed {seed}: {expected:F3} expected, {actual:F3} found");
}
