using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Geodesy.Tests;
using Rabit.Uav.CameraGeometry;
using Xunit;

namespace Rabit.Uav.Tests.Geometry;

/// <summary>Wide-angle lenses against OpenCV (tests/data/camera/make_lenses.py).</summary>
public sealed class LensTests
{
    private static readonly JsonElement Lenses = JsonDocument.Parse(File.ReadAllBytes(Path.Combine(
        Path.GetDirectoryName(typeof(LensTests).Assembly.Location)!, "data", "camera", "lenses.json"))).RootElement;

    [Theory]
    [InlineData("rational")]
    [InlineData("fisheye")]
    public void Project_DirectionsOfOpenCv_GivesItsPixels(string kind)
    {
        int count = 0;
        foreach ((CameraModel camera, double[] p) in Points(kind))
        {
            Assert.Empty(camera.FindFaults());
            Assert.True(camera.TryProject(p[0], p[1], p[2], out double column, out double row));
            Assert.Equal(p[3], column, 1e-7);
            Assert.Equal(p[4], row, 1e-7);
            count++;
        }

        Assert.Equal(100, count);
    }

    [Theory]
    [InlineData("rational")]
    [InlineData("fisheye")]
    public void Undistort_PixelsOfOpenCv_GivesItsDirections(string kind)
    {
        foreach ((CameraModel camera, double[] p) in Points(kind))
        {
            Assert.True(camera.TryUndistort(p[3], p[4], out double x, out double y));
            var wanted = new NedVector(p[0], p[1], p[2]);
            var found = new NedVector(x, y, 1);
            NedVector apart = wanted.Normalized() - found.Normalized();
            Assert.Equal(0, apart.Length, 1e-9);
        }
    }

    [Fact]
    public void Project_BeyondTheFoldOfALens_IsFalse()
    {
        // x (1 - 0.3 x^2) is largest at 46.5 degrees; beyond, it falls, and past 61 degrees is on the other side.
        var camera = new CameraModel
        {
            Width = 640,
            Height = 480,
            FocalX = 600,
            FocalY = 600,
            CentreX = 320,
            CentreY = 240,
            K1 = -0.3,
        };
        Assert.Empty(camera.FindFaults());
        for (double degrees = 1; degrees < 90; degrees += 1)
        {
            double x = Math.Tan(degrees * Vectors.Degree);
            Assert.Equal(degrees < 46.5, camera.TryProject(0.8 * x, 0.6 * x, 1, out double column, out double row));
            Assert.Equal(degrees < 46.5, !double.IsNaN(column + row));
        }
    }

    [Fact]
    public void Undistort_FisheyeOutsideItsCircle_IsFalse()
    {
        var camera = new CameraModel
        {
            Width = 1000,
            Height = 1000,
            FocalX = 300,
            FocalY = 300,
            CentreX = 500,
            CentreY = 500,
            Lens = LensModel.Fisheye,
        };
        Assert.Empty(camera.FindFaults());
        Assert.True(camera.TryUndistort(500 + (300 * 88.9 * Vectors.Degree), 500, out double x, out _));
        Assert.Equal(Math.Tan(88.9 * Vectors.Degree), x, 1e-6);
        Assert.False(camera.TryUndistort(500 + (300 * 89.1 * Vectors.Degree), 500, out _, out _));
        Assert.False(camera.TryUndistort(0, 0, out _, out _));
        Assert.True(camera.TryUndistort(500, 500, out x, out double y));
        Assert.Equal((0, 0), (x, y));
        Assert.False(camera.TryProject(1, 0, Math.Tan(0.9 * Vectors.Degree), out _, out _));
    }

