using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Where the simulated vehicle really is and how it really stands, in the frame of the world: flat, north-east-down,
/// metres, origin at the place where it stood at the start. A plain value.
/// </summary>
public struct TruePose
{
    /// <summary>When, by the clock of the run.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>Where, in the frame of the world; the ground is at 0 down.</summary>
    public NedPosition Position { get; set; }

    /// <summary>Velocity over ground, m/s.</summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>Yaw clockwise from north and not wrapped, pitch nose up, roll right side down.</summary>
    public EulerAngles Attitude { get; set; }

    /// <summary>What the angles of the camera are against.</summary>
    /// <value>The default is <see cref="GimbalFrame.Body"/>.</value>
    public GimbalFrame CameraFrame { get; set; }

    /// <summary>Camera pitch, up positive; -90 degrees is straight down.</summary>
    public Angle CameraPitch { get; set; }

    /// <summary>
    /// Camera roll about its forward axis before it pitches, right side down positive: so much leans a camera that
    /// looks straight down. Zero against the body.
    /// </summary>
    public Angle CameraRoll { get; set; }

    /// <summary>Camera yaw, right positive.</summary>
    public Angle CameraYaw { get; set; }
}
