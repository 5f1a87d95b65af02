using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>The marker to land on as LANDING_TARGET, as each make takes it.</summary>
public sealed class LandingTargetTests
{
    // 3 m forward, 1 m left, 4 m below, of a vehicle that looks east.
    private static readonly BodyVector Body = new(3, -1, 4);
    private static readonly NedVector Ned = new(1, 3, 4);

    [Fact]
    public void Target_ArduPilot_IsSentByAnglesAndDistance()
    {
        using AutopilotRig rig = Connected(MavAutopilot.Ardupilotmega);
        rig.Post(Observation(rig, age: 0.1));
        rig.Run();

        LandingTarget sent = Assert.Single(Sent(rig));
        Assert.Equal(MavFrame.BodyFrd, sent.Frame);
        Assert.Equal(MavBool.False, sent.PositionValid);

        // AC_PrecLand_MAVLink: the direction is (-tan(angle_y), tan(angle_x), 1).
        Assert.Equal(0.75, -Math.Tan(sent.AngleY), 1e-6);
        Assert.Equal(-0.25, Math.Tan(sent.AngleX), 1e-6);
        Assert.Equal(Math.Sqrt(26), sent.Distance, 1e-5);
        Assert.Equal(900_000ul, sent.TimeUsec);
        Assert.Equal((LandingTargetType.VisionFiducial, (byte)0), (sent.Type, sent.TargetNum));
        Assert.Equal((1L, 0L), (rig.Statistics.LandingTargetsSent, rig.Statistics.LandingTargetsNotSent));
    }

    [Fact]
    public void Target_Px4_IsSentAsAPlaceInItsLocalFrameAtTheTimeOfThePicture()
    {
        using AutopilotRig rig = Connected(MavAutopilot.Px4);
        rig.Send(LocalPosition(rig, north: 100, east: 200, down: -30, velocityEast: 5));
        rig.Run(0.3);
        rig.Post(Observation(rig, age: 0.1));
        rig.Run();

        LandingTarget sent = Assert.Single(Sent(rig));
        Assert.Equal((MavFrame.LocalNed, MavBool.True), (sent.Frame, sent.PositionValid));

        // The picture is of 0.2 s after the position: 1 m further east.
        Assert.Equal(101, sent.X, 1e-3);
        Assert.Equal(204, sent.Y, 1e-3);
        Assert.Equal(-26, sent.Z, 1e-3);
        Assert.Equal([1f, 0f, 0f, 0f], new[] { sent.Q[0], sent.Q[1], sent.Q[2], sent.Q[3] });
    }

    [Theory]
    [InlineData(0.4, 1)]
    [InlineData(0.6, 0)]
    public void Target_Px4PositionIsOld_IsNotSent(double seconds, int sent)
    {
        using AutopilotRig rig = Connected(MavAutopilot.Px4);
        rig.Send(LocalPosition(rig, 1, 2, 3, 0));
        rig.Run(seconds);
        rig.Post(Observation(rig, age: 0));
        rig.Run();

        Assert.Equal(sent, Sent(rig).Length);
        Assert.Equal(
            ((long)sent, 1L - sent), (rig.Statistics.LandingTargetsSent, rig.Statistics.LandingTargetsNotSent));
    }

    [Fact]
    public void Target_Px4PositionNotFinite_IsRefusedAndNothingIsSent()
    {
        using AutopilotRig rig = Connected(MavAutopilot.Px4);
        long refused = rig.Statistics.RefusedMessages;
        rig.Send(LocalPosition(rig, float.NaN, 2, 3, 0));
        rig.Run();
        rig.Post(Observation(rig, age: 0));
        rig.Run();

        Assert.Empty(Sent(rig));
        Assert.Equal(refused + 1, rig.Statistics.RefusedMessages);
    }

