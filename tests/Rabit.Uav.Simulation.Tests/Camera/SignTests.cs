using System;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Camera;

/// <summary>
/// Which way is which. Each expectation is a line of trigonometry that can be checked with two hands, without any code.
/// </summary>
public class SignTests
{
    private const double Height = 40;
    private const double Focal = 265;

    private static readonly double Tan10 = Math.Tan(Scene.Degrees(10));

    public static TheoryData<double, double, double, double, double, double, double> Poses => new()
    {
        // roll, pitch, yaw, camera pitch, camera yaw: where the optical axis meets the ground, heights north and east.
        { 0, 0, 0, -90, 0, 0, 0 },
        { 10, 0, 0, -90, 0, 0, -Tan10 },             // right side down: the belly looks to the left, west
        { -10, 0, 0, -90, 0, 0, Tan10 },
        { 0, 10, 0, -90, 0, Tan10, 0 },              // nose up: the belly looks forward, north
        { 0, -10, 0, -90, 0, -Tan10, 0 },
        { 10, 0, 90, -90, 0, Tan10, 0 },             // flying east, left is north
        { 0, 10, 90, -90, 0, 0, Tan10 },
        { 10, 0, 180, -90, 0, 0, Tan10 },            // flying south, left is east
        { 0, 10, 180, -90, 0, -Tan10, 0 },
        { 0, 0, 0, -80, 0, Tan10, 0 },               // the gimbal looks 10 degrees before straight down
        { 0, 0, 0, -80, 90, 0, Tan10 },              // and the same to the right
        { 0, 0, 90, -80, 90, -Tan10, 0 },            // to the right of a nose that points east: south
        { 0, -10, 0, -80, 0, 0, 0 },                 // nose down by what the gimbal looks forward: straight down
        { 0, 0, 45, -45, 0, Math.Sqrt(0.5), Math.Sqrt(0.5) },
        { 0, 10, 0, -60, 0, Math.Tan(Scene.Degrees(40)), 0 },
    };

    [Theory]
    [MemberData(nameof(Poses))]
    public void OpticalAxis_AttitudeAndGimbal_PointsWhereItShould(
        double roll, double pitch, double yaw, double cameraPitch, double cameraYaw, double north, double east)
    {
        var scene = new Scene();

        (double u, double v, double pixels) = scene.Find(
            Scene.Pose(Height, roll, pitch, yaw, cameraPitch, cameraYaw), Scene.Panel(north * Height, east * Height));

        Assert.True(pixels > 10);
        Assert.Equal(160, u, 0.12);
        Assert.Equal(120, v, 0.12);
    }

    [Theory]
    [InlineData(0, 0, 5, 1, 0)]      // north up: east is to the right
    [InlineData(0, 5, 0, 0, -1)]     // and north is at the top
    [InlineData(0, -5, 0, 0, 1)]     // south at the bottom
    [InlineData(90, 0, 5, 0, -1)]    // east up
    [InlineData(90, 5, 0, -1, 0)]    // and north is to the left
    [InlineData(180, 5, 0, 0, 1)]
    [InlineData(-90, 5, 0, 1, 0)]
    public void Picture_NadirAndYaw_IsTheMapWithTheNoseUp(double yaw, double north, double east, int right, int down)
    {
        var scene = new Scene();

        (double u, double v, _) = scene.Find(Scene.Pose(Height, yaw: yaw), Scene.Panel(north, east, heading: 0.3));

        Assert.Equal(160 + (right * 5 * Focal / Height), u, 0.08);
        Assert.Equal(120 + (down * 5 * Focal / Height), v, 0.08);
    }

