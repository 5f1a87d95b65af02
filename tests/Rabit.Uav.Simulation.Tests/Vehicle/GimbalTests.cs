using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.CameraGeometry;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Vehicle;

/// <summary>What holds the simulated camera, by itself and over the link.</summary>
public sealed class GimbalTests
{
    private const double Step = 0.01;

    [Fact]
    public void AgainstBody_VehicleLeans_AnglesStay()
    {
        var gimbal = new Gimbal();
        for (int i = 0; i < 100; i++)
            gimbal.Step(EulerAngles.FromDegrees(20, -10, i), default, Angle.Zero, Step);

        Assert.Equal(GimbalFrame.Body, gimbal.Angles.Frame);
        Assert.Equal(-Math.PI / 2, gimbal.Angles.Pitch, 9);
        Assert.Equal(0, gimbal.Angles.Roll, 9);
    }

    [Fact]
    public void AgainstBody_NothingPointsIt_LooksWhereItIsFixed()
    {
        var gimbal = new Gimbal(pitch: -0.8, yaw: 0.3);
        gimbal.Step(EulerAngles.FromDegrees(20, -10, 5), default, Angle.Zero, Step);

        Assert.Equal((-0.8, 0.3), (gimbal.Angles.Pitch, gimbal.Angles.Yaw));
    }

    [Theory]
    [InlineData(GimbalFrame.Heading)]
    [InlineData(GimbalFrame.North)]
    public void Stabilised_VehicleLeans_IsDraggedForAMomentAndComesBack(GimbalFrame frame)
    {
        var gimbal = new StabilisedGimbal(seed: 3, frame, heading: 0, Step);
        double atRest = Steps(gimbal, 200, rollRate: 0);
        double leaning = Steps(gimbal, 100, rollRate: 1);
        double after = Steps(gimbal, 200, rollRate: 0);

        Assert.InRange(atRest, 0, 0.004);
        Assert.InRange(leaning, 0.015, 0.03);   // 1 rad/s for 20 ms, and a tremor of 1.7 mrad
        Assert.InRange(after, 0, 0.004);
    }

    [Fact]
    public void Stabilised_Report_IsOffByLessThanADegreeAndNotZero()
    {
        var gimbal = new StabilisedGimbal(seed: 4, GimbalFrame.Heading, heading: 0, Step);
        Steps(gimbal, 100, rollRate: 0.5);

        double off = gimbal.Reported.Pitch - gimbal.Angles.Pitch;
        Assert.InRange(Math.Abs(off), 1e-6, Math.PI / 180);
        Assert.Equal(GimbalFrame.Heading, gimbal.Reported.Frame);
    }

    [Fact]
    public void HoldsNorth_VehicleTurns_KeepsItsDirectionAndReportsItWithTheErrorOfTheHeading()
    {
        var gimbal = new StabilisedGimbal(seed: 5, GimbalFrame.North, heading: 0, Step);
        gimbal.Point(-1, 0.5, isYawFromNorth: true);
        for (int i = 0; i < 300; i++)
            gimbal.Step(EulerAngles.FromDegrees(0, 0, 0.3 * i), default, Angle.FromDegrees(3), Step);

        Assert.Equal(0.5, gimbal.Angles.Yaw, 0.03);
        Assert.Equal(-1, gimbal.Angles.Pitch, 0.01);
        Assert.Equal(3 * Math.PI / 180, gimbal.Reported.Yaw - gimbal.Angles.Yaw, 0.01);
    }

    [Fact]
    public void FollowsHeading_VehicleTurns_StaysBehindAndCatchesUp()
    {
        var gimbal = new StabilisedGimbal(seed: 6, GimbalFrame.Heading, heading: 0, Step);
        for (int i = 0; i < 100; i++)
            gimbal.Step(EulerAngles.FromDegrees(0, 0, 0.5 * i), default, Angle.Zero, Step);
        double behind = gimbal.Angles.Yaw;
        for (int i = 0; i < 200; i++)
            gimbal.Step(EulerAngles.FromDegrees(0, 0, 49.5), default, Angle.Zero, Step);

        Assert.Equal(-0.25 * 50 * Math.PI / 180, behind, 0.03);   // 50 degrees a second for 0.25 s
        Assert.Equal(0, gimbal.Angles.Yaw, 0.01);
    }

    // The other way about: what a command says of its yaw, in what the gimbal holds.
    [Theory]
    [InlineData(GimbalFrame.Heading, true, -1.0)]
    [InlineData(GimbalFrame.Heading, false, 0.2)]
    [InlineData(GimbalFrame.North, true, 0.2)]
    [InlineData(GimbalFrame.North, false, 1.4)]
    public void Point_YawOfEitherFrame_IsTurnedIntoItsOwn(GimbalFrame frame, bool isFromNorth, double expected)
    {
        var vehicle = EulerAngles.FromRadians(0, 0, 1.2);
        var gimbal = new StabilisedGimbal(seed: 7, frame, heading: 1.2, Step);
        gimbal.Point(-Math.PI / 2, 0.2, isFromNorth);
        for (int i = 0; i < 300; i++)
            gimbal.Step(vehicle, default, Angle.Zero, Step);

        Assert.Equal(expected, gimbal.Angles.Yaw, 0.02);
    }

