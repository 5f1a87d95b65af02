using System;
using Rabit.Geodesy;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>One look at a standing point: where it was in the picture, and what the autopilot said of where the vehicle was then. A plain value.</summary>
public struct BiasLook
{
    /// <summary>Which point; any number, the same for all looks at it.</summary>
    public int Point { get; set; }

    /// <summary>Middle of the exposure.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>Column in the picture; the centre of the top left pixel is 0.</summary>
    public double Column { get; set; }

    /// <summary>Row in the picture.</summary>
    public double Row { get; set; }

    /// <summary>Where the vehicle was, as it was told, at <see cref="Time"/>.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>Its velocity, metres per second.</summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>Its attitude, as it was told.</summary>
    public EulerAngles Attitude { get; set; }

    /// <summary>Its angular velocity.</summary>
    public BodyRates Rates { get; set; }

    /// <summary>The gimbal's pitch, radians; -pi/2 for a camera that looks down.</summary>
    public double GimbalPitchRadians { get; set; }

    /// <summary>The gimbal's yaw, radians.</summary>
    public double GimbalYawRadians { get; set; }
}
