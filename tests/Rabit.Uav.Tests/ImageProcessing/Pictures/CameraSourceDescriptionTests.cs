using System;
using System.IO;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.ImageProcessing.VideoDevices;
using Rabit.Vision;
using Rabit.Vision.Tests.Pictures;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

/// <summary>The source of camera.json: where pictures come from that are not in the folder.</summary>
public sealed class CameraSourceDescriptionTests : IDisposable
{
    private readonly SamplePictures.TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Open_Program_GivesItsOptions()
    {
        CameraFolder folder = Open("""
            { "program": "rpicam-vid", "arguments": ["--width", "{width}", "--height", "{height}",
                "--framerate", "{framesPerSecond}", "-o", "-"],
              "format": "yuv420", "rowBytes": 704, "framesPerSecond": 7.5, "exposureMicroseconds": 2000, "latencyMicroseconds": 80000,
              "timeNoiseMicroseconds": 25000, "stallTimeoutSeconds": 3 }
            """);

        ProcessCameraOptions options = folder.Source!.Program!;
        Assert.Equal("rpicam-vid", options.Program);
        Assert.Equal(
            ["--width", "640", "--height", "480", "--framerate", "7.5", "-o", "-"], options.Arguments);
        Assert.Equal(
            (ProcessCameraFormat.Yuv420, 640, 480, 704, 7.5),
            (options.Format, options.Width, options.Height, options.RowBytes, options.MaxFramesPerSecond));
        Assert.Equal(
            (2.0, 80.0, 25.0, 3000.0),
            (options.Exposure.TotalMilliseconds, options.Latency.TotalMilliseconds,
                options.TimeNoise.TotalMilliseconds, options.StallTimeout.TotalMilliseconds));
        Assert.Equal("rpicam-vid", Assert.IsType<ProcessCamera>(folder.CreateCamera()).Name);
    }

    [Fact]
    public void Open_ProgramAlone_LeavesTheDefaults()
    {
        ProcessCameraOptions options = Open("""{ "program": "sub/camera.sh" }""").Source!.Program!;

        var defaults = new ProcessCameraOptions();
        Assert.Equal(Path.Combine(_folder.Path, "sub/camera.sh"), options.Program);
        Assert.Empty(options.Arguments);
        Assert.Equal(
            (ProcessCameraFormat.Mjpeg, null, defaults.Exposure, defaults.Latency, defaults.TimeNoise),
            (options.Format, options.MaxFramesPerSecond, options.Exposure, options.Latency, options.TimeNoise));
    }

    [Fact]
    public void Open_RowsThatCannotBe_AreRefused()
    {
        Exception fault = Assert.ThrowsAny<Exception>(
            () => Open("""{ "program": "sh", "format": "yuv420", "rowBytes": 639 }"""));

        Assert.Contains("source.rowBytes: it is 639; it must be even and 640 to 4736", fault.Message,
            StringComparison.Ordinal);
    }

    [LinuxFact]
    public void Open_ProgramWithMetadata_KeepsThePlaceForThePipe()
    {
        ProcessCameraOptions options = Open("""
            { "program": "rpicam-vid", "arguments": ["--metadata", "{metadata}"], "metadataTimeNoiseMicroseconds": 500 }
            """).Source!.Program!;

        Assert.Equal(["--metadata", "{metadata}"], options.Arguments);
        Assert.Equal(0.5, options.MetadataTimeNoise.TotalMilliseconds);
    }

    [Fact]
    public void Open_NoiseOfMetadataWithoutThem_IsRefused()
    {
        Exception fault = Assert.ThrowsAny<Exception>(
            () => Open("""{ "program": "sh", "metadataTimeNoiseMicroseconds": 500 }"""));

        Assert.Contains("metadataTimeNoiseMicroseconds is of use only where {metadata} stands in", fault.Message,
            StringComparison.Ordinal);
    }

    [LinuxFact]
    public void Open_Device_GivesItsOptions()
    {
        CameraFolder folder = Open("""
            { "device": "/dev/video7", "format": "yuyv", "framesPerSecond": 5, "exposureMicroseconds": 2000,
              "focus": 0, "timeNoiseMicroseconds": 8000 }
            """);

        V4l2CameraOptions options = folder.Source!.Device!;
        Assert.Equal(
            ("/dev/video7", V4l2PixelFormat.Yuyv, 640, 480, 5.0, 0),
            (options.Device, options.Format, options.Width, options.Height, options.FramesPerSecond, options.Focus));
        Assert.Equal(
            (2.0, null, 8.0, 5.0),
            (options.Exposure?.TotalMilliseconds, options.Latency, options.TimeNoise?.TotalMilliseconds,
                options.StallTimeout.TotalSeconds));
        Assert.Equal("/dev/video7", Assert.IsType<V4l2Camera>(folder.CreateCamera()).Name);
    }

