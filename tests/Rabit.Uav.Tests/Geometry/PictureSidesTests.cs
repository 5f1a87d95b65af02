using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Xunit;

namespace Rabit.Uav.Tests.Geometry;

public sealed class PictureSidesTests
{
    [Theory]
    [InlineData(640, 480, 0, 90)]   // the columns lie across the vehicle
    [InlineData(640, 480, 90, 0)]
    [InlineData(480, 640, 0, 0)]
    [InlineData(640, 480, 30, 120)]
    public void LongerSide_StraightDown_IsThatOfThePicture(int width, int height, double yaw, double expected)
    {
        Angle? side = PictureSides.LongerSide(
            Camera(width, height), new CameraMount(), Angle.FromDegrees(-90), Angle.FromDegrees(yaw));
        Assert.Equal(0, HalfTurns(side!.Value.Degrees - expected), 1e-9);
    }

    [Theory]
    [InlineData(-60, 640, 480)]     // looks ahead: a turn of the vehicle moves what it sees
    [InlineData(-90, 500, 480)]     // nearly square
    public void LongerSide_ObliqueOrSquarePicture_IsNone(double pitch, int width, int height)
        => Assert.Null(PictureSides.LongerSide(
            Camera(width, height), new CameraMount(), Angle.FromDegrees(pitch), Angle.Zero));

    [Fact]
    public void LongerSide_FixedCamera_IsThatOfItsMount()
    {
        // Its columns run along the body: x of the camera forward, y to the right, z down.
        var mount = new CameraMount { FixedBodyFromCamera = Rotation.FromMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1) };
        Angle? side = PictureSides.LongerSide(Camera(640, 480), mount, Angle.Zero, Angle.Zero);
        Assert.Equal(0, HalfTurns(side!.Value.Degrees), 1e-9);
    }

    // Either end of a side is the same.
    private static double HalfTurns(double degrees) => Math.IEEERemainder(degrees, 180);

    private static CameraModel Camera(int width, int height) => new()
    {
        Width = width,
        Height = height,
        FocalX = 530,
        FocalY = 530,
        CentreX = (width - 1) / 2.0,
        CentreY = (height - 1) / 2.0,
    };
}
