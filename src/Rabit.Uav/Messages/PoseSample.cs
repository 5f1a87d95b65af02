using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.Messages;

/// <summary>
/// One thing that the autopilot said of where the vehicle was or how it or its camera was turned, with the time at
/// which that was true by the clock of the run. A plain value; what <see cref="Kind"/> does not name is empty.
/// </summary>
public struct PoseSample
{
    /// <summary>Which part it holds.</summary>
    public PoseSampleKind Kind { get; set; }

    /// <summary>
    /// When it was true, by the clock of the run: the autopilot's own time stamp, mapped to our clock.
    /// </summary>
    public TimeSpan Time { get; set; }

    /// <summary>
    /// One standard deviation of <see cref="Time"/>, the same for all samples, seconds: what the two ways of the link
    /// may differ by, which no exchange of times can show (half of the shortest round trip at most), and the error of
    /// the estimate.
    /// </summary>
    public double TimeErrorSeconds { get; set; }

    /// <summary>Where the vehicle was. Of a position.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>Height above the home position, metres, up positive. Of a position.</summary>
    public double HeightAboveHomeMetres { get; set; }

    /// <summary>Velocity over ground, metres per second, north-east-down. Of a position.</summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>Attitude of the body in the local north-east-down frame. Of an attitude.</summary>
    public EulerAngles Attitude { get; set; }

    /// <summary>Angular velocity in the body frame. Of an attitude.</summary>
    public BodyRates Rates { get; set; }

    /// <summary>How the camera's gimbal was turned. Of a gimbal.</summary>
    public GimbalAttitude Gimbal { get; set; }
}
