using System;
using Rabit.Uav.Messages;
using Xunit;

namespace UavConsole.Tests;

/// <summary>What the screen says in a few words.</summary>
public sealed class MissionTextTests
{
    [Fact]
    public void LastPicture_BeforeTheFirst_IsNone() => Assert.Null(MissionText.LastPicture(new ImagingStatus()));

    [Fact]
    public void LastPicture_Measured_SaysDetectionsSharpnessAndExposure()
    {
        var picture = new PictureFacts
        {
            Exposure = TimeSpan.FromTicks(25_000),
            DarkLevel = 61,
            BrightLevel = 182,
            ClippedShare = 0.031,
            Sharpness = 0.342,
            Detections = 2,
        };
        Assert.Equal(
            "2 detected, sharpness 0.34, 2.5 ms, 3 % clipped, levels 61 to 182",
            MissionText.LastPicture(new ImagingStatus { LastPicture = picture }));
        Assert.Equal(
            "2 found, sharp 0.34, 2.5 ms",
            MissionText.LastPicture(new ImagingStatus { LastPicture = picture }, isShort: true));
        Assert.Equal(
            "0 detected, no detail, levels 4 to 4",
            MissionText.LastPicture(new ImagingStatus
            {
                LastPicture = new PictureFacts { DarkLevel = 4, BrightLevel = 4, Sharpness = double.NaN },
            }));
    }
}
