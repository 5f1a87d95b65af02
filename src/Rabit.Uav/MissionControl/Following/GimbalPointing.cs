using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The angles of a gimbal that keep a target in view which moves under the vehicle. Near straight down a small motion
/// of the target is a large turn of the yaw: the yaw is turned no faster than gimbals do, and the pitch is the one that
/// has the target nearest to the middle of the picture meanwhile. One thread.
/// </summary>
internal sealed class GimbalPointing(GimbalFrame frame, double yawRadians)
{
    /// <summary>
    /// From straight down to the optical axis at most: the horizon stays out of the picture, and a target as far off as
    /// its far edge is still several pixels wide.
    /// </summary>
    public const double MaxTiltRadians = 40 * Angle.RadiansPerDegree;

    // Small gimbals turn by 60 degrees a second and more.
    private const double YawRadiansPerSecond = 60 * Angle.RadiansPerDegree;

    // Nearer to straight down the yaw stays: the picture shows it whichever way it is turned.
    private const double MinTiltRadians = 6 * Angle.RadiansPerDegree;

    /// <summary>Camera pitch, up positive.</summary>
    public double PitchRadians { get; private set; } = -Math.PI / 2;

    /// <summary>Camera yaw, right positive.</summary>
    public double YawRadians { get; private set; } = yawRadians;

    /// <summary>Points at a target.</summary>
    /// <param name="fromVehicle">From the vehicle to the target, metres.</param>
    /// <param name="attitude">Of the vehicle.</param>
    /// <param name="seconds">Since the last time.</param>
    public void Point(NedVector fromVehicle, Rotation attitude, double seconds)
    {
        (double forward, double right, double down) = InFrame(fromVehicle, attitude);
        double tilt = Math.Atan2(Math.Sqrt((forward * forward) + (right * right)), down);
        if (tilt >= MinTiltRadians)
        {
            double turn = Math.IEEERemainder(Math.Atan2(right, forward) - YawRadians, 2 * Math.PI);
            double reach = YawRadiansPerSecond * seconds;
            YawRadians = Math.IEEERemainder(YawRadians + Math.Max(-reach, Math.Min(reach, turn)), 2 * Math.PI);
        }

        double ahead = (forward * Trig.Cos(YawRadians)) + (right * Trig.Sin(YawRadians));
        PitchRadians = Math.Max(0, Math.Min(MaxTiltRadians, Math.Atan2(ahead, down))) - (Math.PI / 2);
    }

    private (double Forward, double Right, double Down) InFrame(NedVector v, Rotation attitude)
    {
        if (frame == GimbalFrame.Body)
        {
            BodyVector body = attitude.ToBody(v);
            return (body.Forward, body.Right, body.Down);
        }

        double yaw = frame == GimbalFrame.Heading ? attitude.ToEuler().Yaw.Radians : 0;
        (double sin, double cos) = (Trig.Sin(yaw), Trig.Cos(yaw));
        return ((v.North * cos) + (v.East * sin), (v.East * cos) - (v.North * sin), v.Down);
    }
}
