using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Where the camera is and where it looks, in the frame of the world: the optical axis is forward of its axes, right
/// of the picture is right, down in the picture is down. A plain value.
/// </summary>
internal readonly struct CameraPose
{
    public CameraPose(in TruePose pose, SimulatedCameraOptions camera)
    {
        Time = pose.Time;
        BodyAxes body = BodyAxes.FromEulerAngles(
            pose.Attitude.Yaw.Radians, pose.Attitude.Pitch.Radians, pose.Attitude.Roll.Radians);
        BodyAxes foot = BodyAxes.FromEulerAngles(
            camera.MisalignmentYaw.Radians, camera.MisalignmentPitch.Radians, camera.MisalignmentRoll.Radians);
        Axes = TurnOf(pose).TransformedBy(foot).TransformedBy(OuterOf(pose, body));

        Vector3 lever = body.Transform(
            new Vector3(camera.LeverArmForwardMetres, camera.LeverArmRightMetres, camera.LeverArmDownMetres));
        North = pose.Position.North + lever.First;
        East = pose.Position.East + lever.Second;
        Height = -(pose.Position.Down + lever.Third);
    }

    // Yaw, then roll, then pitch.
    private static BodyAxes TurnOf(in TruePose pose)
        => pose.CameraRoll == Angle.Zero
            ? BodyAxes.FromEulerAngles(pose.CameraYaw.Radians, pose.CameraPitch.Radians, roll: 0)
            : BodyAxes.FromEulerAngles(yaw: 0, pose.CameraPitch.Radians, roll: 0).TransformedBy(
                BodyAxes.FromEulerAngles(pose.CameraYaw.Radians, pitch: 0, pose.CameraRoll.Radians));

    private static BodyAxes OuterOf(in TruePose pose, in BodyAxes body) => pose.CameraFrame switch
    {
        GimbalFrame.Heading => BodyAxes.FromEulerAngles(pose.Attitude.Yaw.Radians, pitch: 0, roll: 0),
        GimbalFrame.North => BodyAxes.FromEulerAngles(yaw: 0, pitch: 0, roll: 0),
        _ => body,
    };

    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; }

    public BodyAxes Axes { get; }

    /// <summary>Metres.</summary>
    public double North { get; }

    /// <summary>Metres.</summary>
    public double East { get; }

    /// <summary>Above the ground, metres.</summary>
    public double Height { get; }
}
