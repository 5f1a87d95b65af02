using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Xunit;

namespace Rabit.Uav.Tests.Geometry;

public sealed class PictureSwathTests
{
    [Theory]
    [InlineData(0, 48.2264)]     // 639 columns / f 530 * 40 m
    [InlineData(90, 36.1509)]    // turned on its side: 479 rows
    [InlineData(180, 48.2264)]
    public void WidthMetres_StraightDown_IsThatOfThePicture(double yaw, double expected)
        => Assert.Equal(expected, Width(pitch: -90, yaw: yaw), 3);

    // The far border of an oblique picture is the wider one: what it sees passes through all of the picture.
    [Fact]
    public void WidthMetres_Oblique_IsThatOfTheFarBorder() => Assert.InRange(Width(pitch: -60, yaw: 0), 70, 80);

    [Fact]
    public void WidthMetres_BorderAtTheHorizon_HasNoLimit()
        => Assert.Equal(double.PositiveInfinity, Width(pitch: -20, yaw: 0));

    [Fact]
    public void WidthMetres_FixedCamera_IsThatOfItsMount()
    {
        // Its columns run along the body: x of the camera forward, y to the left, z down.
        var mount = new CameraMount { FixedBodyFromCamera = Rotation.FromMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1) };

        Assert.Equal(36.1509, PictureSwath.WidthMetres(Camera, mount, Angle.Zero, Angle.Zero, 40), 3);
    }

    private static CameraModel Camera => new()
    {
        Width = 640,
        Height = 480,
        FocalX = 530,
        FocalY = 530,
        CentreX = 319.5,
        CentreY = 239.5,
    };

    private static double Width(double pitch, double yaw) => PictureSwath.WidthMetres(
        Camera, new CameraMount(), Angle.FromDegrees(pitch), Angle.FromDegrees(yaw), heightMetres: 40);
}
