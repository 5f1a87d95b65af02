using System;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Messages;

public sealed class CameraFrameTests
{
    [Theory]
    [InlineData(long.MaxValue)]
    [InlineData(long.MinValue)]
    [InlineData(-1)]
    [InlineData(TimeSpan.TicksPerHour + 1)]
    public void Exposure_ThatIsNone_IsRefusedByName(long ticks)
    {
        CameraFrame frame = default;

        ArgumentOutOfRangeException e = Assert.Throws<ArgumentOutOfRangeException>(
            () => frame.Exposure = TimeSpan.FromTicks(ticks));

        Assert.Contains("A picture's Exposure is 0 to 1 hour.", e.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(long.MaxValue)]
    [InlineData(long.MinValue)]
    public void FrameStart_ThatIsNone_IsRefusedByName(long ticks)
    {
        CameraFrame frame = default;

        ArgumentOutOfRangeException e = Assert.Throws<ArgumentOutOfRangeException>(
            () => frame.FrameStart = TimeSpan.FromTicks(ticks));

        Assert.Contains("A picture's FrameStart is", e.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(-3_600_000, 3_600_000, -1_800_000)]
    [InlineData(1000, 5, 1002.5)]
    public void MidExposure_IsHalfOfTheExposureAfterTheStart(double start, double exposure, double middle)
    {
        var frame = new CameraFrame
        {
            FrameStart = TimeSpan.FromTicks((long)(start * TimeSpan.TicksPerMillisecond)),
            Exposure = TimeSpan.FromTicks((long)(exposure * TimeSpan.TicksPerMillisecond)),
        };

        Assert.Equal(middle, frame.MidExposure.TotalMilliseconds);
    }
}
