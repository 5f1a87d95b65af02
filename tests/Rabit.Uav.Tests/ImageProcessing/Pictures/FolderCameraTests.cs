using System;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.Tests.ImageProcessing.VideoDevices;
using Rabit.Vision;
using Rabit.Vision.Tests.Pictures;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

public sealed class FolderCameraTests : IDisposable
{
    private static readonly TimeSpan Second = TimeSpan.FromSeconds(1);

    private FolderCameraRig _rig = new();

    public void Dispose() => _rig.Dispose();

    [Fact]
    public void Read_RecordedFolder_GivesPicturesAtTheirTimesInTheirOrder()
    {
        _rig.Write(8, At(2.5));
        _rig.Write(7, At(1.25));
        _rig.Write(3, At(-0.001));

        _rig.RunFor(At(5));

        Assert.Equal([7, 8], _rig.Taken.Select(t => t.Frame.Number));
        Assert.Equal([At(1.25), At(2.5)], _rig.Taken.Select(t => t.Frame.FrameStart));
        Assert.Equal([At(1.252), At(2.502)], _rig.Taken.Select(t => t.Time));
        Assert.All(_rig.Taken, t => Assert.Equal(TimeSpan.FromMilliseconds(2), t.Frame.Exposure));
        Assert.All(_rig.Taken, t => Assert.Equal((byte)t.Frame.Number, t.Pixels[0]));
        Assert.Equal(SamplePictures.Pixels().Skip(1), _rig.Taken[0].Pixels.Skip(1));
        Assert.Equal(
            (2, 1, 0), (_rig.Camera.PicturesDelivered, _rig.Camera.PicturesBeforeRun, _rig.Camera.PicturesRefused));
        Assert.Null(_rig.Camera.LastRefusal);
    }

    [Theory]
    [InlineData("", 5)]
    [InlineData("\"timeNoiseMicroseconds\": 1500", 1.5)]
    [InlineData("\"timeNoiseMicroseconds\": 0", 0)]
    public void Read_TimeNoise_IsThatOfTheDescription(string key, double milliseconds)
    {
        _rig.Describe(key);
        _rig.Write(1, At(0.5));

        _rig.RunFor(At(1));

        Assert.Equal(milliseconds, _rig.Taken.Single().Frame.TimeNoise.TotalMilliseconds);
        Assert.Equal(
            FormattableString.Invariant(
                $"names of the pictures or camera.json, standard deviation {milliseconds} ms"),
            _rig.Camera.Statistics.TimeSource);
    }

