using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.CameraGeometry;
using Xunit;

namespace Rabit.Uav.Tests.Geometry;

public sealed class CameraTests
{
    [Fact]
    public void Undistort_AllOverThePicturesOfAllCameras_IsUndoneByProject()
    {
        for (int index = 0; index < 6; index++)
        {
            CameraModel camera = CameraVectors.Camera(index);
            for (int i = 0; i <= 20; i++)
            {
                for (int j = 0; j <= 20; j++)
                {
                    double column = (camera.Width - 1) * i / 20.0;
                    double row = (camera.Height - 1) * j / 20.0;
                    Assert.True(camera.TryUndistort(column, row, out double x, out double y));
                    Assert.True(camera.TryProject(3 * x, 3 * y, 3, out double backColumn, out double backRow));
                    Assert.Equal(column, backColumn, 1e-8);
                    Assert.Equal(row, backRow, 1e-8);
                }
            }
        }
    }

    [Fact]
    public void Undistort_LensThatFolds_SaysSoInsteadOfGivingADirection()
    {
        // x (1 - x^2) is largest, 0.385, at 0.577: beyond that no direction gives the pixel.
        var camera = new CameraModel
        {
            Width = 640,
            Height = 480,
            FocalX = 500,
            FocalY = 500,
            CentreX = 320,
            CentreY = 240,
            K1 = -1
        };
        Assert.True(camera.TryUndistort(320 + (500 * 0.3), 240, out double x, out _));
        Assert.Equal(0.3, x * (1 - (x * x)), 1e-9);
        Assert.False(camera.TryUndistort(320 + (500 * 0.45), 240, out _, out _));
        Assert.Contains("cannot be undone", camera.FindFaults().Single(), StringComparison.Ordinal);
    }

    [Fact]
    public void Project_BehindTheCamera_IsFalse()
    {
        Assert.False(CameraVectors.Camera(0).TryProject(0, 0, 0, out _, out _));
        Assert.False(CameraVectors.Camera(0).TryProject(0.1, 0, -1, out _, out _));
    }

    [Fact]
    public void FindFaults_BadCameraOrMount_NamesThem()
    {
        Assert.Equal(2, new CameraModel { Width = 0, Height = 480, FocalX = 0, FocalY = 500 }.FindFaults().Count());
        Assert.Single(
            new CameraModel { Width = 640, Height = 480, FocalX = 500, FocalY = 500, K1 = double.NaN }.FindFaults());
        Assert.Empty(CameraVectors.Camera(3).FindFaults());
        Assert.Empty(new CameraMount().FindFaults());
        Assert.Single(new CameraMount { FixedBodyFromCamera = default(Rotation) }.FindFaults());
        Assert.Equal(3, new CameraMount
        {
            MisalignmentRoll = Angle.NaN,
            GimbalLeverArmMetres = new BodyVector(double.PositiveInfinity, 0, 0),
            CameraLeverArmMetres = new BodyVector(0, double.NaN, 0),
        }.FindFaults().Count());
    }

    [Fact]
    public void Mount_StraightDown_HasTheTopOfThePictureForward()
    {
        CameraExtrinsics placement = new CameraMount().At(Angle.FromDegrees(-90), Angle.Zero);
        AssertAxis(placement, (0, 0, 1), forward: 0, right: 0, down: 1);
        AssertAxis(placement, (0, -1, 0), forward: 1, right: 0, down: 0);
        AssertAxis(placement, (1, 0, 0), forward: 0, right: 1, down: 0);
    }

    [Fact]
    public void Mount_ForwardAndToTheSide_PointsThere()
    {
        AssertAxis(new CameraMount().At(Angle.Zero, Angle.Zero), (0, 0, 1), forward: 1, right: 0, down: 0);
        AssertAxis(new CameraMount().At(Angle.Zero, Angle.FromDegrees(90)), (0, 0, 1), forward: 0, right: 1, down: 0);
        AssertAxis(
            new CameraMount().At(Angle.FromDegrees(-45), Angle.Zero), (0, 0, 1), Math.Sqrt(0.5), 0, Math.Sqrt(0.5));
    }

    [Fact]
    public void Mount_FromAMatrix_IsTheSameAsTheAnglesThatItStandsFor()
    {
        // Straight down: the columns are the camera's axes in the body.
        var byMatrix = new CameraMount
        {
            FixedBodyFromCamera = Rotation.FromMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1),
            MisalignmentPitch = Angle.FromRadians(0.02),
            GimbalLeverArmMetres = new BodyVector(0.1, 0.2, 0.3),
            CameraLeverArmMetres = new BodyVector(0.05, -0.02, 0.01),
        };
        var byAngles = new CameraMount
        {
            MisalignmentPitch = Angle.FromRadians(0.02),
            GimbalLeverArmMetres = new BodyVector(0.1, 0.2, 0.3),
            CameraLeverArmMetres = new BodyVector(0.05, -0.02, 0.01),
        };
        CameraExtrinsics a = byMatrix.At(Angle.FromRadians(0.3), Angle.FromRadians(0.7));
        CameraExtrinsics b = byAngles.At(Angle.FromDegrees(-90), Angle.Zero);
        Assert.Equal(0, (a.BodyFromCamera.Inverse * b.BodyFromCamera).Angle.Radians, 1e-7);
        Assert.Equal(b.PositionMetres.Forward, a.PositionMetres.Forward, 1e-12);
        Assert.Equal(b.PositionMetres.Right, a.PositionMetres.Right, 1e-12);
        Assert.Equal(b.PositionMetres.Down, a.PositionMetres.Down, 1e-12);
    }

    [Fact]
    public void GroundRay_NearTheHorizonOrBelowGround_MeetsNothing()
    {
        Angle limit = Angle.FromDegrees(5);
        Assert.True(Ray(5.1).TryIntersectLevel(100, limit, out NedPosition point));
        Assert.Equal(100, point.Down);
        Assert.Equal(100 / Math.Tan(5.1 * Vectors.Degree), point.North, 1e-6);
        Assert.False(Ray(4.9).TryIntersectLevel(100, limit, out _));
        Assert.False(Ray(-30).TryIntersectLevel(100, limit, out _));
        Assert.False(Ray(45).TryIntersectLevel(-1, limit, out _));
        Assert.False(Ray(45).TryIntersectLevel(double.NaN, limit, out _));

        static GroundRay Ray(double depressionDegrees)
            => new(default, new NedVector(
                Math.Cos(depressionDegrees * Vectors.Degree), 0, Math.Sin(depressionDegrees * Vectors.Degree)));
    }

    private static void AssertAxis(
        CameraExtrinsics placement, (double X, double Y, double Z) axis, double forward, double right, double down)
    {
        (double x, double y, double z) = placement.BodyFromCamera.Apply(axis.X, axis.Y, axis.Z);
        Assert.Equal(forward, x, 1e-12);
        Assert.Equal(right, y, 1e-12);
        Assert.Equal(down, z, 1e-12);
    }
}
