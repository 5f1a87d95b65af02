using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

// Programs that write raw pictures.
public sealed partial class ProcessCameraTests
{
    [ShellFact]
    public void Read_RawPictures_GivesThem()
    {
        byte[] raw = [.. Enumerable.Repeat((byte)235, 61 * 43), .. Enumerable.Repeat((byte)128, 2 * 31 * 22)];
        File.WriteAllBytes(_folder.File("raw"), [.. raw, .. raw.Take(100)]);
        ProcessCameraOptions options = Options("cat \"$1\"; sleep 60", _folder.File("raw"));
        options.Format = ProcessCameraFormat.Yuv420;

        Assert.All(Assert.Single(Run(options, 1, out _)), b => Assert.Equal(255, b));
    }

    // 61 columns in 64 bytes, as rpicam-vid writes them, with 7 and 9 behind the rows; colour of 31 in 32.
    [ShellFact]
    public void Read_RawPicturesWithPaddedRows_GivesTheirPixels()
    {
        byte[] brightness = [.. Enumerable.Repeat((byte)235, 61), 7, 7, 7];
        byte[] colour = [.. Enumerable.Repeat((byte)128, 31), 9];
        byte[] raw = [
            .. Enumerable.Repeat(brightness, 43).SelectMany(b => b),
            .. Enumerable.Repeat(colour, 2 * 22).SelectMany(b => b)];
        File.WriteAllBytes(_folder.File("raw"), [.. raw, .. raw]);
        ProcessCameraOptions options = Options(
            $"cat \"$1\"; {UntilRead(1)} cat \"$1\"; sleep 60", _folder.File("raw"));
        (options.Format, options.RowBytes) = (ProcessCameraFormat.Yuv420, 64);

        List<byte[]> pictures = Run(options, 2, out ProcessCamera camera);

        Assert.All(pictures.Take(2), p => Assert.All(p, b => Assert.Equal(255, b)));
        Assert.Equal(0, camera.PicturesRefused);
    }

    [ShellFact]
    public void Read_ThermalWithPaddedRows_GivesItsCounts()
    {
        byte[] counts = new byte[61 * 43 * 2];
        new Random(4).NextBytes(counts);
        File.WriteAllBytes(
            _folder.File("counts"),
            [.. Enumerable.Range(0, 43).SelectMany(r => counts.Skip(r * 122).Take(122).Concat(new byte[6]))]);
        ProcessCameraOptions options = Options("cat \"$1\"; sleep 60", _folder.File("counts"));
        (options.Format, options.RowBytes) = (ProcessCameraFormat.Grey16, 128);

        Assert.Equal(counts, Assert.Single(Run(options, 1, out _)).Take(counts.Length));
    }

    [Theory]
    [InlineData(ProcessCameraFormat.Mjpeg, 64, "those of mjpeg have no rows")]
    [InlineData(ProcessCameraFormat.Yuv420, 61, "it is 61; it must be even and 62 to 4158")]
    [InlineData(ProcessCameraFormat.Yuv420FullRange, 60, "it is 60; it must be even and 62 to 4158")]
    [InlineData(ProcessCameraFormat.Grey16, 120, "it is 120; it must be even and 122 to 4218")]
    [InlineData(ProcessCameraFormat.Yuv420, 4160, "it is 4160; it must be even and 62 to 4158")]
    public void Constructor_RowsThatCannotBe_AreRefused(ProcessCameraFormat format, int bytes, string fault)
    {
        ProcessCameraOptions options = Options("sleep 60");
        (options.Format, options.RowBytes) = (format, bytes);

        Assert.Contains(
            fault, Assert.Throws<ArgumentException>(() => new ProcessCamera(options)).Message,
            StringComparison.Ordinal);
    }

    [ShellFact]
    public void Read_Thermal_GivesItsCounts()
    {
        byte[] counts = new byte[61 * 43 * 2];
        new Random(3).NextBytes(counts);
        File.WriteAllBytes(_folder.File("counts"), [.. counts, .. counts.Take(100)]);
        ProcessCameraOptions options = Options("cat \"$1\"; sleep 60", _folder.File("counts"));
        options.Format = ProcessCameraFormat.Grey16;
        var frames = new List<CameraFrame>();

        byte[] read = Assert.Single(Run(options, 1, out ProcessCamera camera, frames: frames));
        Assert.Equal(counts, read.Take(counts.Length));
        Assert.Equal(PixelFormat.Grey16, frames[0].Format);
        Assert.Equal((1, 0), (camera.PicturesDelivered, camera.PicturesRefused));
    }
}
