using System;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>Image Processing with a marker to land on declared.</summary>
public sealed class LandingMarkerTests
{
    private static readonly Lazy<byte[]> OneTag = new(
        () => PrintedTag.Show(LandingMarkerFinderTests.View(), new PrintedTag(0.3, -0.2, 0.5)));

    private static readonly Lazy<byte[]> TwoTags = new(() => PrintedTag.Show(
        LandingMarkerFinderTests.View(), new PrintedTag(0.8, -0.6, 0.5), new PrintedTag(-0.8, 0.6, 0.5)));

    [Fact]
    public void Marker_NoSearch_IsPostedForEachPicture()
    {
        using ImagingRig rig = Rig(OneTag.Value);
        rig.AddPoses(0, 3);
        rig.Camera!.Add(0, exposedAt: 1.03, deliveredAt: 1.15);
        rig.Run(1.2);
        Assert.Equal(0, rig.LandingTarget!.Value.Value.PictureNumber);
        rig.Camera.Add(1, exposedAt: 1.13, deliveredAt: 1.25);
        rig.Run(0.1);

        (TimeSpan stamp, LandingTargetObservation target) = rig.LandingTarget!.Value;
        Assert.Equal((1L, stamp), (target.PictureNumber, target.Time));
        Assert.Equal(1.13, target.Time.TotalSeconds, 1e-6);
        Assert.Equal(0.3, target.OffsetNedMetres.North, 0.02);
        Assert.Equal(-0.2, target.OffsetNedMetres.East, 0.02);
        Assert.Equal(5, target.OffsetNedMetres.Down, 0.04);
        ImagingStatus status = rig.Status;
        Assert.Equal(
            (2L, 0L, 0L, 0L),
            (status.LandingMarkersFound, status.LandingMarkersRefused, status.Observations, status.Pictures.Total));
        Assert.Empty(rig.Sink.Observations);
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Marker_DirectionOfTheCameraNotKnown_IsRefusedByName()
    {
        using ImagingRig rig = Rig(OneTag.Value, isPointed: false);
        rig.AddPoses(0, 3);
        rig.Camera!.Add(0, exposedAt: 1.03, deliveredAt: 1.15);
        rig.Run(2);

        Assert.Null(rig.LandingTarget);
        Assert.Equal(LandingMarkerFinder.NoDirection, rig.Status.LastLandingMarkerRefusal);
    }

    [Fact]
    public void Marker_DuringASearch_IsPostedAndThePictureSearched()
    {
        using ImagingRig rig = Rig(OneTag.Value);
        rig.Order(ImagingMode.Search);
        rig.AddPoses(0, 3);
        rig.Camera!.Add(0, exposedAt: 1.03, deliveredAt: 1.15);
        rig.Run(2);

        Assert.NotNull(rig.LandingTarget);
        Assert.Equal((1L, 1L), (rig.Status.LandingMarkersFound, rig.Status.Pictures.Total));
    }

    [Fact]
    public void Marker_SeenTwice_IsRefusedAndCounted()
    {
        using ImagingRig rig = Rig(TwoTags.Value);
        rig.AddPoses(0, 3);
        rig.Camera!.Add(0, exposedAt: 1.03, deliveredAt: 1.15);
        rig.Run(2);

        Assert.Null(rig.LandingTarget);
        ImagingStatus status = rig.Status;
        Assert.Equal(
            (0L, 1L, LandingMarkerFinder.SeenTwice),
            (status.LandingMarkersFound, status.LandingMarkersRefused, status.LastLandingMarkerRefusal));
    }

    [Fact]
    public void Marker_NoPoses_IsRefusedAsAnyPicture()
    {
        using ImagingRig rig = Rig(OneTag.Value);
        rig.Camera!.Add(0, exposedAt: 1.03, deliveredAt: 1.15);
        rig.Run(3);

        Assert.Null(rig.LandingTarget);
        Assert.Equal((0L, 1L), (rig.Status.LandingMarkersFound, rig.Status.FramesRefused));
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Marker_SearchEnds_IsStillPosted()
    {
        using ImagingRig rig = Rig(OneTag.Value);
        rig.Order(ImagingMode.Search);
        rig.AddPoses(0, 5);
        rig.Camera!.Add(0, exposedAt: 1.03, deliveredAt: 1.15);
        rig.Run(2);
        rig.Order(ImagingMode.Off);
        rig.Camera.Add(1, exposedAt: 2.03, deliveredAt: 2.15);
        rig.Run(1);

        Assert.Equal(1, rig.LandingTarget!.Value.Value.PictureNumber);
        Assert.Equal((2L, 1L), (rig.Status.LandingMarkersFound, rig.Status.Pictures.Total));
    }

    private static ImagingRig Rig(byte[] picture, bool isPointed = true)
    {
        var options = new ImageProcessingOptions { LandingMarker = LandingMarkerFinderTests.Marker() };
        var rig = new ImagingRig(new ScriptedCamera(picture), options);
        rig.View.Position = LandingMarkerFinderTests.View().Position;
        if (isPointed)
            rig.Order(ImagingMode.Off);
        return rig;
    }
}
