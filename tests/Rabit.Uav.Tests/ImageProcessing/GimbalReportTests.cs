using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>A gimbal that reports its attitude: its samples are waited for, held, and missed.</summary>
public sealed class GimbalReportTests
{
    private readonly PoseHistory _history = new(TimeSpan.FromSeconds(1));

    [Fact]
    public void Find_BetweenTwoReports_IsInterpolated()
    {
        AddBody(0, 2);
        AddGimbal(1, -90);
        AddGimbal(1.4, -50);

        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1.1), out Pose pose));
        Assert.Equal(-80, pose.Gimbal!.Value.Angles.Pitch.Degrees, 1e-6);
        Assert.Equal(GimbalFrame.Heading, pose.Gimbal.Value.Frame);
        Assert.Equal(PoseLookup.TooOld, _history.Find(Seconds(0.9), out _));
        Assert.Equal(PoseLookup.NotYet, _history.Find(Seconds(1.5), out pose));
        Assert.Null(pose.Gimbal);
    }

    [Fact]
    public void Find_NoReportsEver_IsWithoutAGimbal()
    {
        AddBody(0, 2);

        Assert.Equal(PoseLookup.Known, _history.Find(Seconds(1.1), out Pose pose));
        Assert.Null(pose.Gimbal);
        Assert.False(_history.IsGimbalSilent(Seconds(100)));
    }

    [Fact]
    public void Extrapolate_BeyondTheNewestReport_HoldsItAndInterpolatesTheBody()
    {
        AddBody(0, 2);
        AddGimbal(0.5, -70);

        Assert.Equal(
            PoseLookup.Extrapolated, _history.Extrapolate(Seconds(1.05), TimeSpan.FromSeconds(0.1), out Pose pose));
        Assert.Equal(-70, pose.Gimbal!.Value.Angles.Pitch.Degrees, 1e-6);
        Assert.Equal(0, pose.ExtrapolatedSeconds);
        Assert.Equal(10.5, NorthOf(pose), 1e-6);
        Assert.False(_history.IsGimbalSilent(Seconds(1.9)));
    }

    [Fact]
    public void Extrapolate_GimbalSilent_HasNoPose()
    {
        AddBody(0, 3);
        AddGimbal(0.5, -70);

        Assert.Equal(PoseLookup.NotYet, _history.Extrapolate(Seconds(2.1), TimeSpan.FromSeconds(0.1), out _));
        Assert.True(_history.IsGimbalSilent(Seconds(2.1)));
    }

    [Fact]
    public void Add_GimbalThatIsNoNumber_IsRefused()
    {
        _history.Add(new PoseSample
        {
            Kind = PoseSampleKind.Gimbal,
            Gimbal = new GimbalAttitude(new EulerAngles(Angle.Zero, Angle.NaN, Angle.Zero), GimbalFrame.Body),
        });

        Assert.Equal(1, _history.Refused);
    }

    [Fact]
    public void Frame_GimbalNotWhereItWasPointed_IsLocatedByItsReport()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Panel);
        rig.AddPoses(0, 2);
        for (int i = 0; i <= 20; i++)
            rig.AddGimbal(i / 10.0, -80);
        rig.Camera!.Add(0, 1, deliveredAt: 1.15);
        rig.Run(2);

        // Ten degrees further up than it was pointed, at 40 m: about 7 m further ahead than it is painted.
        TargetReport report = Assert.Single(rig.Sink.Reports);
        NedPosition place = LocalNedFrame.IgnoringGeoid(rig.View.Position).ToNed(report.Position);
        Assert.InRange(place.North - ImagingRig.North, 6.5, 8.5);
    }

    [Fact]
    public void Frame_GimbalFallsSilent_IsRefusedWithTheReason()
    {
        using ImagingRig rig = ImagingRig.Search(ImagingRig.Panel);
        rig.AddPoses(0, 8);
        rig.AddGimbal(0.5, -90);
        rig.AddGimbal(1.05, -90);
        rig.Camera!.Add(0, 1, deliveredAt: 1.15);
        rig.Camera.Add(1, 4, deliveredAt: 4.15);
        rig.Run(6);

        Assert.Single(rig.Sink.Observations);
        Assert.Equal(1, rig.Status.FramesRefused);
        Assert.Equal(ImageProcessingManager.GimbalSilent, rig.Status.LastRefusal);
        rig.AssertAllGivenBack();
    }

    private void AddBody(double from, double to)
    {
        for (int i = (int)(from * 10); i <= to * 10; i++)
        {
            TimeSpan time = Seconds(i / 10.0);
            _history.Add(new PoseSample
            {
                Kind = PoseSampleKind.Position,
                Time = time,
                Position = LocalNedFrame.IgnoringGeoid(Start).ToGeodetic(new NedPosition(i, 0, 0)),
                VelocityNed = new NedVector(10, 0, 0),
            });
            _history.Add(new PoseSample { Kind = PoseSampleKind.Attitude, Time = time });
        }
    }

    private void AddGimbal(double seconds, double pitchDegrees) => _history.Add(new PoseSample
    {
        Kind = PoseSampleKind.Gimbal,
        Time = Seconds(seconds),
        Gimbal = new GimbalAttitude(EulerAngles.FromDegrees(0, pitchDegrees, 0), GimbalFrame.Heading),
    });

    private static GeodeticPosition Start => GeodeticPosition.FromDegrees(47, 8, 100);

    private static double NorthOf(in Pose pose) => LocalNedFrame.IgnoringGeoid(Start).ToNed(pose.Position).North;

    private static TimeSpan Seconds(double seconds) => TimeSpan.FromTicks((long)(seconds * TimeSpan.TicksPerSecond));
}
