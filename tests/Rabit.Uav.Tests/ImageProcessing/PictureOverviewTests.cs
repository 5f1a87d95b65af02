using System;
using System.Linq;
using System.Runtime.InteropServices;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Whole pictures with reports, scaled down.</summary>
public sealed class PictureOverviewTests
{
    private readonly byte[] _picture = [.. Enumerable.Range(0, 64 * 48 * 3).Select(i => (byte)(i / 3 % 64 * 2))];

    [Fact]
    public void Find_PictureWithReports_IsScaledDownWithItsBoxes()
    {
        var buffer = new PictureOverviewBuffer(capacity: 3, maxWidth: 32);
        Add(buffer, 7, Report(1, 31.5, 11.5, 8, 6));

        PictureOverview overview = buffer.Find(7)!;
        Assert.Equal((7L, 32, 24), (overview.PictureNumber, overview.Width, overview.Height));
        PictureBox box = Assert.Single(overview.Boxes);
        Assert.Equal(new PictureBox(1, 28 / 64.0, 9 / 48.0, 8 / 64.0, 6 / 48.0), box);
        byte[] pixels = overview.CopyPixels();
        Assert.Equal((1, 5), (pixels[0], pixels[3]));   // the means of 0 and 2, of 4 and 6
        Assert.Null(buffer.Find(8));
    }

    [Fact]
    public void Add_MoreThanThereIsRoomFor_ForgetsTheOldest()
    {
        var buffer = new PictureOverviewBuffer(capacity: 2, maxWidth: 64);
        for (long number = 1; number <= 5; number++)
            Add(buffer, number, Report(0, 5, 5, 2, 2));

        Assert.Equal([4L, 5], new long[] { 1, 2, 3, 4, 5 }.Where(n => buffer.Find(n) is not null));
    }

    [Fact]
    public void Add_WithoutReportsOrPlace_KeepsNone()
    {
        var buffer = new PictureOverviewBuffer(capacity: 2, maxWidth: 64);
        Add(buffer, 1);
        Assert.Null(buffer.Find(1));

        var none = new PictureOverviewBuffer(capacity: 0, maxWidth: 64);
        Add(none, 1, Report(0, 5, 5, 2, 2));
        Assert.Null(none.Find(1));
    }

    [Fact]
    public void Add_OtherSize_IsTakenToo()
    {
        var buffer = new PictureOverviewBuffer(capacity: 1, maxWidth: 64);
        Add(buffer, 1, Report(0, 5, 5, 2, 2));
        buffer.Add(Observation(2, Report(0, 1, 1, 2, 2)), new byte[9 * 7 * 3], 9, 7);

        Assert.Equal((9, 7), (buffer.Find(2)!.Width, buffer.Find(2)!.Height));
    }

    [Fact]
    public void Add_Thermal_IsGreyFromTheColdestToTheWarmest()
    {
        var buffer = new PictureOverviewBuffer(capacity: 1, maxWidth: 2);
        ushort[] counts =
        [
            7000, 7000, 7100, 7100,
            7000, 7000, 7100, 7100,
            7000, 7000, 7050, 7050,
            7000, 7000, 7050, 7050,
        ];
        buffer.Add(
            Observation(1, Report(0, 1, 1, 2, 2)), MemoryMarshal.AsBytes<ushort>(counts).ToArray(), 4, 4,
            PixelFormat.Grey16);

        byte[] pixels = buffer.Find(1)!.CopyPixels();
        Assert.Equal([0, 0, 0, 255, 255, 255, 0, 0, 0, 127, 127, 127], pixels);
    }

    [Theory]
    [InlineData(PixelFormat.Rgb24)]
    [InlineData(PixelFormat.Grey16)]
    public void Add_AgainAndAgain_AllocatesNothing(PixelFormat format)
    {
        var buffer = new PictureOverviewBuffer(capacity: 2, maxWidth: 32);
        CameraObservation observation = Observation(1, Report(0, 5, 5, 2, 2));
        void Work()
        {
            buffer.Add(observation, _picture, 64, 48, format);
            buffer.Add(observation, _picture, 64, 48, format);
        }

        Work();
        Assert.Equal(0, Allocated.By(Work));
    }

    [Theory]
    [InlineData(-1, 320)]
    [InlineData(12, 8)]
    public void Options_OutOfRange_AreRefused(int count, int width)
    {
        var options = new ImageProcessingOptions { MaxPictureOverviews = count, PictureOverviewWidth = width };
        ArgumentException refused = Assert.Throws<ArgumentException>(
            () => new ImageProcessingManager(options, camera: null));
        Assert.Contains($"MaxPictureOverviews is {count} and PictureOverviewWidth {width}", refused.Message);
    }

    private void Add(PictureOverviewBuffer buffer, long number, params TargetReport[] reports)
        => buffer.Add(Observation(number, reports), _picture, 64, 48);

    private static CameraObservation Observation(long number, params TargetReport[] reports)
        => new() { Number = number, Reports = [.. reports] };

    private static TargetReport Report(int index, double column, double row, double width, double height) => new()
    {
        Index = index,
        CentreX = column,
        CentreY = row,
        WidthPixels = width,
        HeightPixels = height,
    };
}
