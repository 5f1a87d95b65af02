using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// What Image Processing does beyond a single picture: modes, its camera's end, its status, its buffers.
/// </summary>
public sealed class ImagingServiceTests
{
    [Fact]
    public void Mode_Off_GivesPicturesBackUnseen()
    {
        var camera = new ScriptedCamera(ImagingRig.Panel);
        using var rig = new ImagingRig(camera);
        rig.AddPoses(0, 9);
        camera.Add(0, 1, 1.1);
        rig.Run(2);
        Assert.Equal((1L, 0L, ImagingMode.Off), (rig.Status.Frames, rig.Status.Observations, rig.Status.Mode));
        Assert.Empty(rig.Sink.Observations);
        rig.AssertAllGivenBack();

        rig.Order(ImagingMode.Search);
        camera.Add(1, 3, 5.1);
        rig.Run(5);
        Assert.Equal(1L, Assert.Single(rig.Sink.Observations).Number);
    }

    [Fact]
    public void Mode_SwitchedOffWhileAPictureWaits_GivesItBack()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Panel);
        rig.Camera!.Add(0, 1, 1.1);
        rig.Run(1.2);
        Assert.Equal(5, rig.Camera.Pool.Free);
        rig.Order(ImagingMode.Off);
        Assert.Equal(6, rig.Camera.Pool.Free);
        Assert.Equal(0, rig.Status.FramesRefused);
    }

    [Fact]
    public void Camera_Fails_TheStatusSaysSoAndTheManagerGoesOn()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(0, 9);
        rig.Camera!.Fault = new InvalidOperationException("the lens fell off");
        rig.Camera.Add(0, 1, 1.1);
        rig.Run(2);
        ImagingStatus status = rig.Status;
        Assert.Equal(
            (true, "InvalidOperationException: the lens fell off", 1L),
            (status.HasEnded, status.Fault, status.Observations));
        int posts = rig.StatusTimes.Count;
        rig.Run(3);
        Assert.True(rig.StatusTimes.Count >= posts + 3);
        Assert.Equal(0, rig.Finish().ExitCode);
    }

    [Fact]
    public void Camera_Ends_TheStatusSaysSoWithoutAFault()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(0, 9);
        rig.Camera!.Ends = true;
        rig.Camera.Add(0, 1, 1.1);
        rig.Run(2);
        ImagingStatus status = rig.Status;
        Assert.Equal((true, null, 1L), (status.HasEnded, status.Fault, status.Observations));
    }

    [Fact]
    public void Camera_None_TheStatusSaysSo()
    {
        using var rig = new ImagingRig(null);
        rig.Order(ImagingMode.Search);
        ImagingStatus status = rig.Status;
        Assert.Equal(
            (false, false, ImagingMode.Search, 0L), (status.HasCamera, status.HasEnded, status.Mode, status.Frames));
        Assert.Equal(0, rig.Finish().ExitCode);
    }

    [Fact]
    public void Status_Always_ComesAtLeastOnceASecond()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.Run(20);
        Assert.True(rig.StatusTimes.Count >= 20);
        Assert.All(
            rig.StatusTimes.Zip(rig.StatusTimes.Skip(1), (a, b) => b - a),
            gap => Assert.True(gap <= TimeSpan.FromSeconds(1), gap.ToString()));
    }

    [Fact]
    public void Stop_WhilePicturesWait_GivesAllBuffersBack()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Panel);
        for (int i = 0; i < 4; i++)
            rig.Camera!.Add(i, 1 + (0.1 * i), 1.1);
        rig.Run(1.15);
        Assert.True(rig.Camera!.Pool.Free < 6);

        ReactorResult result = rig.Finish();

        Assert.Equal(0, result.ExitCode);
        Assert.Equal("Pool 'camera': 6 of 6 buffers are free, 0 times none was.", rig.Camera.Pool.Describe());
    }

    [Fact]
    public void Reports_NoRoomInTheQueue_AreCounted()
    {
        var camera = new ScriptedCamera(ImagingRig.Panel);
        using var rig = new ImagingRig(camera, sinkIsSmall: true);
        rig.Order(ImagingMode.Search);
        rig.AddPoses(0, 9);
        camera.Add(0, 1, 2);
        camera.Add(1, 1.1, 2);
        rig.Run(3);
        ImagingStatus status = rig.Status;
        Assert.Equal((2L, 2L), (status.Observations, status.Reports + status.ReportsDropped));
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void ImageChips_OfReports_ShowTheTargetAndAreBounded()
    {
        using ImagingRig rig = ImagingRig.Search(
            ImagingRig.Panel, new ImageProcessingOptions { MaxImageChips = 3, ImageChipSide = 24 });
        rig.AddPoses(0, 9);
        for (int i = 0; i < 5; i++)
        {
            rig.Camera!.Add(i, 1 + (0.2 * i), 1.1 + (0.2 * i));
            rig.Run(0.2);
        }

        rig.Run(2);
        IReadOnlyList<ImageChip> chips = rig.Manager.ImageChips;
        Assert.Equal([2L, 3L, 4L], chips.Select(c => c.PictureNumber));
        ImageChip newest = chips[2];
        Assert.Equal((0, 24, 24), (newest.ReportIndex, newest.Width, newest.Height));
        byte[] pixels = newest.CopyPixels();
        int middle = ((12 * 24) + 12) * 3;
        Assert.True(pixels[middle] > 180 && pixels[middle + 1] < 60 && pixels[0] < 140);
        pixels[middle] = 0;
        Assert.NotEqual(0, newest.CopyPixels()[middle]);
    }

    [Theory]
    [InlineData(0, 20, true)]
    [InlineData(0, 0.1, false)]
    [InlineData(40, 41, false)]
    public void Frames_WithoutReports_AllocateNothing(double posesFrom, double posesTo, bool areSearched)
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(posesFrom, posesTo);
        for (int i = 0; i < 300; i++)
            rig.Camera!.Add(i, 0.5 + (0.1 * i), 0.6 + (0.1 * i));
        rig.Sink.Observations.Capacity = rig.Sink.SearchedGround.Capacity = rig.StatusTimes.Capacity = 1000;
        rig.Run(8);
        Assert.Equal(areSearched, rig.Sink.Observations.Count > 70);

        // The best of a few: the runtime may allocate on this thread while it replaces a method by a faster one.
        Assert.Equal(0, Enumerable.Range(0, 5).Min(_ => Allocated.By(() => rig.Run(2))));
    }

    [Fact]
    public void Constructor_BadOptions_NamesAllFaults()
    {
        var options = new ImageProcessingOptions
        {
            TargetClasses =
            [
                new TargetClass("red") { MinSideMetres = 2 },
                new TargetClass("red") { Colour = new ColourRange(205, 28, 32) }
            ],
            DetectorTimeBudget = TimeSpan.Zero,
            MaxReportsPerPicture = 0,
            MinDepression = Angle.Zero,
            PoseTimeout = TimeSpan.FromSeconds(-1),
            MaxPoseGap = TimeSpan.Zero,
            FramesWaiting = 0,
            ImageChipSide = 0,
            Mount = new CameraMount { MisalignmentYaw = Angle.NaN },
            Errors = new ErrorBudget { PixelNoise = -1, PositionBiasMetres = double.NaN },
        };
        string text =
            Assert.Throws<ArgumentException>(() => new ImageProcessingManager(options, new ScriptedCamera([]))).Message;
        foreach (string name in new[]
        {
            "Camera does not say", "MinSideMetres of target class red is 2", "red is declared twice",
            "red has no colour", "DetectorTimeBudget",
            "MaxReportsPerPicture is 0",
            "MinDepression is 0", "PoseTimeout", "MaxPoseGap", "FramesWaiting is 0", "ImageChipSide is 0",
            "misalignment", "ErrorBudget.PixelNoise is -1", "ErrorBudget.PositionBiasMetres is NaN",
        })
            Assert.Contains(name, text, StringComparison.Ordinal);
        _ = new ImageProcessingManager(new ImageProcessingOptions(), camera: null);
    }
}
