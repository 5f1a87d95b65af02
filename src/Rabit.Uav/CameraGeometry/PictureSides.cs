using System;
using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>Which way the longer side of a downward picture lies on the ground: there it shows more.</summary>
internal static class PictureSides
{
    // Less is not worth a turn of the vehicle.
    private const double MinRatio = 1.1;

    // A turn of the vehicle moves what a camera sees that looks farther ahead.
    private const double MaxTiltRadians = 10 * Angle.RadiansPerDegree;

    /// <summary>
    /// From forward of the vehicle to the right, or half a turn more; null where no side is longer, or the camera does
    /// not look down.
    /// </summary>
    /// <param name="camera">The camera, without faults.</param>
    /// <param name="mount">How it sits on the vehicle.</param>
    /// <param name="pitch">Where it points, up positive.</param>
    /// <param name="yaw">Where it points, right positive.</param>
    public static Angle? LongerSide(CameraModel camera, CameraMount mount, Angle pitch, Angle yaw)
    {
        Rotation turn = mount.At(pitch, yaw).BodyFromCamera;
        (double forward, double right, double down) = turn.Apply(0, 0, 1);
        double width = camera.Width / camera.FocalX;
        double height = camera.Height / camera.FocalY;
        bool looksDown = down > 0 && Math.Atan2(Math.Sqrt((forward * forward) + (right * right)), down)
            <= MaxTiltRadians;
        if (!looksDown || (width < MinRatio * height && height < MinRatio * width))
            return null;
        (forward, right, _) = width > height ? turn.Apply(1, 0, 0) : turn.Apply(0, 1, 0);
        return Angle.FromRadians(Math.Atan2(right, forward));
    }
}
