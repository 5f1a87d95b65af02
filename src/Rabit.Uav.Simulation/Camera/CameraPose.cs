using System;

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
        Axes = BodyAxes.FromEulerAngles(pose.CameraYaw.Radians, pose.CameraPitch.Radians, roll: 0).TransformedBy(foot)
            .TransformedBy(body);

        Vector3 lever = body.Transform(
            new Vector3(camera.LeverArmForwardMetres, camera.LeverArmRightMetres, camera.LeverArmDownMetres));
        North = pose.Position.North + lever.First;
        East = pose.Position.East + lever.Second;
        Height = -(pose.Position.Down + lever.Third);
    }

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
