using System;
using System.IO;
using System.Text;

using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;
using Rabit.Vision.Tests.Pictures;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

/// <summary>camera.json: the focal length in each of its ways, lenses, the readout.</summary>
public sealed class CameraModelDescriptionTests : IDisposable
{
    private const string Pixels = "\"fx\":600,\"fy\":601,\"cx\":322,\"cy\":238";
    private const string Plain = "\"distortion\":[0,0,0,0,0]";

    private readonly SamplePictures.TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("\"horizontalFieldOfViewDegrees\":90", 320, 0.01)]
    [InlineData("\"focalLengthMillimetres\":4.5,\"sensorWidthMillimetres\":6", 480, 0.01)]
    [InlineData("\"focalLength35MillimetreEquivalentMillimetres\":27", 480, 0.0414)]
    [InlineData("\"horizontalFieldOfViewDegrees\":90,\"focalLengthError\":0.05", 320, 0.05)]
    public void Open_FocalLengthOfADataSheet_IsInPixelsWithItsError(string focal, double pixels, double error)
    {
        CameraModel camera = Open(focal);

        Assert.Equal(pixels, camera.FocalX, 1e-9);
        Assert.Equal(camera.FocalX, camera.FocalY);
        Assert.Equal((319.5, 239.5), (camera.CentreX, camera.CentreY));
        Assert.Equal(error, camera.FocalLengthError, 1e-4);
        Assert.Equal(0, camera.K1);
    }

    [Fact]
    public void Open_CalibratedCamera_HasNoErrorOfItsFocalLength()
    {
        CameraModel camera = Open(Pixels + "," + Plain);

        Assert.Equal((600, 601, 322, 238), (camera.FocalX, camera.FocalY, camera.CentreX, camera.CentreY));
        Assert.Equal(0, camera.FocalLengthError);
    }

    [Fact]
    public void Open_RationalLensAndFisheye_HaveTheirCoefficientsInOpenCvsOrder()
    {
        CameraModel rational = Open(Pixels + ",\"distortion\":[0.1,0.02,0.003,0.004,0.005,0.06,0.007,0.0008]");
        Assert.Equal(
            (0.1, 0.02, 0.003, 0.004, 0.005), (rational.K1, rational.K2, rational.P1, rational.P2, rational.K3));
        Assert.Equal((0.06, 0.007, 0.0008), (rational.K4, rational.K5, rational.K6));

        CameraModel fisheye = Open(Pixels + ",\"lens\":\"fisheye\",\"distortion\":[0.1,0.02,0.003,0.0004]");
        Assert.Equal(LensModel.Fisheye, fisheye.Lens);
        Assert.Equal((0.1, 0.02, 0.003, 0.0004), (fisheye.K1, fisheye.K2, fisheye.K3, fisheye.K4));
        Assert.Equal((0, 0), (fisheye.P1, fisheye.P2));
    }

    [Theory]
    [InlineData("\"readoutMicroseconds\":8750.5", 87505)]
    [InlineData("\"rowReadoutMicroseconds\":8.75", 42000)]
    public void Open_Readout_IsOfTheWholePictureInFullPrecision(string readout, long ticks)
        => Assert.Equal(ticks, Open($"{Pixels},{Plain},{readout}").Readout.Ticks);

    [Theory]
    [InlineData(Pixels + "," + Plain + ",\"horizontalFieldOfViewDegrees\":60", "in 2 ways")]
    [InlineData("\"horizontalFieldOfViewDegrees\":180", "is 180; it must be above 0 and below 180")]
    [InlineData("\"focalLengthMillimetres\":4", "camera.sensorWidthMillimetres is missing")]
    [InlineData("\"focalLengthMillimetres\":4,\"sensorWidthMillimetres\":0", "must be above 0")]
    [InlineData("\"focalLength35MillimetreEquivalentMillimetres\":-1", "is -1; it must be above 0")]
    [InlineData("\"lens\":\"fisheye\",\"horizontalFieldOfViewDegrees\":90,\"distortion\":[0,0,0,0]", "by fx and fy")]
    [InlineData(Pixels + ",\"lens\":\"fisheye\"," + Plain, "must be a list of 4 numbers")]
    [InlineData(Pixels + ",\"lens\":\"fish\"," + Plain, "must be one of brownConrady, fisheye")]
    [InlineData(Pixels + ",\"distortion\":[0,0,0,0]", "must be a list of 5 or 8 numbers")]
    [InlineData(Pixels, "camera.distortion is missing")]
    [InlineData(Pixels + "," + Plain + ",\"readoutMicroseconds\":1,\"rowReadoutMicroseconds\":1", "has both")]
    [InlineData(Pixels + "," + Plain + ",\"readoutMicroseconds\":1e30", "read in 86400000 ms; it must be 0 to 500 ms")]
    [InlineData(Pixels + "," + Plain + ",\"focalLengthError\":1", "error of the camera's focal length is 1")]
    public void Open_WrongCamera_SaysWhy(string wrong, string reason)
        => Assert.Contains(
            reason, Assert.Throws<PictureException>(() => Open(wrong)).Message, StringComparison.Ordinal);

    [Fact]
    public void Open_FocalLengthInTwoWays_DoesNotCallOneOfThemUnknown()
        => Assert.DoesNotContain(
            "unknown",
            Assert.Throws<PictureException>(
                () => Open(Pixels + "," + Plain + ",\"horizontalFieldOfViewDegrees\":60")).Message,
            StringComparison.Ordinal);

    [Theory]
    [InlineData(LensModel.BrownConrady, 0.02)]
    [InlineData(LensModel.BrownConrady, 0)]
    [InlineData(LensModel.Fisheye, 0.02)]
    public void Create_ThenOpen_GivesTheSameCamera(LensModel lens, double k4)
    {
        bool isFisheye = lens == LensModel.Fisheye;
        var camera = new CameraModel
        {
            Width = 640,
            Height = 480,
            FocalX = 300.5,
            FocalY = 301,
            CentreX = 320,
            CentreY = 240,
            FocalLengthError = 0.02,
            Lens = lens,
            K1 = 0.01,
            K2 = 0.02,
            P1 = isFisheye ? 0 : 1e-3,
            P2 = isFisheye ? 0 : 2e-3,
            K3 = 0.001,
            K4 = k4,
            K5 = isFisheye ? 0 : k4 / 10,
            Readout = TimeSpan.FromTicks(123_457),
        };

        CameraFolder.Create(_folder.Path, camera, new CameraMount());
        CameraModel read = CameraFolder.Open(_folder.Path).Camera;

        Assert.Equal(
            (camera.Lens, camera.FocalLengthError, camera.Readout), (read.Lens, read.FocalLengthError, read.Readout));
        Assert.Equal((camera.FocalX, camera.FocalY, camera.CentreX), (read.FocalX, read.FocalY, read.CentreX));
        Assert.Equal((camera.K1, camera.K2, camera.P1, camera.P2), (read.K1, read.K2, read.P1, read.P2));
        Assert.Equal((camera.K3, camera.K4, camera.K5, camera.K6), (read.K3, read.K4, read.K5, read.K6));
    }

    private CameraModel Open(string camera)
    {
        string json = "{\"camera\":{\"width\":640,\"height\":480," + camera
            + ",\"mount\":{\"bodyFromCamera\":[[0,-1,0],[1,0,0],[0,0,1]],\"leverArmBodyMetres\":[0,0,0]}}}";
        File.WriteAllBytes(Path.Combine(_folder.Path, CameraFolder.DescriptionFile), Encoding.UTF8.GetBytes(json));
        return CameraFolder.Open(_folder.Path).Camera;
    }
}
