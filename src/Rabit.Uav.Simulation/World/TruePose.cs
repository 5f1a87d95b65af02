using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Where the simulated vehicle really is and how it really stands, in the frame of the world: flat, north-east-down,
/// metres, origin at the place where it stood at the start. Angles in radians: yaw clockwise from north, pitch nose
/// up, roll right side down. A plain value.
/// </summary>
public struct TruePose
{
    /// <summary>When, by the clock of the run.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>Metres north.</summary>
    public double North { get; set; }

    /// <summary>Metres east.</summary>
    public double East { get; set; }

    /// <summary>Metres down; the ground is at 0.</summary>
    public double Down { get; set; }

    /// <summary>Metres per second, over ground.</summary>
    public double NorthSpeed { get; set; }

    /// <summary>Metres per second, over ground.</summary>
    public double EastSpeed { get; set; }

    /// <summary>Metres per second, down positive.</summary>
    public double DownSpeed { get; set; }

    /// <summary>Radians.</summary>
    public double Roll { get; set; }

    /// <summary>Radians.</summary>
    public double Pitch { get; set; }

    /// <summary>Radians, not wrapped.</summary>
    public double Yaw { get; set; }

    /// <summary>Camera pitch against the body, radians, up positive; -pi/2 is straight down.</summary>
    public double CameraPitch { get; set; }

    /// <summary>Camera yaw against the body, radians, right positive.</summary>
    public double CameraYaw { get; set; }
}
