using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class ImageProcessingManagerTests
{
    [Fact]
    public void Frame_WithPosesAround_IsReportedWithItsGround()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Panel);
        rig.AddPoses(0, 3);
        rig.Camera!.Add(0, exposedAt: 1.03, deliveredAt: 1.15);
        rig.Run(2);

        TargetReport report = Assert.Single(rig.Sink.Reports);
        Assert.Equal(
            (7, 0L, 0, DefaultTargetClasses.Red),
            (report.SourceSystemId, report.PictureNumber, report.Index, report.Class));
        Assert.Equal(TimeSpan.FromSeconds(1.03), report.Time);
        NedPosition ned = LocalNedFrame.IgnoringGeoid(rig.View.Position).ToNed(report.Position);
        Assert.Equal(ImagingRig.North, ned.North, 0.05);
        Assert.Equal(ImagingRig.East, ned.East, 0.05);
        Assert.Equal(rig.View.GroundAltitude, report.Position.AltitudeAmslMetres, 0.01);
        Assert.InRange(report.SizeMetres, 0.9, 1.1);
        Assert.True(report.Covariance.NorthNorth > 0 && report.SystematicCovariance.NorthNorth > 1);

        CameraObservation observation = Assert.Single(rig.Sink.Observations);
        Assert.Equal(
            (7, 0L, 1, report.Time),
            (observation.SourceSystemId, observation.Number, observation.Reports.Length, observation.Time));
        Assert.Equal(observation, Assert.Single(rig.Sink.SearchedGround));
        AssertCorners(rig.View, observation);
        ImagingStatus status = rig.Status;
        Assert.Equal((true, ImagingMode.Search, 1L, 1L, 0L, 0L, 1L), (status.HasCamera, status.Mode, status.Frames,
            status.Observations, status.FramesDropped, status.FramesRefused, status.Reports));
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Frame_WithoutTargets_IsAnObservation()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(0, 3);
        rig.Camera!.Add(0, 1, 1.1);
        rig.Run(2);
        Assert.Empty(rig.Sink.Reports);
        Assert.Empty(Assert.Single(rig.Sink.Observations).Reports);
        Assert.Empty(rig.Manager.ImageChips);
    }

    [Fact]
    public void Frame_PosesComeLate_IsSearchedAtTheMomentTheyArrive()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(0, 0.9);
        rig.Camera!.Add(0, 1, 1.1);
        rig.Run(1.3);
        Assert.Empty(rig.Sink.Observations);
        rig.AddPoses(1, 1.2);
        rig.Run(0);
        Assert.Single(rig.Sink.Observations);
        Assert.Equal(0, rig.Status.FramesRefused);
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Frame_NoPoses_IsRefusedInTimeAndGivenBack()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Panel);
        rig.Camera!.Add(0, 1, 1.1);
        rig.Run(1.7);
        Assert.Equal(5, rig.Camera.Pool.Free);
        rig.Run(0.1);
        Assert.Equal(6, rig.Camera.Pool.Free);

        // What comes later does not bring it back.
        rig.AddPoses(0, 3);
        ImagingStatus status = rig.Status;
        Assert.Equal(
            (1L, 0L, 1L, ImageProcessingManager.NoPose),
            (status.Frames, status.Observations, status.FramesRefused, status.LastRefusal));
        Assert.Empty(rig.Sink.Observations);
    }

    // A pose of such a time cannot come soon enough: the picture gets no room that the others need.
    [Fact]
    public void Frame_TimeInTheFuture_IsRefusedAtOnceAndBlocksNoOther()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(0, 3);
        for (int i = 0; i < 12; i++)
            rig.Camera!.Add(i, i % 3 == 2 ? 1 + (0.02 * i) : 61.0, 1.1 + (0.02 * i));
        rig.Run(1.4);
        Assert.Equal([2L, 5L, 8L, 11L], rig.Sink.Observations.Select(o => o.Number));
        rig.AssertAllGivenBack();
        ImagingStatus status = rig.Status;
        Assert.Equal((12L, 8L, ImageProcessingManager.InTheFuture),
            (status.Frames, status.FramesRefused, status.LastRefusal));
    }

    [Fact]
    public void Frame_PosesWithAGapOrAllLater_IsRefusedAtOnceWithTheReason()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(2, 2);
        rig.AddPoses(3.5, 4);
        rig.Camera!.Add(0, 3, 3.1);
        rig.Run(3.2);
        ImagingStatus status = rig.Status;
        Assert.Equal((1L, ImageProcessingManager.PoseGap), (status.FramesRefused, status.LastRefusal));
        rig.Camera.Add(1, 1, 1);
        status = rig.Status;
        Assert.Equal((2L, ImageProcessingManager.PoseTooOld), (status.FramesRefused, status.LastRefusal));
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Frames_MoreWaitThanMay_TheOldestLeave()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        for (int i = 0; i < 7; i++)
            rig.Camera!.Add(i, 1 + (0.02 * i), 1.1 + (0.02 * i));
        rig.Run(1.25);
        rig.AddPoses(0, 2);
        ImagingStatus status = rig.Status;
        Assert.Equal(
            (7L, 4L, 3L, ImageProcessingManager.NoRoom),
            (status.Frames, status.Observations, status.FramesRefused, status.LastRefusal));
        Assert.Equal([3L, 4L, 5L, 6L], rig.Sink.Observations.Select(l => l.Number));
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Frames_NumbersWithGaps_AreCountedAsLost()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(0, 9);
        foreach (int number in new[] { 2, 3, 7, 0, 1 })
        {
            rig.Camera!.Add(number, 0.3, 0);
            rig.Run(0.1);
        }

        ImagingStatus status = rig.Status;
        Assert.Equal(3, status.FramesDropped);   // 0 and 1 were taken before the run
        Assert.Equal(status.Frames, status.Observations);
    }

    [Fact]
    public void Frames_CameraIsFasterThanTheManager_KeepsTheNewestAndCounts()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(0, 9);
        for (int i = 0; i < 10; i++)
            rig.Camera!.Add(i, 1 + (0.01 * i), 2);
        rig.Run(3);
        ImagingStatus status = rig.Status;
        Assert.Equal(10, status.Frames + status.FramesDropped);
        Assert.Equal(status.Frames, status.Observations + status.FramesRefused);
        Assert.Equal(9, rig.Sink.Observations.Last().Number);
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Classes_OfTheCommand_AreTheOnlyOnesReported()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Panel);
        rig.AddPoses(0, 9);
        rig.Order(ImagingMode.Search, DefaultTargetClasses.Blue);
        rig.Camera!.Add(0, 1, 1.1);
        rig.Run(2);
        Assert.Empty(Assert.Single(rig.Sink.Observations).Reports);
    }

    [Fact]
    public void Frame_OfAnotherSizeOrWithoutGround_IsRefusedWithTheReason()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        rig.AddPoses(0, 2);
        rig.Camera!.Size = (320, 240);
        rig.Camera.Add(0, 1, 1.1);
        rig.Run(1.5);
        ImagingStatus status = rig.Status;
        Assert.Equal((1L, PictureSearch.WrongSize), (status.FramesRefused, status.LastRefusal));

        rig.Camera.Size = (Painting.Width, Painting.Height);
        rig.View.Attitude = EulerAngles.FromRadians(1.2, 0, 0);
        rig.AddPoses(3, 5);
        rig.Camera.Add(1, 4, 4.1);
        rig.Run(3);
        status = rig.Status;
        Assert.Equal(
            (2L, 0L, PictureSearch.NotGround), (status.FramesRefused, status.Observations, status.LastRefusal));
        Assert.Empty(rig.Sink.Observations);
        rig.AssertAllGivenBack();
    }

    /// <summary>As of a camera that the mission points forward, of a vehicle that is pitched up by wind.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(0.2)]
    [InlineData(-0.2)]
    public void Frame_ThatReachesTheHorizon_IsSearchedWhereTheSmallestTargetIsResolved(double roll)
    {
        const double Height = 30;
        const double Near = 26;
        const double Far = 55;   // a pixel is 0.17 m there, and 0.15 m are needed
        var view = new TestView { CameraPitch = -Math.PI / 4, Attitude = EulerAngles.FromRadians(roll, 0.32, 0) };
        view.Position = GeodeticPosition.FromRadians(0.8, 0.15, view.GroundAltitude + Height);
        var painting = new Painting(22);
        PaintPanel(painting, view, Near);
        PaintPanel(painting, view, Far);
        using ImagingRig rig = ImagingRig.Search(painting.Finish());
        (rig.View.CameraPitch, rig.View.Attitude, rig.View.Position) =
            (view.CameraPitch, view.Attitude, view.Position);
        rig.Order(ImagingMode.Search);
        rig.AddPoses(0, 3);
        rig.Camera!.Add(0, exposedAt: 1, deliveredAt: 1.1);
        rig.Run(2);

        CameraObservation observation = Assert.Single(rig.Sink.Observations);
        var frame = LocalNedFrame.IgnoringGeoid(view.Position);
        TargetReport report = Assert.Single(rig.Sink.Reports);
        Assert.Equal(Near, frame.ToNed(report.Position).North, 0.3);
        var footprint = Footprint.Of(observation, frame);
        Assert.True(footprint.Contains(Near, 0, 0) && !footprint.Contains(Far, 0, 0));
        AssertResolved(view, frame, observation);
    }

    // By 6 mrad, 0.24 m from 40 m: 0.15 m are allowed. In a manoeuvre of some seconds it is no fault of the camera.
    [Fact]
    public void Frame_SmearedByRotation_IsRefusedAndSaysNothingOfTheCameraAtFirst()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Grass);
        for (int i = 0; i <= 120; i++)
            rig.AddPose(
                i / 10.0, rig.View.Position, default, rig.View.Attitude,
                BodyRates.FromRadiansPerSecond(i is < 20 or > 100 ? 0 : 3, 0, 0));
        for (int i = 0; i < 36; i++)
            rig.Camera!.Add(i, 1 + (i / 4.0), 1.1 + (i / 4.0));

        rig.Run(5);
        Assert.Equal((1.0, PictureQuality.Usable), (rig.Status.UsableShare!.Value, rig.Status.UnusableCause));
        Assert.True(rig.Status.FramesRefused >= 8, $"{rig.Status.FramesRefused} refused");
        rig.Run(4);
        Assert.Equal(
            (0.0, PictureQuality.MotionBlurred), (rig.Status.UsableShare!.Value, rig.Status.UnusableCause));
        rig.AssertAllGivenBack();
    }

    [Fact]
    public void Frame_WithoutABufferOrWithOneTooSmall_IsRefused()
    {
        using ImagingRig rig = ImagingRig.Search(new byte[100]);
        rig.AddPoses(0, 2);
        rig.Camera!.Add(0, 1, 1.1);
        rig.Run(2);
        Assert.Equal(PictureSearch.NoBuffer, rig.Status.LastRefusal);
        rig.AssertAllGivenBack();
    }

    private static void PaintPanel(Painting painting, TestView view, double north)
    {
        Assert.True(view.TryProject(north, 0, out double column, out double row));
        Assert.True(view.TryProject(north, 1, out double columnToTheRight, out double rowToTheRight));
        Assert.True(view.TryProject(north + 1, 0, out _, out double rowBeyond));
        double angle = Math.Atan2(rowToTheRight - row, columnToTheRight - column);
        painting.Rectangle(
            Painting.Nominal(DefaultTargetClasses.Red), column, row, (columnToTheRight - column) / Math.Cos(angle),
            (row - rowBeyond) * Math.Cos(angle), angle);
    }

    // The lower corners are those of the picture; the upper ones lie where pixels are as large as they may be.
    private static void AssertResolved(TestView view, LocalNedFrame frame, CameraObservation observation)
    {
        GroundProjection projection = view.Projection(new ErrorBudget());
        NedPosition bottomLeft = frame.ToNed(observation.BottomLeft);
        Assert.True(projection.TryProjectToGround(0, Painting.Height - 1, out NedPosition expected));
        Assert.Equal(0, bottomLeft.HorizontalDistanceTo(expected), 0.1);
        foreach (GeodeticPosition corner in new[] { observation.TopLeft, observation.TopRight })
        {
            NedPosition ned = frame.ToNed(corner);
            Assert.True(view.TryProject(ned.North * 0.99, ned.East * 0.99, out double column, out double row));
            Assert.True(projection.TryScale(column, row, out GroundScale scale));
            Assert.InRange(Math.Sqrt(scale.PixelArea), 0.138, 0.15);
        }
    }

    private static void AssertCorners(TestView view, CameraObservation observation)
    {
        var frame = LocalNedFrame.IgnoringGeoid(view.Position);
        (GeodeticPosition Corner, double Column, double Row)[] corners =
        [
            (observation.TopLeft, 0, 0), (observation.TopRight, Painting.Width - 1, 0),
            (observation.BottomRight, Painting.Width - 1, Painting.Height - 1),
            (observation.BottomLeft, 0, Painting.Height - 1),
        ];
        foreach ((GeodeticPosition corner, double column, double row) in corners)
        {
            // A little towards the middle, so that it is in the picture for certain.
            NedPosition ned = frame.ToNed(corner);
            Assert.True(view.TryProject(ned.North * 0.99, ned.East * 0.99, out double seenColumn, out double seenRow));
            Assert.Equal(column, seenColumn, 6.0);
            Assert.Equal(row, seenRow, 6.0);
        }
    }
}