    [Theory]
    [InlineData("-1", "timeNoiseMicroseconds is -1; it must be 0 to 10000000")]
    [InlineData("\"5\"", "timeNoiseMicroseconds is \"5\"; it must be a number")]
    [InlineData("5, \"source\": { \"program\": \"x\" }", "that of a source is source.timeNoiseMicroseconds")]
    public void Open_TimeNoiseThatIsNone_IsRefused(string value, string expected)
    {
        string key = "\"timeNoiseMicroseconds\": " + value;

        Assert.Contains(
            expected, Assert.Throws<PictureException>(() => _rig.Describe(key)).Reason, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_GrowingFolder_GivesEachPictureSoon()
    {
        for (int number = 0; number < 20; number++)
        {
            _rig.RunFor(At(0.5));
            _rig.Write(number, At((0.5 * number) + 0.4));
        }

        _rig.RunFor(At(2));

        Assert.Equal(Enumerable.Range(0, 20).Select(n => (long)n), _rig.Taken.Select(t => t.Frame.Number));
        for (int number = 0; number < 20; number++)
        {
            Assert.Equal(At((0.5 * number) + 0.4), _rig.Taken[number].Frame.FrameStart);
            Assert.InRange(_rig.Taken[number].Time - At(0.5 * (number + 1)), TimeSpan.Zero, At(1));
        }
    }

    [Fact]
    public void Read_ThermalCamera_GivesCountsAndRefusesPicturesOfEightBits()
    {
        _rig.Dispose();
        _rig = new FolderCameraRig(format: PixelFormat.Grey16);
        _rig.Reopen();   // the format is in camera.json
        (int width, int height) = (SamplePictures.Width, SamplePictures.Height);
        byte[] header = Encoding.ASCII.GetBytes($"P5\n{width} {height}\n65535\n");
        byte[] counts = new byte[width * height * 2];
        (counts[0], counts[1]) = (0x1C, 0x84);   // 7300; a PGM has the higher byte first
        File.WriteAllBytes(_rig.PathOf("f000001_" + Micros(1) + "_e2000.pgm"), [.. header, .. counts]);
        File.WriteAllBytes(
            _rig.PathOf("f000002_" + Micros(2) + "_e2000.png"),
            PngPicture.Encode(new RgbPicture(width, height, SamplePictures.Pixels())));

        _rig.RunFor(At(5));

        Assert.Equal(PixelFormat.Grey16, Assert.Single(_rig.Taken).Frame.Format);
        Assert.Equal([0x84, 0x1C], _rig.Taken[0].Pixels.Take(2));
        Assert.Equal(1, _rig.Camera.PicturesRefused);
        Assert.Contains("it has no 16 bits of grey", _rig.Camera.LastRefusal, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_OtherThingsInTheFolder_AreLeftAloneOrCounted()
    {
        File.WriteAllText(_rig.PathOf("f000001_" + Micros(1) + "_e2000.png.part"), "half a picture");
        File.WriteAllText(_rig.PathOf("notes.txt"), "x");
        File.WriteAllText(_rig.PathOf("holiday.png"), "x");
        File.WriteAllText(_rig.PathOf("f000001_" + Micros(1) + ".png"), "x");
        File.WriteAllText(_rig.PathOf("f000001_" + Micros(1) + "_e-5.png"), "x");
        File.WriteAllText(_rig.PathOf("f000001_99999999999999999999_e2000.png"), "x");

        _rig.RunFor(At(3));

        Assert.Empty(_rig.Taken);
        Assert.Equal(4, _rig.Camera.PicturesRefused);
        Assert.Contains("name", _rig.Camera.LastRefusal, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_PicturesThatCannotBeRead_AreCountedAndTheRestGoesOn()
    {
        string damaged = _rig.Write(1, At(1));
        File.WriteAllBytes(_rig.PathOf(damaged), File.ReadAllBytes(_rig.PathOf(damaged)).Take(50).ToArray());
        File.WriteAllBytes(_rig.PathOf("f000002_" + Micros(2) + "_e2000.jpg"), [0xFF, 0xD8, 0xFF, 0xC3, 0, 2]);
        PictureFile.Save(_rig.PathOf("f000003_" + Micros(3) + "_e2000.ppm"), SamplePictures.Random(5, 4, seed: 1));
        PictureFile.Save(_rig.PathOf("f000004_" + Micros(4) + "_e0.ppm"), SamplePictures.Random(4, 5, seed: 1));

        _rig.RunFor(At(1.5));
        Assert.Contains("cut off", _rig.Camera.LastRefusal, StringComparison.Ordinal);
        _rig.RunFor(At(1));
        Assert.Contains("_e2000.jpg: it is a lossless JPEG", _rig.Camera.LastRefusal, StringComparison.Ordinal);
        _rig.RunFor(At(1));
        Assert.Contains("5 x 4 pixels", _rig.Camera.LastRefusal, StringComparison.Ordinal);
        _rig.RunFor(At(1));

        Assert.Equal([4], _rig.Taken.Select(t => t.Frame.Number));
        Assert.Equal(3, _rig.Camera.PicturesRefused);
    }

    [LinuxFact]
    public void Read_PipeWithTheNameOfAPicture_IsRefusedAndTheRestGoesOn()
    {
        string pipe = _rig.PathOf("f000001_" + Micros(1) + "_e2000.png");
        SamplePictures.MakePipe(pipe);
        _rig.Write(2, At(2));

        _rig.RunFor(At(3));

        Assert.Equal([2], _rig.Taken.Select(t => t.Frame.Number));
        Assert.Equal(1, _rig.Camera.PicturesRefused);
        Assert.Equal(pipe + ": it is a pipe, not a file", _rig.Camera.LastRefusal);
    }

    [Fact]
    public void Read_JpegAndGrey_GivesTheirPixels()
    {
        string jpeg = Path.Combine(Repository.Root, "tests", "data", "jpeg", "420-4x5.jpg");
        File.Copy(jpeg, _rig.PathOf("f000001_" + Micros(1) + "_e2000.jpg"));
        byte[] grey = Enumerable.Range(0, 40).Select(at => (byte)(at % 2 == 0 ? at * 6 : 255)).ToArray();
        File.WriteAllBytes(
            _rig.PathOf("f000002_" + Micros(2) + "_e2000.pgm"),
            System.Text.Encoding.ASCII.GetBytes("P5\n4 5\n65535\n").Concat(grey).ToArray());

        _rig.RunFor(At(3));

        Assert.Equal([1, 2], _rig.Taken.Select(t => t.Frame.Number));
        Assert.Equal(PictureFile.Load(jpeg).Pixels, _rig.Taken[0].Pixels);
        Assert.Equal([1, 1, 1, 13, 13, 13], _rig.Taken[1].Pixels.Take(6));
        Assert.Equal(0, _rig.Camera.PicturesRefused);
    }

    [Fact]
    public void Read_PictureThatComesAfterALaterOne_IsCountedAndNotGiven()
    {
        _rig.Write(5, At(0.5));
        _rig.RunFor(At(1));
        _rig.Write(4, At(0.4));
        _rig.RunFor(At(3));

        Assert.Equal([5], _rig.Taken.Select(t => t.Frame.Number));
        Assert.Equal(1, _rig.Camera.PicturesLate);
    }

    [Fact]
    public void Read_PictureWithATimeInTheFuture_IsCountedByNameAndHoldsUpNothing()
    {
        _rig.Write(1, At(0.5));
        _rig.RunFor(At(1));
        string ahead = _rig.Write(2, At(3600));
        for (int number = 3; number < 9; number++)
        {
            _rig.Write(number, At(number - 2));
            _rig.RunFor(At(1));
        }

        Assert.Equal([1, 3, 4, 5, 6, 7, 8], _rig.Taken.Select(t => t.Frame.Number));
        Assert.Equal(1, _rig.Camera.PicturesAhead);
        Assert.Contains(Path.GetFileName(ahead), _rig.Camera.LastRefusal, StringComparison.Ordinal);
        Assert.Contains("ahead of the clock", _rig.Camera.LastRefusal, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_FuturePictureFromTheStart_HoldsUpNothing()
    {
        _rig.Write(2, At(60));
        for (int number = 3; number < 9; number++)
        {
            _rig.RunFor(At(1));
            _rig.Write(number, At(number - 2.5));
        }

        _rig.RunFor(At(1));
        Assert.Equal([3, 4, 5, 6, 7, 8], _rig.Taken.Select(t => t.Frame.Number));
    }

    [Fact]
    public void Read_NoBufferFree_LosesPicturesAndCountsThem()
    {
        _rig.Dispose();
        _rig = new FolderCameraRig(buffers: 2) { KeepsPictures = true };
        for (int number = 0; number < 5; number++)
            _rig.Write(number, At(1 + number));

        _rig.RunFor(At(4.5));
        Assert.Equal(2, _rig.Camera.PicturesWithoutBuffer);
        _rig.Taken[0].Frame.Dispose();
        _rig.RunFor(At(2));

        Assert.Equal([0, 1, 4], _rig.Taken.Select(t => t.Frame.Number));
    }

    [Fact]
    public void Read_ListedPictures_NeedNoSpeakingNames()
    {
        PictureFile.Save(_rig.PathOf("first.png"), SamplePictures.Random(4, 5, seed: 2));
        string json = File.ReadAllText(_rig.PathOf(CameraFolder.DescriptionFile)).TrimEnd().TrimEnd('}')
            + ",\"frames\":[{\"file\":\"first.png\",\"frameStartMicroseconds\":" + Micros(1.5)
            + ",\"exposureMicroseconds\":1000},"
            + "{\"file\":\"second.png\",\"frameStartMicroseconds\":" + Micros(2.5)
            + ",\"exposureMicroseconds\":1000}]}";
        File.WriteAllText(_rig.PathOf(CameraFolder.DescriptionFile), json);
        _rig.Reopen();

        _rig.RunFor(At(4));

        Assert.Equal([At(1.5)], _rig.Taken.Select(t => t.Frame.FrameStart));
        Assert.Equal(1, _rig.Camera.PicturesRefused);
        Assert.Contains("second.png: no such file", _rig.Camera.LastRefusal, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_FolderGone_SaysSoAndGoesOn()
    {
        _rig.RunFor(At(0.05));
        Directory.Delete(_rig.Folder.Path, recursive: true);
        _rig.RunFor(At(3));
        Assert.Contains("gone", _rig.Camera.LastRefusal, StringComparison.Ordinal);

        Directory.CreateDirectory(_rig.Folder.Path);
        _rig.Write(1, At(4));
        _rig.RunFor(At(4));

        Assert.Equal([1], _rig.Taken.Select(t => t.Frame.Number));
    }

    [Fact]
    public void Write_Picture_LeavesNothingHalf()
    {
        string name = _rig.Write(123, At(1.5));

        Assert.Equal("f000123_" + Micros(1.5) + "_e2000.png", name);
        Assert.Equal([CameraFolder.DescriptionFile, name], Directory.GetFiles(_rig.Folder.Path)
            .Select(p => Path.GetFileName(p)).OrderBy(n => n, StringComparer.Ordinal));
    }

    private static TimeSpan At(double seconds) => TimeSpan.FromTicks((long)Math.Round(seconds * Second.Ticks));

    private static string Micros(double seconds)
        => (PictureFolderWriter.ToMicroseconds(FolderCameraRig.StartUtc) + (long)(seconds * 1e6))
            .ToString(System.Globalization.CultureInfo.InvariantCulture);
}
