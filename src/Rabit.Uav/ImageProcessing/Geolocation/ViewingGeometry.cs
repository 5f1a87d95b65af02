using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// Everything from which a picture's lines of sight are reckoned: where the vehicle was, how its camera stood, where the ground is. The
/// frame is north-east-down with its origin at the vehicle. A plain value.
/// </summary>
internal struct ViewingGeometry
{
    public Pose Pose { get; set; }

    public double GimbalPitchRadians { get; set; }

    public double GimbalYawRadians { get; set; }

    /// <summary>Below the vehicle, metres.</summary>
    public double GroundDownMetres { get; set; }

    /// <summary>Where the ground's slope is reckoned from; of no matter where it is level.</summary>
    public NedVector GroundPoint { get; set; }

    /// <summary>How much lower the ground is for a metre to the north.</summary>
    public double GroundDownByNorth { get; set; }

    /// <summary>How much lower the ground is for a metre to the east.</summary>
    public double GroundDownByEast { get; set; }

    /// <summary>What a direction of the camera's looks at: a line in the frame.</summary>
    /// <param name="mount">Of the camera.</param>
    /// <param name="x">To the right, for 1 along the optical axis.</param>
    /// <param name="y">Down, for 1 along the optical axis.</param>
    public readonly GroundRay RayOf(CameraMount mount, double x, double y)
        => Ray(Pose.Attitude, mount.At(GimbalPitchRadians, GimbalYawRadians), default, x, y);

    public static GroundRay Ray(Rotation attitude, CameraExtrinsics camera, NedVector vehicle, double x, double y)
    {
        NedVector arm = attitude.ToNed(camera.PositionMetres);
        (double north, double east, double down) = (attitude * camera.BodyFromCamera).Apply(x, y, 1);
        return new GroundRay(
            new NedVector(vehicle.North + arm.North, vehicle.East + arm.East, vehicle.Down + arm.Down),
            new NedVector(north, east, down));
    }
}
