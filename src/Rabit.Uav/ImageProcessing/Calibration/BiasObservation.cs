using System;
using Rabit.Geodesy;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>
/// One observation of a static point: where it was in the picture, and the pose that the autopilot reported for that
/// time. A plain value.
/// </summary>
public struct BiasObservation
{
    /// <summary>Which point; any number, the same for all observations of it.</summary>
    public int Point { get; set; }

    /// <summary>Middle of the exposure.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>Column in the picture; the centre of the top left pixel is 0.</summary>
    public double Column { get; set; }

    /// <summary>Row in the picture.</summary>
    public double Row { get; set; }

    /// <summary>Where the vehicle was, as reported, at <see cref="Time"/>.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>Its velocity, metres per second.</summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>Its attitude, as reported.</summary>
    public EulerAngles Attitude { get; set; }

    /// <summary>Its angular velocity.</summary>
    public BodyRates Rates { get; set; }

    /// <summary>
    /// The gimbal's pitch in <see cref="CameraGeometry.CameraMount.GimbalFrame"/>; -90 degrees for a camera that looks
    /// down.
    /// </summary>
    public Angle GimbalPitch { get; set; }

    /// <summary>The gimbal's yaw, as the pitch.</summary>
    public Angle GimbalYaw { get; set; }
}
