using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;
using Rabit.Vision.Tests.Pictures;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

/// <summary>Pictures that their program writes in place, and that are looked at before they are whole.</summary>
public sealed class FolderCameraUnfinishedTests : IDisposable
{
    private static readonly byte[] Picture = PngPicture.Encode(SamplePictures.Random(4, 5, seed: 1));

    private readonly FolderCameraRig _rig = new();

    // What is there from the start is not being written.
    public FolderCameraUnfinishedTests() => _rig.RunFor(At(0.05));

    public void Dispose() => _rig.Dispose();

    [Fact]
    public void Read_PictureWrittenInPlace_IsGivenWhenItIsWhole()
    {
        string name = NameOf(1, At(0.02));
        for (int bytes = 0; bytes < Picture.Length; bytes += 10)
        {
            Write(name, bytes);
            _rig.RunFor(At(0.2));
        }

        Assert.Empty(_rig.Taken);
        Write(name, Picture.Length);
        _rig.RunFor(At(0.2));

        Assert.Equal(At(0.02), Assert.Single(_rig.Taken).Frame.FrameStart);
        Assert.Equal((1, 0), (_rig.Camera.PicturesReadAgain, _rig.Camera.PicturesRefused));
        Assert.Null(_rig.Camera.LastRefusal);
    }

    [Fact]
    public void Read_PictureThatStaysHalf_IsRefusedOnceAfterASecond()
    {
        Write(NameOf(1, At(0.02)), 50);

        _rig.RunFor(At(0.8));
        Assert.Equal(0, _rig.Camera.PicturesRefused);
        _rig.RunFor(At(2));

        Assert.Equal((0, 1), (_rig.Camera.PicturesReadAgain, _rig.Camera.PicturesRefused));
        Assert.Contains("cut off", _rig.Camera.LastRefusal, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_FileThatGrowsForEver_IsRefusedAfterTenSeconds()
    {
        string name = NameOf(1, At(0.02));
        for (int tenth = 0; tenth < 150; tenth++)
        {
            File.WriteAllBytes(_rig.PathOf(name), new byte[100 + tenth]);
            _rig.RunFor(At(0.1));
            Assert.InRange(_rig.Camera.PicturesRefused, tenth > 110 ? 1 : 0, tenth > 90 ? 1 : 0);
        }
    }

    [Fact]
    public void Read_PictureThatStaysHalf_HoldsUpNoLaterOne()
    {
        Write(NameOf(1, At(0.02)), 50);
        _rig.RunFor(At(0.3));
        Write(NameOf(2, At(0.3)), Picture.Length);
        _rig.RunFor(At(0.3));

        Assert.Equal([2], _rig.Taken.Select(t => t.Frame.Number));
        Assert.Equal((0, 1), (_rig.Camera.PicturesReadAgain, _rig.Camera.PicturesRefused));
    }

    [Fact]
    public void Read_PictureThatIsWholeWhenALaterOneIsThere_ComesBeforeIt()
    {
        string first = NameOf(1, At(0.02));
        Write(first, 50);
        _rig.RunFor(At(0.21));
        Write(first, Picture.Length);
        Write(NameOf(2, At(0.1)), Picture.Length);
        _rig.RunFor(At(0.3));

        Assert.Equal([1, 2], _rig.Taken.Select(t => t.Frame.Number));
        Assert.Equal((1, 0), (_rig.Camera.PicturesReadAgain, _rig.Camera.PicturesRefused));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(12)]
    public void Read_PictureWithExifWrittenInPlace_IsGivenWhenItIsWhole(int bytes)
    {
        var photo = new PhotoMetadata
        {
            TakenLocal = (FolderCameraRig.StartUtc + At(0.5)).DateTime,
            TakenResolution = At(0.001),
            UtcOffset = TimeSpan.Zero,
        };
        byte[] whole = PngPicture.Encode(SamplePictures.Random(4, 5, seed: 1), photo);
        string path = _rig.PathOf("dji.png");
        File.WriteAllBytes(path, [.. whole.Take(bytes)]);
        _rig.RunFor(At(0.5));
        Assert.Equal(0, _rig.Camera.PicturesRefused);
        File.WriteAllBytes(path, whole);
        _rig.RunFor(At(0.5));

        Assert.Single(_rig.Taken);
        Assert.Equal((1, 0), (_rig.Camera.PicturesReadAgain, _rig.Camera.PicturesRefused));
    }

    [Fact]
    public void Read_ManyFilesThatSayNoTime_AreRefusedEachOnce()
    {
        for (int number = 0; number < 40; number++)
            File.WriteAllText(_rig.PathOf(FormattableString.Invariant($"holiday{number}.png")), "x");

        _rig.RunFor(At(3));

        Assert.Equal(40, _rig.Camera.PicturesRefused);
    }

    [Fact]
    public void Close_PicturesThatAreNotWholeYet_CountAsRefused()
    {
        Write(NameOf(1, At(0.02)), 50);
        File.WriteAllText(_rig.PathOf("holiday.png"), "x");
        _rig.RunFor(At(0.3));
        Assert.Equal(0, _rig.Camera.PicturesRefused);

        _rig.Stop();

        Assert.Equal(2, _rig.Camera.PicturesRefused);
    }

    [Fact]
    public void FindNew_PicturesThatWereTakenAway_AreForgotten()
    {
        var listing = new PictureListing(_rig.Folder);
        var found = new List<ListedPicture>();
        for (int number = 0; number < 300; number++)
        {
            Write(NameOf(number, At(number)), 0);
            if (number >= 5)
                File.Delete(_rig.PathOf(NameOf(number - 5, At(number - 5))));
            for (int look = 0; look < 10; look++)
                listing.FindNew(found, []);   // each tenth one lists in any case
        }

        Assert.Equal(Enumerable.Range(0, 300).Select(n => (long)n), found.Select(p => p.Facts.Number));
        Assert.Equal(5 + 1, listing.Remembered);   // and camera.json
    }

    private static TimeSpan At(double seconds)
        => TimeSpan.FromTicks((long)Math.Round(seconds * TimeSpan.TicksPerSecond));

    private static string NameOf(long number, TimeSpan start) => string.Format(
        CultureInfo.InvariantCulture, "f{0:D6}_{1}_e1000.png", number,
        PictureFolderWriter.ToMicroseconds(FolderCameraRig.StartUtc + start));

    private void Write(string name, int bytes) => File.WriteAllBytes(_rig.PathOf(name), [.. Picture.Take(bytes)]);
}