    [Fact]
    public void Target_Px4RestartsInBetween_IsNotSent()
    {
        using AutopilotRig rig = Connected(MavAutopilot.Px4);
        rig.Send(new SystemTime { TimeBootMs = 900_000 });
        rig.Send(LocalPosition(rig, 1, 2, 3, 0));
        rig.Run(0.1);
        rig.Send(new SystemTime { TimeBootMs = 1_000 });
        rig.Send(new SystemTime { TimeBootMs = 1_100 });
        rig.Run();
        Assert.Equal(1, rig.Statistics.Reboots);
        rig.Post(Observation(rig, age: 0));
        rig.Run();

        Assert.Empty(Sent(rig));
    }

    [Theory]
    [InlineData(0.5, 1)]
    [InlineData(0.51, 0)]
    public void Target_OldPicture_IsNotSent(double age, int sent)
    {
        using AutopilotRig rig = Connected(MavAutopilot.Ardupilotmega);
        rig.Post(Observation(rig, age));
        rig.Run();

        Assert.Equal(sent, Sent(rig).Length);
    }

    [Fact]
    public void Target_ArduPilotNotBelow_IsNotSent()
    {
        using AutopilotRig rig = Connected(MavAutopilot.Ardupilotmega);
        LandingTargetObservation target = Observation(rig, age: 0);
        target.PositionMetres = new BodyVector(3, 1, -0.1);
        rig.Post(target);
        rig.Run();

        Assert.Empty(Sent(rig));
        Assert.Equal(1, rig.Statistics.LandingTargetsNotSent);
    }

    [Fact]
    public void Target_AnotherMake_IsNotSent()
    {
        using AutopilotRig rig = Connected(MavAutopilot.Generic);
        rig.Post(Observation(rig, age: 0));
        rig.Run();

        Assert.Empty(Sent(rig));
        Assert.Equal(1, rig.Statistics.LandingTargetsNotSent);
    }

    [Fact]
    public void Target_NoAutopilot_IsNotSent()
    {
        using AutopilotRig rig = new(Options());
        rig.Run(1);
        rig.Post(Observation(rig, age: 0));
        rig.Run();

        Assert.Empty(Sent(rig));
        Assert.Equal(1, rig.Statistics.LandingTargetsNotSent);
    }

    [Fact]
    public void Target_NotAskedFor_IsNeitherSentNorCounted()
    {
        using AutopilotRig rig = Connected(
            MavAutopilot.Ardupilotmega, new AutopilotOptions { RequestsRates = false });
        rig.Post(Observation(rig, age: 0));
        rig.Run();

        Assert.Empty(Sent(rig));
        Assert.Equal((0L, 0L), (rig.Statistics.LandingTargetsSent, rig.Statistics.LandingTargetsNotSent));
    }

    private static AutopilotOptions Options() => new() { RequestsRates = false, SendsLandingTarget = true };

    private static AutopilotRig Connected(MavAutopilot make, AutopilotOptions? options = null)
    {
        var rig = new AutopilotRig(options ?? Options());
        Heartbeat heartbeat = AutopilotRig.Copter();
        heartbeat.Autopilot = make;
        rig.Beat(1, heartbeat);
        return rig;
    }

    private static LandingTargetObservation Observation(AutopilotRig rig, double age) => new()
    {
        Time = rig.Reactor.Now - TimeSpan.FromSeconds(age),
        PictureNumber = 1,
        PositionMetres = Body,
        OffsetNedMetres = Ned,
    };

    private static LocalPositionNed LocalPosition(
        AutopilotRig rig, float north, float east, float down, float velocityEast) => new()
        {
            TimeBootMs = (uint)rig.Reactor.Now.TotalMilliseconds + 900_000,
            X = north,
            Y = east,
            Z = down,
            Vy = velocityEast,
        };

    private static LandingTarget[] Sent(AutopilotRig rig)
        => [.. rig.Sink.Frames.Where(f => f.Frame.MessageId == LandingTarget.MavlinkId)
            .Select(f => OutgoingSink.Decode<LandingTarget>(f.Frame))];
}