    [Theory]
    [InlineData(0, 2, 0, 0, 0, 1)]      // the camera is 2 m before: what is below the vehicle is at the bottom
    [InlineData(0, 0, 2, 0, -1, 0)]     // 2 m to the right: it is at the left
    [InlineData(90, 2, 0, 0, 0, 1)]     // the arm turns with the vehicle
    [InlineData(180, 0, 2, 0, -1, 0)]
    public void LeverArm_Level_MovesTheCamera(
        double yaw, double forward, double toTheRight, double below, int right, int down)
    {
        SimulatedCameraOptions options = Scene.Pinhole();
        (options.LeverArmForwardMetres, options.LeverArmRightMetres, options.LeverArmDownMetres) =
            (forward, toTheRight, below);
        var scene = new Scene(options);

        (double u, double v, _) = scene.Find(Scene.Pose(Height, yaw: yaw), Scene.Panel(0, 0));

        Assert.Equal(160 + (right * 2 * Focal / Height), u, 0.08);
        Assert.Equal(120 + (down * 2 * Focal / Height), v, 0.08);
    }

    [Fact]
    public void LeverArm_Down_BringsTheCameraNearer()
    {
        SimulatedCameraOptions options = Scene.Pinhole();
        options.LeverArmDownMetres = 20;

        (_, _, double pixels) = new Scene(options).Find(Scene.Pose(Height), Scene.Panel(0, 0, heading: 0.4));

        Assert.Equal(Math.Pow(Focal / 20, 2), pixels, 3.0);
    }

    [Theory]
    [InlineData(10, 0, 0, 0, -1)]    // like the roll of the vehicle
    [InlineData(0, 10, 0, 1, 0)]     // like its pitch
    public void Misalignment_OfTheMount_TurnsLikeTheVehicle(double roll, double pitch, double yaw, int north, int east)
    {
        SimulatedCameraOptions options = Scene.Pinhole();
        options.MisalignmentRoll = Angle.FromDegrees(roll);
        options.MisalignmentPitch = Angle.FromDegrees(pitch);
        options.MisalignmentYaw = Angle.FromDegrees(yaw);

        (double u, double v, _) = new Scene(options)
            .Find(Scene.Pose(Height), Scene.Panel(north * Tan10 * Height, east * Tan10 * Height));

        Assert.Equal(160, u, 0.12);
        Assert.Equal(120, v, 0.12);
    }

    [Fact]
    public void Misalignment_Yaw_TurnsThePictureLikeTheVehicle()
    {
        SimulatedCameraOptions options = Scene.Pinhole();
        options.MisalignmentYaw = Angle.FromDegrees(90);

        (double u, double v, _) = new Scene(options).Find(Scene.Pose(Height), Scene.Panel(5, 0));

        Assert.Equal(160 - (5 * Focal / Height), u, 0.08);
        Assert.Equal(120, v, 0.08);
    }

    [Fact]
    public void Panel_OneMetreAtFortyMetres_HasTheSizeOfTheFormula()
    {
        (_, _, double pixels) = new Scene().Find(Scene.Pose(Height), Scene.Panel(3, 4, heading: 0.5));

        Assert.Equal(Math.Pow(Focal / Height, 2), pixels, 1.0);
    }

    [Fact]
    public void Heading_OfAStrip_IsClockwiseFromNorth()
    {
        // 3 m by 0.3 m, pointing north-east: in a picture with north at the top from the lower left to the upper right.
        var strip = new SimulatedTarget
        {
            Heading = Angle.FromDegrees(45),
            SideMetres = 3,
            WidthMetres = 0.3,
            Surface = new SurfaceColour(212, 36, 150)
        };
        var scene = new Scene();
        scene.Find(Scene.Pose(10), strip);

        Assert.True(IsMagenta(scene, 160 + 20, 120 - 20));
        Assert.True(IsMagenta(scene, 160 - 20, 120 + 20));
        Assert.False(IsMagenta(scene, 160 + 20, 120 + 20));
        Assert.False(IsMagenta(scene, 160 - 20, 120 - 20));
    }

    private static bool IsMagenta(Scene scene, int u, int v)
    {
        int at = ((v * 320) + u) * 3;
        return scene.LastPicture[at] > 180 && scene.LastPicture[at + 1] < 60;
    }
}
