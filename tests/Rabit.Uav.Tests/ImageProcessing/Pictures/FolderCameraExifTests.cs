using System;
using System.IO;
using System.Linq;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;
using Rabit.Vision.Tests.Pictures;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

/// <summary>Pictures of a folder whose names do not say when they were taken, but their EXIF does.</summary>
public sealed class FolderCameraExifTests : IDisposable
{
    private static readonly TimeSpan TwoHours = TimeSpan.FromHours(2);

    private readonly FolderCameraRig _rig = new();

    public void Dispose() => _rig.Dispose();

    [Fact]
    public void Read_PicturesWithExif_HaveItsTimesAndAreNumberedInTheirOrder()
    {
        Write("b.png", At(1.25), resolution: null, exposure: TimeSpan.FromTicks(15_000));
        Write("a.png", At(2.5), resolution: null, exposure: null);

        _rig.RunFor(At(4));

        Assert.Equal([0L, 1], _rig.Taken.Select(t => t.Frame.Number));
        Assert.Equal([At(1.25), At(2.5)], _rig.Taken.Select(t => t.Frame.FrameStart));
        Assert.Equal([1.5, 5], _rig.Taken.Select(t => t.Frame.Exposure.TotalMilliseconds));
        Assert.All(_rig.Taken, t => Assert.Equal(5, t.Frame.TimeNoise.TotalMilliseconds, 1e-3));
        Assert.Equal("EXIF of the pictures, standard deviation 5 ms", _rig.Camera.Statistics.TimeSource);
        Assert.Equal(0, _rig.Camera.PicturesRefused);
    }

    /// <summary>
    /// A time of whole seconds was cut off: it is half a second later in the mean, and may be as wrong as that.
    /// </summary>
    [Theory]
    [InlineData(1000, 1.5, 288.7)]
    [InlineData(100, 1.25, 29.3)]
    public void Read_TimeOfFewDecimals_IsTheMiddleOfWhatTheyLeaveOpen(
        int resolutionMilliseconds, double expectedSeconds, double expectedNoiseMilliseconds)
    {
        Write("a.png", At(1.23), TimeSpan.FromMilliseconds(resolutionMilliseconds), exposure: null);

        _rig.RunFor(At(3));

        Assert.Equal(At(expectedSeconds), _rig.Taken.Single().Frame.FrameStart);
        Assert.Equal(expectedNoiseMilliseconds, _rig.Taken.Single().Frame.TimeNoise.TotalMilliseconds, 0.1);
    }

    [Fact]
    public void Read_ExifWithoutAZone_IsRefusedAndNamesTheKeyThatHasIt()
    {
        Write("a.png", At(1), resolution: null, exposure: null, hasZone: false);

        _rig.RunFor(At(3));

        Assert.Empty(_rig.Taken);
        Assert.Equal(1, _rig.Camera.PicturesRefused);
        Assert.Contains("\"exifUtcOffset\": \"+02:00\"", _rig.Camera.LastRefusal, StringComparison.Ordinal);
    }

    [Fact]
    public void Read_ExifWithoutAZone_IsOfTheZoneOfTheDescription()
    {
        SetOffset("+02:00");
        Write("a.png", At(1), resolution: null, exposure: null, hasZone: false);

        _rig.RunFor(At(3));

        Assert.Equal(At(1), _rig.Taken.Single().Frame.FrameStart);
    }

    [Theory]
    [InlineData("02:00")]
    [InlineData("+15:00")]
    [InlineData("+2")]
    [InlineData("summer")]
    public void Open_OffsetThatIsNone_IsRefusedByName(string offset)
        => Assert.Contains(
            $"exifUtcOffset is \"{offset}\"; it must be as \"+02:00\"",
            Assert.Throws<PictureException>(() => SetOffset(offset)).Reason, StringComparison.Ordinal);

    [Fact]
    public void Read_PictureWithoutExif_IsRefusedByName()
    {
        PictureFile.Save(_rig.PathOf("holiday.png"), SamplePictures.Random(4, 5, seed: 1));

        _rig.RunFor(At(3));

        Assert.Equal(1, _rig.Camera.PicturesRefused);
        Assert.Contains(
            "holiday.png: its name does not say when it was taken, as f000123_1732190000123456_e2000.png does, nor "
                + "does its EXIF",
            _rig.Camera.LastRefusal, StringComparison.Ordinal);
    }

    private static TimeSpan At(double seconds)
        => TimeSpan.FromTicks((long)Math.Round(seconds * TimeSpan.TicksPerSecond));

    private void SetOffset(string offset) => _rig.Describe($"\"exifUtcOffset\": \"{offset}\"");

    private void Write(
        string name, TimeSpan start, TimeSpan? resolution, TimeSpan? exposure, bool hasZone = true)
    {
        var photo = new PhotoMetadata
        {
            TakenLocal = (FolderCameraRig.StartUtc + start + TwoHours).DateTime,
            TakenResolution = resolution,
            UtcOffset = hasZone ? TwoHours : null,
            ExposureTime = exposure,
        };
        File.WriteAllBytes(_rig.PathOf(name), PngPicture.Encode(SamplePictures.Random(4, 5, seed: 1), photo));
    }
}
