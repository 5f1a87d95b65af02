using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Where a gimbal is pointed for a target, against angles that were worked out on paper.</summary>
public sealed class GimbalPointingTests
{
    private static readonly Rotation East = Rotation.FromEuler(EulerAngles.FromDegrees(0, 0, 90));

    [Theory]
    [InlineData(0, 0, 40, -90, 0)]               // below
    [InlineData(40, 0, 69.2820323, -60, 0)]      // tan 30 = 40 / 69.28 north
    [InlineData(20, 20, 48.9897949, -60, 45)]    // the same slope, 28.28 m away, to the north-east
    [InlineData(0, -20, 34.6410162, -60, -90)]   // to the west
    [InlineData(200, 0, 40, -50, 0)]             // far off: 40 degrees from straight down, not more
    public void Point_North_IsTheAngleToTheTarget(double north, double east, double down, double pitch, double yaw)
    {
        GimbalPointing pointing = Pointed(GimbalFrame.North, new NedVector(north, east, down), East);
        Assert.Equal(pitch, Degrees(pointing.PitchRadians), 1e-6);
        Assert.Equal(yaw, Degrees(pointing.YawRadians), 1e-6);
    }

    [Theory]
    [InlineData(40, 0, -90)]   // to the north of a vehicle that heads east: its left
    [InlineData(0, 40, 0)]
    [InlineData(-40, 0, 90)]
    public void Point_Heading_YawIsAgainstTheHeading(double north, double east, double yaw)
    {
        GimbalPointing pointing = Pointed(GimbalFrame.Heading, new NedVector(north, east, 69.2820323), East);
        Assert.Equal(-60, Degrees(pointing.PitchRadians), 1e-6);
        Assert.Equal(yaw, Degrees(pointing.YawRadians), 1e-6);
    }

    // With its nose 20 degrees up a vehicle that heads east has what is 30 degrees ahead 10 degrees ahead.
    [Fact]
    public void Point_Body_IsAgainstTheVehicleAsItLeans()
    {
        GimbalPointing pointing = Pointed(
            GimbalFrame.Body, new NedVector(0, 40, 69.2820323), Rotation.FromEuler(EulerAngles.FromDegrees(0, 20, 90)));
        Assert.Equal(-80, Degrees(pointing.PitchRadians), 1e-6);
        Assert.Equal(0, Degrees(pointing.YawRadians), 1e-6);
    }

    [Fact]
    public void Point_TargetPassesBelow_YawTurnsAsFastAsGimbalsDo()
    {
        var pointing = new GimbalPointing(GimbalFrame.North, yawRadians: 0);
        var behind = new NedVector(-20, 0.001, 34.6410162);
        pointing.Point(behind, Rotation.Identity, seconds: 0.5);
        Assert.Equal(30, Degrees(pointing.YawRadians), 1e-6);
        Assert.Equal(-90, Degrees(pointing.PitchRadians), 1e-6);   // nothing of it is that way: straight down meanwhile

        // Turned by 120 degrees half of the way is on its side: atan(10 / 34.64).
        pointing.Point(behind, Rotation.Identity, seconds: 1.5);
        Assert.Equal(120, Degrees(pointing.YawRadians), 1e-6);
        Assert.Equal(-73.8978862, Degrees(pointing.PitchRadians), 2e-3);
        pointing.Point(behind, Rotation.Identity, seconds: 1.5);
        Assert.Equal(180, Degrees(pointing.YawRadians), 0.01);
        Assert.Equal(-60, Degrees(pointing.PitchRadians), 0.01);
    }

    [Fact]
    public void Point_AlmostBelow_YawStays()
    {
        var pointing = new GimbalPointing(GimbalFrame.North, yawRadians: 0.5);
        pointing.Point(new NedVector(0, -4, 40), Rotation.Identity, seconds: 1);   // 5.7 degrees off
        Assert.Equal(0.5, pointing.YawRadians, 9);
    }

    private static GimbalPointing Pointed(GimbalFrame frame, NedVector target, Rotation attitude)
    {
        var pointing = new GimbalPointing(frame, yawRadians: 0);
        pointing.Point(target, attitude, seconds: 10);
        return pointing;
    }

    private static double Degrees(double radians) => radians * 180 / Math.PI;
}