    [Theory]
    [InlineData(0, false)]
    [InlineData((float)(uint)GimbalManagerFlags.YawLock, true)]
    [InlineData((float)(uint)GimbalManagerFlags.YawInEarthFrame, true)]
    [InlineData((float)(uint)(GimbalManagerFlags.YawLock | GimbalManagerFlags.YawInVehicleFrame), false)]
    [InlineData(float.NaN, false)]
    [InlineData(float.PositiveInfinity, false)]
    [InlineData(-1, false)]
    [InlineData(1e30f, false)]
    public void IsYawFromNorth_AnyFlags_AreReadAsTheCommonMessageSetSays(float flags, bool expected)
        => Assert.Equal(expected, Gimbal.IsYawFromNorth(flags));

    // Against the aircraft's own rotations, which the simulation does not use.
    [Fact]
    public void ToQuaternion_YawRollPitch_IsTheProductOfTheThree()
    {
        var angles = new GimbalAngles(GimbalFrame.North, yaw: 0.7, roll: -0.2, pitch: -1.1);
        FloatArray4 q = angles.ToQuaternion();
        Rotation expected = Rotation.FromEuler(EulerAngles.FromRadians(0, 0, 0.7))
            * Rotation.FromEuler(EulerAngles.FromRadians(-0.2, 0, 0))
            * Rotation.FromEuler(EulerAngles.FromRadians(0, -1.1, 0));

        (double x, double y, double z) = Rotation.FromQuaternion(q[0], q[1], q[2], q[3]).Apply(1, 2, 3);
        (double ex, double ey, double ez) = expected.Apply(1, 2, 3);
        Assert.Equal(ex, x, 6);
        Assert.Equal(ey, y, 6);
        Assert.Equal(ez, z, 6);
    }

    [Theory]
    [InlineData(GimbalFrame.Body)]
    [InlineData(GimbalFrame.Heading)]
    [InlineData(GimbalFrame.North)]
    public void CameraPose_EachFrame_LooksWhereTheGeometryOfTheAircraftSays(GimbalFrame frame)
    {
        var attitude = EulerAngles.FromDegrees(12, -9, 130);
        var options = new SimulatedCameraOptions { MisalignmentPitch = Angle.FromDegrees(2) };
        var angles = new GimbalAngles(frame, yaw: 0.4, roll: 0.1, pitch: -1.2);
        var pose = new CameraPose(
            new TruePose
            {
                Attitude = attitude,
                CameraFrame = frame,
                CameraPitch = Angle.FromRadians(angles.Pitch),
                CameraRoll = Angle.FromRadians(angles.Roll),
                CameraYaw = Angle.FromRadians(angles.Yaw),
            },
            options);

        FloatArray4 q = angles.ToQuaternion();
        Rotation body = Rotation.FromEuler(attitude);
        CameraExtrinsics seen = new CameraMount { MisalignmentPitch = options.MisalignmentPitch }.At(
            new GimbalAttitude(Rotation.FromQuaternion(q[0], q[1], q[2], q[3]).ToEuler(), frame), body);
        AssertSame((body * seen.BodyFromCamera).Apply(0, 0, 1), pose.Axes.Forward);
        AssertSame((body * seen.BodyFromCamera).Apply(1, 0, 0), pose.Axes.Right);
    }

    [Theory]
    [InlineData(GimbalFrame.Body, GimbalDeviceFlags.YawInVehicleFrame)]
    [InlineData(GimbalFrame.Heading,
        GimbalDeviceFlags.RollLock | GimbalDeviceFlags.PitchLock | GimbalDeviceFlags.YawInVehicleFrame)]
    [InlineData(GimbalFrame.North, GimbalDeviceFlags.RollLock | GimbalDeviceFlags.PitchLock | GimbalDeviceFlags.YawLock
        | GimbalDeviceFlags.YawInEarthFrame)]
    public void Flags_EachFrame_AreThoseOfTheCommonMessageSet(GimbalFrame frame, GimbalDeviceFlags expected)
        => Assert.Equal(expected, new GimbalAngles(frame, 0, 0, 0).Flags);

    [Fact]
    public void Options_GimbalOfNoNumber_IsRefused()
    {
        var options = new SimulationOptions { Camera = { Gimbal = (SimulatedGimbal)9 } };

        ArgumentException refused = Assert.Throws<ArgumentException>(() => new SimulatedWorld(options));
        Assert.Contains("Gimbal is 9", refused.Message);
    }

    private static void AssertSame((double X, double Y, double Z) expected, Vector3 actual)
    {
        Assert.Equal(expected.X, actual.First, 6);
        Assert.Equal(expected.Y, actual.Second, 6);
        Assert.Equal(expected.Z, actual.Third, 6);
    }

    // How far the camera leans at the end.
    private static double Steps(StabilisedGimbal gimbal, int count, double rollRate)
    {
        for (int i = 0; i < count; i++)
            gimbal.Step(default, BodyRates.FromRadiansPerSecond(rollRate, 0, 0), Angle.Zero, Step);
        return Math.Abs(gimbal.Angles.Roll);
    }
}