    [Theory]
    [InlineData("""{ "device": "" }""", "source.device is empty")]
    [InlineData("""{ "device": "/dev/video0", "program": "x" }""", "source has both a program and a device")]
    [InlineData("""{ "device": "/dev/video0", "format": "yuv420" }""", "it must be one of mjpeg, yuyv")]
    [InlineData("""{ "device": "/dev/video0", "arguments": [] }""", "source.arguments is unknown")]
    [InlineData(
        """{ "device": "/dev/video0", "exposureMicroseconds": 1 }""", "source.exposureMicroseconds is 1; it must be 100 ")]
    [InlineData("""{ "device": "/dev/video0", "focus": 1.5 }""", "source.focus is 1.5; it must be a whole number")]
    public void Open_DeviceThatIsNone_NamesTheKey(string source, string expected)
        => Assert.Contains(
            expected, Assert.Throws<PictureException>(() => Open(source)).Reason, StringComparison.Ordinal);

    [Theory]
    [InlineData("{ }", "source.program is missing")]
    [InlineData("""{ "program": "" }""", "source.program is empty")]
    [InlineData("""{ "program": 3 }""", "source.program is 3; it must be a text")]
    [InlineData("""{ "program": "x", "arguments": "-o -" }""", "source.arguments is \"-o -\"; it must be a list")]
    [InlineData(
        """{ "program": "x", "arguments": ["-t", 0] }""", "source.arguments is [\"-t\", 0]; it must be a list of texts")]
    [InlineData("""{ "program": "x", "format": "h264" }""", "source.format is \"h264\"; it must be one of mjpeg, ")]
    [InlineData("""{ "program": "x", "framesPerSecond": 0 }""", "source.framesPerSecond is 0; it must be 0.1 to 1000")]
    [InlineData(
        """{ "program": "x", "arguments": ["{framesPerSecond}"] }""", "source.framesPerSecond is missing, and ")]
    [InlineData("""{ "program": "x", "latencyMicroseconds": -1 }""", "source.latencyMicroseconds is -1; it must be 0 ")]
    [InlineData(
        """{ "program": "x", "timeNoiseMicroseconds": 19999 }""", "source.timeNoiseMicroseconds is 19999; it must be 20000 ")]
    [InlineData("""{ "program": "x", "stallTimeoutSeconds": 0 }""", "source.stallTimeoutSeconds is 0; it must be 0.1 ")]
    [InlineData("""{ "program": "x", "argument": ["a"] }""", "source.argument is unknown; did you mean arguments?")]
    [InlineData("\"rpicam-vid\"", "source is missing or no object")]
    public void Open_SourceThatIsNone_NamesTheKey(string source, string expected)
        => Assert.Contains(
            expected, Assert.Throws<PictureException>(() => Open(source)).Reason, StringComparison.Ordinal);

    [Fact]
    public void Open_SourceAndListedPictures_IsRefused()
        => Assert.Contains(
            "both a source", Assert.Throws<PictureException>(() => Open("""{ "program": "x" }, "frames": []""")).Reason,
            StringComparison.Ordinal);

    [Theory]
    [InlineData("""{ "program": "x" }""")]
    [InlineData("""{ "program": "x", "format": "grey16" }""")]
    public void Open_ThermalProgram_WritesCounts(string source)
    {
        CameraFolder folder = Open(source, "grey16");
        Assert.Equal(PixelFormat.Grey16, folder.Camera.Format);
        Assert.Equal(ProcessCameraFormat.Grey16, folder.Source!.Program!.Format);
    }

    [Theory]
    [InlineData("""{ "program": "x", "format": "mjpeg" }""", "grey16", "source.format and camera.pixels do not match")]
    [InlineData("""{ "program": "x", "format": "grey16" }""", "rgb24", "source.format and camera.pixels do not match")]
    [InlineData("""{ "device": "/dev/video0" }""", "grey16", "source.device: video devices are read as cameras of colour")]
    [InlineData("""{ "program": "x" }""", "grey8", "camera.pixels is \"grey8\"; it must be one of rgb24, grey16")]
    public void Open_PixelsThatDoNotFit_NamesTheKey(string source, string pixels, string expected)
        => Assert.Contains(
            expected, Assert.Throws<PictureException>(() => Open(source, pixels)).Reason, StringComparison.Ordinal);

    private CameraFolder Open(string source, string pixels = "rgb24")
    {
        string file = _folder.File("nadir.json");
        File.WriteAllText(file, $$"""
            { "source": {{source}},
              "camera": { "width": 640, "height": 480, "pixels": "{{pixels}}", "horizontalFieldOfViewDegrees": 62,
                "mount": { "bodyFromCamera": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "leverArmBodyMetres": [0, 0, 0] } } }
            """);
        return CameraFolder.Open(file);
    }
}
