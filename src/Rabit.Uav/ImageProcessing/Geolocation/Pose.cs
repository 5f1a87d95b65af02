using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>The pose of the vehicle, position and attitude, at a moment. A plain value.</summary>
internal struct Pose
{
    public TimeSpan Time { get; set; }

    public GeodeticPosition Position { get; set; }

    /// <summary>Metres per second; zero where the autopilot did not report it.</summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>From the body to north-east-down.</summary>
    public Rotation Attitude { get; set; }

    public BodyRates Rates { get; set; }

    /// <summary>How its camera's gimbal was turned; null where the gimbal does not report it.</summary>
    public GimbalAttitude? Gimbal { get; set; }

    /// <summary>How far beyond the newest sample it was extrapolated, seconds; 0 for a pose between samples.</summary>
    public double ExtrapolatedSeconds { get; set; }

    /// <summary>
    /// One standard deviation of its time, the same for all poses of a flight, seconds; see
    /// <see cref="PoseSample.TimeErrorSeconds"/>.
    /// </summary>
    public double TimeErrorSeconds { get; set; }

    /// <summary>What it was, or will be, at the same velocity and rates.</summary>
    public readonly Pose After(double seconds)
    {
        var frame = LocalNedFrame.IgnoringGeoid(Position);
        Pose pose = this;
        pose.Time = Time + TimeSpan.FromTicks((long)Math.Round(seconds * TimeSpan.TicksPerSecond));
        pose.Position = frame.ToGeodetic(NedPosition.Origin + (seconds * VelocityNed));
        pose.Attitude = Attitude.After(Rates, seconds);
        return pose;
    }
}
