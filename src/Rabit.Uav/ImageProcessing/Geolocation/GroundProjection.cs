using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// From the pixels of one picture to the ground, at one pose: made by <see cref="GroundProjector.At"/>, for the thread of that
/// projector. A value; pass it by reference, it is large.
/// </summary>
internal readonly struct GroundProjection
{
    private readonly GroundProjector _projector;
    private readonly ViewingGeometry _geometry;
    private readonly LocalNedFrame _frame;

    internal GroundProjection(GroundProjector projector, in Pose pose, in ImagingCommand command)
    {
        _projector = projector;
        _frame = LocalNedFrame.IgnoringGeoid(pose.Position);
        _geometry = new ViewingGeometry
        {
            Pose = pose,
            GimbalPitchRadians = command.CameraPitchRadians,
            GimbalYawRadians = command.CameraYawRadians,
            GroundDownMetres = pose.Position.AltitudeAmslMetres - command.GroundAltitudeAmslMetres,
        };
    }

    /// <summary>Where a pixel's ray intersects the ground, metres from the vehicle; or why it does not.</summary>
    public GeolocationError Locate(double column, double row, out NedVector ground)
    {
        ground = default;
        if (!_projector.Camera.TryUndistort(column, row, out double x, out double y))
            return GeolocationError.LensCannotBeUndone;
        GroundRay ray = _geometry.RayOf(_projector.Mount, x, y);
        if (_projector.Terrain is { } terrain)
            return TerrainRay.Intersect(ray, _frame, terrain, _projector.MinDepressionRadians, out ground);
        if (ray.TryIntersectLevel(_geometry.GroundDownMetres, _projector.MinDepressionRadians, out ground))
            return GeolocationError.None;
        return ray.FromMetres.Down < _geometry.GroundDownMetres ? GeolocationError.NearHorizon : GeolocationError.CameraBelowGround;
    }

    /// <summary>Where a pixel's ray intersects the ground, metres from the vehicle; false near the horizon, above it, or below ground.</summary>
    public bool TryProjectToGround(double column, double row, out NedVector ground) => Locate(column, row, out ground) == GeolocationError.None;

    /// <summary>As the other, as a position on the earth.</summary>
    public bool TryProjectToGround(double column, double row, out GeodeticPosition place)
    {
        bool isGround = TryProjectToGround(column, row, out NedVector ground);
        place = isGround ? _frame.ToGeodetic(ground) : default;
        return isGround;
    }

    /// <summary>How far a pixel reaches on the ground.</summary>
    public bool TryScale(double column, double row, out GroundScale scale)
    {
        scale = default;
        if (!TryProjectToGround(column - 0.5, row, out NedVector left) || !TryProjectToGround(column + 0.5, row, out NedVector right)
            || !TryProjectToGround(column, row - 0.5, out NedVector above) || !TryProjectToGround(column, row + 0.5, out NedVector below))
            return false;
        scale.NorthByColumn = right.North - left.North;
        scale.EastByColumn = right.East - left.East;
        scale.NorthByRow = below.North - above.North;
        scale.EastByRow = below.East - above.East;
        return true;
    }

    /// <summary>The covariance of a pixel's place: of random errors, new in each observation, and of systematic ones, the same in all.</summary>
    public bool TryCovariances(double column, double row, out HorizontalCovariance random, out HorizontalCovariance systematic)
    {
        (random, systematic) = (default, default);
        ViewingGeometry geometry = _geometry;
        if (_projector.Terrain is { } terrain)
        {
            // As if the ground were the plane that touches it there.
            if (!TryProjectToGround(column, row, out NedVector ground))
                return false;
            TerrainRay.Slope(_frame, terrain, ground, out double downByNorth, out double downByEast);
            (geometry.GroundPoint, geometry.GroundDownMetres) = (ground, ground.Down);
            (geometry.GroundDownByNorth, geometry.GroundDownByEast) = (downByNorth, downByEast);
        }

        if (!_projector.Jacobian.TryCompute(geometry, column, row))
            return false;
        random = _projector.Jacobian.Covariance(_projector.RandomErrors(_geometry.Pose.ExtrapolatedSeconds));
        systematic = _projector.Jacobian.Covariance(_projector.SystematicErrors());
        return true;
    }
}
