using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// The viewing geometry of a picture, from which its rays are computed: where the vehicle was, how its camera was
/// turned, where the ground is. The frame is north-east-down with its origin at the vehicle. A plain value.
/// </summary>
internal struct ViewingGeometry
{
    public Pose Pose { get; set; }

    public GimbalAttitude Gimbal { get; set; }

    /// <summary>Below the vehicle, metres.</summary>
    public double GroundDownMetres { get; set; }

    /// <summary>Where the ground's slope is taken at; irrelevant where it is level.</summary>
    public NedPosition GroundPoint { get; set; }

    /// <summary>How much lower the ground is for a metre to the north.</summary>
    public double GroundDownByNorth { get; set; }

    /// <summary>How much lower the ground is for a metre to the east.</summary>
    public double GroundDownByEast { get; set; }

    /// <summary>The ray of a direction of the camera, in the frame.</summary>
    /// <param name="mount">Of the camera.</param>
    /// <param name="x">To the right, for 1 along the optical axis.</param>
    /// <param name="y">Down, for 1 along the optical axis.</param>
    public readonly GroundRay RayOf(CameraMount mount, double x, double y)
        => Ray(Pose.Attitude, mount.At(Gimbal, Pose.Attitude), default, x, y);

    public static GroundRay Ray(Rotation attitude, CameraExtrinsics camera, NedPosition vehicle, double x, double y)
    {
        NedVector arm = attitude.ToNed(camera.PositionMetres);
        (double north, double east, double down) = (attitude * camera.BodyFromCamera).Apply(x, y, 1);
        return new GroundRay(vehicle + arm, new NedVector(north, east, down));
    }
}
