using System;
using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>
/// The strip of level ground that a camera sees on a straight flight: what lanes must be nearer than.
/// </summary>
internal static class PictureSwath
{
    // A straight border is a straight line on the ground; what a lens bends it by shows between eight points.
    private const int PointsOfSide = 8;

    // Nearer to the horizon a picture has no end; searches point the camera further down.
    private static readonly Angle MinDepression = Angle.FromDegrees(1);

    /// <summary>How wide it is across the flight, of a vehicle that is level.</summary>
    /// <param name="camera">The camera, without faults.</param>
    /// <param name="mount">How it sits on the vehicle.</param>
    /// <param name="pitch">Where it points, up positive.</param>
    /// <param name="yaw">Where it points, right positive.</param>
    /// <param name="heightMetres">Height above the ground.</param>
    /// <returns>Metres; infinity where the border of the picture is at the horizon.</returns>
    public static double WidthMetres(
        CameraModel camera, CameraMount mount, Angle pitch, Angle yaw, double heightMetres)
    {
        CameraExtrinsics extrinsics = mount.At(pitch, yaw);
        double left = double.PositiveInfinity;
        double right = double.NegativeInfinity;
        for (int i = 0; i <= PointsOfSide; i++)
        {
            double column = (camera.Width - 1.0) * i / PointsOfSide;
            double row = (camera.Height - 1.0) * i / PointsOfSide;
            foreach ((double x, double y) in new (double, double)[]
            {
                (column, 0), (column, camera.Height - 1), (0, row), (camera.Width - 1, row),
            })
            {
                double across = AcrossMetres(camera, extrinsics, x, y, heightMetres);
                if (double.IsNaN(across))
                    return double.PositiveInfinity;
                (left, right) = (Math.Min(left, across), Math.Max(right, across));
            }
        }

        return right - left;
    }

    // The body of a level vehicle that flies north: its right is east.
    private static double AcrossMetres(
        CameraModel camera, in CameraExtrinsics extrinsics, double column, double row, double heightMetres)
    {
        if (!camera.TryUndistort(column, row, out double x, out double y))
            return double.NaN;
        (double forward, double right, double down) = extrinsics.BodyFromCamera.Apply(x, y, 1);
        var ray = new GroundRay(
            new NedPosition(0, extrinsics.PositionMetres.Right, extrinsics.PositionMetres.Down - heightMetres),
            new NedVector(forward, right, down));
        return ray.TryIntersectLevel(0, MinDepression, out NedPosition point) ? point.East : double.NaN;
    }
}
