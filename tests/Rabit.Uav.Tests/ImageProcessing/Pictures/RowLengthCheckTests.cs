using System;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;
using Rabit.Vision.Tests;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

public sealed class RowLengthCheckTests
{
    private const int Width = 616;
    private const int Height = 480;

    public static TheoryData<string> Pictures
    {
        get
        {
            var files = new TheoryData<string>();
            foreach (string file in Directory.GetFiles(
                Path.Combine(Repository.Root, "tests", "data", "detection", "stills"), "*.jpg"))
                files.Add(Path.GetFileName(file));
            return files;
        }
    }

    [Theory]
    [MemberData(nameof(Pictures))]
    public void Look_RowsOfAnotherLength_AreNamedOnceWithTheRightOne(string file)
    {
        byte[] padded = Brightness(file, rowBytes: 640);
        RowLengthCheck check = Check(rowBytes: null);

        string?[] lines = [.. Enumerable.Range(0, 7).Select(_ => check.Look(padded, 0))];

        Assert.Equal(
            "cam: rows of its raw pictures look as if they had 640 bytes, not 616: see rowBytes and the camera's size",
            Assert.Single(lines, l => l is not null));
        Assert.NotNull(lines[4]);
        Assert.Contains("616 bytes, not 640", LineOf(Check(640), Brightness(file, 616)), StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(Pictures))]
    public void Look_RowsOfTheirLength_SayNothing(string file)
    {
        Assert.Null(LineOf(Check(null), Brightness(file, Width)));
        Assert.Null(LineOf(Check(640), Brightness(file, 640)));
        Assert.Null(LineOf(Check(768), Brightness(file, 768)));
    }

    [RealPicturesFact("aerial")]
    public void Look_RealPhotos_AreTakenForWhatTheyAre()
    {
        string[] files = Directory.GetFiles(
            Path.Combine(RealPicturesFactAttribute.FolderOf("aerial")!, "small"), "*.jpg");
        int found = 0;
        foreach (string file in files)
        {
            RgbPicture photo = PictureFile.Load(file);
            int width = (photo.Width / 64 * 64) - 24;
            RowLengthCheck Check(int? rowBytes) => new(new ProcessCameraOptions
            {
                Program = "cam",
                Width = width,
                Height = photo.Height,
                Format = ProcessCameraFormat.Yuv420,
                RowBytes = rowBytes,
            });
            Assert.Null(LineOf(Check(null), Brightness(photo, width, photo.Height, width)));
            Assert.Null(LineOf(Check(width + 24), Brightness(photo, width, photo.Height, width + 24)));
            string? line = LineOf(Check(null), Brightness(photo, width, photo.Height, width + 24));
            Assert.True(line?.Contains($"had {width + 24} bytes") ?? true, line);
            found += line is null ? 0 : 1;
        }

        Assert.True(found > 0.9 * files.Length, $"{found} of {files.Length}");
    }

    [Fact]
    public void Look_ThermalRowsOfAnotherLength_AreNamed()
    {
        byte[] brightness = Brightness("f0004.jpg", Width);
        byte[] counts = new byte[1280 * Height];
        for (int at = 0; at < Width * Height; at++)
        {
            int count = 7000 + (20 * brightness[at]);
            int to = (1280 * (at / Width)) + (2 * (at % Width));
            (counts[to], counts[to + 1]) = ((byte)count, (byte)(count >> 8));
        }

        Assert.Contains(
            "had 1280 bytes, not 1232", LineOf(Check(null, ProcessCameraFormat.Grey16), counts),
            StringComparison.Ordinal);
        Assert.Null(LineOf(Check(1280, ProcessCameraFormat.Grey16), counts));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(255)]
    public void Look_PicturesWithoutContrast_SayNothing(int noise)
    {
        byte[] picture = new byte[1024 * Height];
        var random = new Random(1);
        for (int at = 0; at < picture.Length; at++)
            picture[at] = (byte)(noise == 0 ? 90 : random.Next(noise));

        Assert.Null(LineOf(Check(null), picture));
        Assert.Null(LineOf(Check(640), picture));
    }

    private static string? LineOf(RowLengthCheck check, byte[] picture)
        => Enumerable.Range(0, 7).Select(_ => check.Look(picture, 0)).FirstOrDefault(l => l is not null);

    private static RowLengthCheck Check(int? rowBytes, ProcessCameraFormat format = ProcessCameraFormat.Yuv420) => new(
        new ProcessCameraOptions
        {
            Program = "cam",
            Width = Width,
            Height = Height,
            Format = format,
            RowBytes = rowBytes,
        });

    // The upper part of a raw picture, and room for rows that are taken to be longer.
    private static byte[] Brightness(string file, int rowBytes) => Brightness(
        PictureFile.Load(Path.Combine(Repository.Root, "tests", "data", "detection", "stills", file)), Width, Height,
        rowBytes);

    private static byte[] Brightness(RgbPicture picture, int width, int height, int rowBytes)
    {
        byte[] raw = new byte[(rowBytes + 256) * height];
        for (int row = 0; row < height; row++)
        {
            for (int column = 0; column < width; column++)
                raw[(row * rowBytes) + column] = picture.Pixels[(3 * ((row * picture.Width) + column)) + 1];
        }

        return raw;
    }
}
