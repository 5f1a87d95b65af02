using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>How a gimbal is turned: yaw, then pitch, then roll, from where the optical axis points forward.</summary>
/// <param name="Angles">Roll: right side down; pitch: up; yaw: right, positive each.</param>
/// <param name="Frame">What they are against.</param>
public readonly record struct GimbalAttitude(EulerAngles Angles, GimbalFrame Frame)
{
    /// <summary>Against the body, without roll.</summary>
    /// <param name="pitch">Up positive; -90 degrees looks straight down with the top of the picture forward.</param>
    /// <param name="yaw">Right positive.</param>
    public static GimbalAttitude AgainstBody(Angle pitch, Angle yaw)
        => new(new EulerAngles(Angle.Zero, pitch, yaw), GimbalFrame.Body);
}