    [Fact]
    public void Undistort_FisheyeThatFolds_SaysSo()
    {
        // theta (1 - 0.5 theta^2) is largest, 0.544, at 0.816.
        var camera = new CameraModel
        {
            Width = 400,
            Height = 400,
            FocalX = 400,
            FocalY = 400,
            CentreX = 200,
            CentreY = 200,
            Lens = LensModel.Fisheye,
            K1 = -0.5,
        };
        Assert.True(camera.TryUndistort(200 + (400 * 0.5), 200, out double x, out _));
        double theta = Math.Atan(x);
        Assert.Equal(0.5, theta * (1 - (0.5 * theta * theta)), 1e-9);
        Assert.False(camera.TryUndistort(200 + (400 * 0.55), 200, out _, out _));
        Assert.False(camera.TryProject(Math.Tan(1), 0, 1, out _, out _));
    }

    [Fact]
    public void FindFaults_WrongLens_NamesIt()
    {
        Assert.Contains("k1 to k4 alone", Fault(new CameraModel
        {
            Width = 640,
            Height = 480,
            FocalX = 300,
            FocalY = 300,
            Lens = LensModel.Fisheye,
            P1 = 1e-3,
        }));
        Assert.Contains("lens is 7", Fault(new CameraModel
        {
            Width = 640,
            Height = 480,
            FocalX = 300,
            FocalY = 300,
            Lens = (LensModel)7,
        }));
        Assert.Contains("error of the camera's focal length", Fault(new CameraModel
        {
            Width = 640,
            Height = 480,
            FocalX = 300,
            FocalY = 300,
            FocalLengthError = double.NaN,
        }));
        Assert.Contains("cannot be undone", Fault(new CameraModel
        {
            // The circle is smaller than a quarter of the picture.
            Width = 640,
            Height = 480,
            FocalX = 30,
            FocalY = 30,
            CentreX = 320,
            CentreY = 240,
            Lens = LensModel.Fisheye,
        }));

        static string Fault(CameraModel camera) => Assert.Single(camera.FindFaults());
    }

    [Fact]
    public void FocalLength_OfDataSheets_IsThatOfTheirPinhole()
    {
        // Raspberry Pi camera module 2: 3.04 mm, 3.68 mm wide, 62.2 degrees, 29 mm equivalent.
        double bySensor = FocalLength.FromSensor(3280, 3.04, 3.68);
        Assert.Equal(2709.6, bySensor, 0.1);
        Assert.Equal(bySensor, FocalLength.FromFieldOfView(3280, Angle.FromDegrees(62.2)), 0.01 * bySensor);
        double byFilm = FocalLength.From35MillimetreEquivalent(3280, 29);
        Assert.Equal(bySensor, byFilm, 2 * FocalLength.ErrorOf35MillimetreEquivalent(29) * bySensor);
        Assert.Equal(0.0412, FocalLength.ErrorOf35MillimetreEquivalent(29), 1e-4);
    }

    private static IEnumerable<(CameraModel Camera, double[] Point)> Points(string kind)
    {
        foreach (JsonElement c in Lenses.Each(kind))
        {
            double[] k = c.Numbers("k");
            bool isFisheye = kind == "fisheye";
            var camera = new CameraModel
            {
                Width = c.GetProperty("width").GetInt32(),
                Height = c.GetProperty("height").GetInt32(),
                FocalX = c.Number("fx"),
                FocalY = c.Number("fy"),
                CentreX = c.Number("cx"),
                CentreY = c.Number("cy"),
                Lens = isFisheye ? LensModel.Fisheye : LensModel.BrownConrady,
                K1 = k[0],
                K2 = k[1],
                P1 = isFisheye ? 0 : k[2],
                P2 = isFisheye ? 0 : k[3],
                K3 = isFisheye ? k[2] : k[4],
                K4 = isFisheye ? k[3] : k[5],
                K5 = isFisheye ? 0 : k[6],
                K6 = isFisheye ? 0 : k[7],
            };
            foreach (JsonElement point in c.Each("points"))
                yield return (camera, point.EnumerateArray().Select(n => n.GetDouble()).ToArray());
        }
    }
}
