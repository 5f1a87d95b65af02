using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing;

/// <summary>The ground scale of a picture over level ground, of a camera whose pose is known.</summary>
internal sealed class LevelGroundScale(CameraModel camera, Rotation nedFromCamera, double heightMetres)
    : IGroundScaleSource
{
    // As Image Processing's default.
    private static readonly Angle MinDepression = Angle.FromDegrees(5);

    public bool TryScale(double column, double row, out GroundScale scale)
    {
        scale = default;
        if (!TryLocate(column - 0.5, row, out NedPosition left) || !TryLocate(column + 0.5, row, out NedPosition right)
            || !TryLocate(column, row - 0.5, out NedPosition above)
            || !TryLocate(column, row + 0.5, out NedPosition below))
            return false;
        scale.NorthByColumn = right.North - left.North;
        scale.EastByColumn = right.East - left.East;
        scale.NorthByRow = below.North - above.North;
        scale.EastByRow = below.East - above.East;
        return true;
    }

    private bool TryLocate(double column, double row, out NedPosition place)
    {
        place = default;
        if (!camera.TryUndistort(column, row, out double x, out double y))
            return false;
        (double north, double east, double down) = nedFromCamera.Apply(x, y, 1);
        return new GroundRay(NedPosition.Origin, new NedVector(north, east, down))
            .TryIntersectLevel(heightMetres, MinDepression, out place);
    }
}
