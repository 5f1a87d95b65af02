using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

// The real ffmpeg, with the first picture of its test source again and again.
public sealed partial class ProcessCameraTests
{
    private const int FilmWidth = 320;
    private const int FilmHeight = 240;
    private const string Film = "testsrc=size=320x240:rate=20";
    private const string OnePicture = "trim=end_frame=1,loop=loop=-1:size=1,setpts=N/(20*TB),realtime";

    // Compression and half the resolution of colour change a picture most at its edges; a wrong range, order of bytes
    // or place in the stream changes all of it.
    [FfmpegTheory]
    [InlineData(ProcessCameraFormat.Mjpeg, "-c:v mjpeg -q:v 2 -pix_fmt yuvj420p -f mjpeg")]
    [InlineData(ProcessCameraFormat.Yuv420, "-f rawvideo -pix_fmt yuv420p")]
    [InlineData(ProcessCameraFormat.Yuv420FullRange, "-f rawvideo -pix_fmt yuvj420p")]
    public void Read_RealFfmpeg_GivesItsPictures(ProcessCameraFormat format, string output)
    {
        ProcessCameraOptions options = Options("");
        options.Program = "ffmpeg";
        options.Arguments = [.. Source, "-vf", OnePicture, .. output.Split(' '), "-"];
        (options.Width, options.Height, options.Format) = (FilmWidth, FilmHeight, format);
        options.StallTimeout = MaxWait;   // a busy machine may take long to start it

        List<byte[]> pictures = Run(options, 5, out ProcessCamera camera);

        Assert.Equal((0, 0, null), (camera.PicturesRefused, camera.Restarts, camera.LastFault));
        byte[] expected = FirstPicture();
        Assert.All(pictures, p => Assert.InRange(MeanDifference(p, expected), 0, 4));
        Assert.Equal("arrival less 50 ms, standard deviation 20 ms", camera.Statistics.TimeSource);
    }

    [FfmpegTheory]
    [InlineData("no such source")]
    public void Read_RealFfmpegThatRefusesItsInput_IsAFaultWithItsWords(string source)
    {
        ProcessCameraOptions options = Options("");
        options.Program = "ffmpeg";
        options.Arguments =
            ["-nostdin", "-hide_banner", "-loglevel", "error", "-f", "lavfi", "-i", source, "-f", "mjpeg", "-"];

        Run(options, 0, out ProcessCamera camera, () => _log.Any(l => l.Contains("it ended with exit code")));

        Assert.Contains(_log, l => l.StartsWith("ffmpeg: ", StringComparison.Ordinal) && l.Contains("source"));
        Assert.Contains("it ended with exit code", camera.LastFault, StringComparison.Ordinal);
    }

    private static IEnumerable<string> Source
        => ["-nostdin", "-hide_banner", "-loglevel", "error", "-f", "lavfi", "-i", Film];

    // Red, green and blue as ffmpeg itself makes them.
    private static byte[] FirstPicture()
    {
        using var ffmpeg = new Process
        {
            StartInfo = new ProcessStartInfo(
                "ffmpeg", string.Join(" ", Source) + " -frames:v 1 -f rawvideo -pix_fmt rgb24 -")
            {
                UseShellExecute = false,
                RedirectStandardOutput = true,
            },
        };
        ffmpeg.Start();
        using var bytes = new MemoryStream();
        ffmpeg.StandardOutput.BaseStream.CopyTo(bytes);
        ffmpeg.WaitForExit();
        Assert.Equal(FilmWidth * FilmHeight * 3, bytes.Length);
        return bytes.ToArray();
    }

    private static double MeanDifference(byte[] picture, byte[] expected)
    {
        Assert.Equal(expected.Length, picture.Length);
        return picture.Zip(expected, (a, b) => Math.Abs(a - b)).Average();
    }
}
