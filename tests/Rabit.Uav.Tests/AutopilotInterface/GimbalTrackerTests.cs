using System;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

public sealed class GimbalTrackerTests
{
    private const GimbalDeviceFlags Locks = GimbalDeviceFlags.RollLock | GimbalDeviceFlags.PitchLock;

    private readonly GimbalTracker _tracker = new();

    [Theory]
    [InlineData(GimbalDeviceFlags.YawInVehicleFrame, GimbalFrame.Body)]
    [InlineData(GimbalDeviceFlags.YawInVehicleFrame | Locks, GimbalFrame.Heading)]
    [InlineData(Locks, GimbalFrame.Heading)]
    [InlineData(GimbalDeviceFlags.YawInVehicleFrame | GimbalDeviceFlags.YawLock | Locks, GimbalFrame.Heading)]
    [InlineData(GimbalDeviceFlags.YawLock | Locks, GimbalFrame.North)]
    [InlineData(GimbalDeviceFlags.YawInEarthFrame | Locks, GimbalFrame.North)]
    public void Take_DeviceStatus_HasTheFrameOfItsFlags(GimbalDeviceFlags flags, GimbalFrame frame)
    {
        Assert.Equal(GimbalUpdate.Taken, _tracker.Take(At(0), Status(10, -60, 20, flags)));

        Assert.Equal(frame, _tracker.Attitude.Frame);
        Assert.Equal(10, _tracker.Attitude.Angles.Roll.Degrees, 1e-4);
        Assert.Equal(-60, _tracker.Attitude.Angles.Pitch.Degrees, 1e-4);
        Assert.Equal(20, _tracker.Attitude.Angles.Yaw.Degrees, 1e-4);
        Assert.Equal(1234u, _tracker.BootTimeMs);
    }

    [Theory]
    [InlineData(GimbalDeviceErrorFlags.EncoderError, false)]
    [InlineData(GimbalDeviceErrorFlags.CalibrationRunning, false)]
    [InlineData(GimbalDeviceErrorFlags.AtPitchLimit, true)]
    public void Take_GimbalWithAnError_IsRefusedWhereItsAttitudeIsConcerned(
        GimbalDeviceErrorFlags error, bool isTaken)
    {
        GimbalDeviceAttitudeStatus status = Status(0, 0, 0, Locks);
        status.FailureFlags = error;

        Assert.Equal(isTaken ? GimbalUpdate.Taken : GimbalUpdate.Refused, _tracker.Take(At(0), status));
    }

    [Theory]
    [InlineData(0f)]
    [InlineData(0.9f)]
    [InlineData(float.NaN)]
    public void Take_NoRotation_IsRefused(float w)
    {
        var q = default(FloatArray4);
        q[0] = w;

        Assert.Equal(GimbalUpdate.Refused, _tracker.Take(At(0), new GimbalDeviceAttitudeStatus { Q = q }));
    }

    [Fact]
    public void Take_MountOrientation_IsAgainstTheHorizon()
    {
        var mount = new MountOrientation { Roll = 1, Pitch = -45, Yaw = 10, YawAbsolute = 100 };
        Assert.Equal(GimbalUpdate.Taken, _tracker.Take(At(0), mount));
        Assert.Equal((GimbalFrame.North, 100), (_tracker.Attitude.Frame, Math.Round(YawDegrees(), 6)));

        // A sender of the older form of the message.
        mount.YawAbsolute = 0;
        Assert.Equal(GimbalUpdate.Taken, _tracker.Take(At(1), mount));
        Assert.Equal((GimbalFrame.Heading, 10), (_tracker.Attitude.Frame, Math.Round(YawDegrees(), 6)));

        mount.Pitch = float.NaN;
        Assert.Equal(GimbalUpdate.Refused, _tracker.Take(At(2), mount));
    }

    [Fact]
    public void Take_SeveralGimbals_KeepsTheFirstUntilItIsSilent()
    {
        GimbalDeviceAttitudeStatus other = Status(0, -30, 0, Locks);
        other.GimbalDeviceId = 2;
        Assert.Equal(GimbalUpdate.Taken, _tracker.Take(At(0), Status(0, -90, 0, Locks)));
        Assert.Equal(GimbalUpdate.OfOther, _tracker.Take(At(0.1), other));
        Assert.Equal(GimbalUpdate.OfOther, _tracker.Take(At(1, component: 155), Status(0, 0, 0, Locks)));
        Assert.Equal(-90, _tracker.Attitude.Angles.Pitch.Degrees, 1e-3);

        Assert.Equal(GimbalUpdate.Taken, _tracker.Take(At(5.1), other));
        Assert.Equal(-30, _tracker.Attitude.Angles.Pitch.Degrees, 1e-3);
    }

    [Fact]
    public void Take_BothMessages_PrefersThatOfTheDevice()
    {
        Assert.Equal(GimbalUpdate.Taken, _tracker.Take(At(0), new MountOrientation { Pitch = -10 }));
        Assert.Equal(GimbalUpdate.Taken, _tracker.Take(At(0.1), Status(0, -20, 0, Locks)));
        Assert.Equal(GimbalUpdate.OfOther, _tracker.Take(At(0.2), new MountOrientation { Pitch = -10 }));
        Assert.Equal(GimbalUpdate.Taken, _tracker.Take(At(5.2), new MountOrientation { Pitch = -10 }));
    }

    [Fact]
    public void Manager_GimbalOfTheVehicle_IsPassedOnWithTheTimeOfItsSender()
    {
        using var rig = new AutopilotRig();
        rig.Beat(1);
        GimbalDeviceAttitudeStatus status = Status(0, -60, 0, Locks);
        rig.Send(status, component: 154);
        rig.Send(status, system: 9, component: 154);
        status.FailureFlags = GimbalDeviceErrorFlags.CommsError;
        rig.Send(status, component: 154);
        rig.Run();

        PoseSample sample = Assert.Single(rig.Peers.Poses, p => p.Kind == PoseSampleKind.Gimbal);
        Assert.Equal(GimbalFrame.Heading, sample.Gimbal.Frame);
        Assert.Equal(-60, sample.Gimbal.Angles.Pitch.Degrees, 1e-3);
        Assert.Equal(1, rig.Statistics.RefusedMessages);
    }

    private double YawDegrees() => _tracker.Attitude.Angles.Yaw.Degrees;

    private static GimbalDeviceAttitudeStatus Status(
        double rollDegrees, double pitchDegrees, double yawDegrees, GimbalDeviceFlags flags)
    {
        Rotation rotation = Rotation.FromEuler(EulerAngles.FromDegrees(rollDegrees, pitchDegrees, yawDegrees));
        var q = default(FloatArray4);
        (q[0], q[1], q[2], q[3]) = ((float)rotation.W, (float)rotation.X, (float)rotation.Y, (float)rotation.Z);
        return new GimbalDeviceAttitudeStatus { TimeBootMs = 1234, Flags = flags, Q = q, GimbalDeviceId = 1 };
    }

    private static LinkFrame At(double seconds, byte component = 154)
        => AutopilotRig.FrameOf(new Heartbeat(), TimeSpan.FromSeconds(seconds), AutopilotRig.System, component, 0);
}
