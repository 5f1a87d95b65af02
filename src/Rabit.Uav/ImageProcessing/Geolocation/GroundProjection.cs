using System;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// From the pixels of one picture to the ground, at one pose: made by <see cref="GroundProjector.At"/>, for the thread
/// of that projector. A value; pass it by reference, it is large.
/// </summary>
internal readonly struct GroundProjection
{
    // Far enough that the direction is not that of rounding errors, near enough that the ground is even.
    private const double HalfAxisPixels = 5;

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
            Gimbal = pose.Gimbal ?? command.Pointing(projector.Mount.GimbalFrame),
            GroundDownMetres = pose.Position.AltitudeAmslMetres - command.GroundAltitudeAmslMetres,
        };
    }

    /// <summary>Where the camera itself is, and how it is turned: north-east-down from camera.</summary>
    public (GeodeticPosition Position, Rotation NedFromCamera) CameraPose()
    {
        Rotation attitude = _geometry.Pose.Attitude;
        CameraExtrinsics placement = _projector.Mount.At(_geometry.Gimbal, attitude);
        return (
            ToGeodetic(NedPosition.Origin + attitude.ToNed(placement.PositionMetres)),
            attitude * placement.BodyFromCamera);
    }

    /// <summary>Where a pixel's ray intersects the ground, metres from the vehicle; or why it does not.</summary>
    public GeolocationError Locate(double column, double row, out NedPosition ground)
    {
        ground = default;
        if (!_projector.Camera.TryUndistort(column, row, out double x, out double y))
            return GeolocationError.LensCannotBeUndone;
        GroundRay ray = _geometry.RayOf(_projector.Mount, x, y);
        if (!ray.Direction.IsFinite || (_projector.Terrain is null && double.IsNaN(_geometry.GroundDownMetres)))
            return GeolocationError.NotANumber;
        if (_projector.Terrain is { } terrain)
            return TerrainRay.Intersect(ray, _frame, terrain, _projector.MinDepression, out ground);
        if (ray.TryIntersectLevel(_geometry.GroundDownMetres, _projector.MinDepression, out ground))
            return GeolocationError.None;
        return ray.Origin.Down < _geometry.GroundDownMetres
            ? GeolocationError.NearHorizon
            : GeolocationError.CameraBelowGround;
    }

    /// <summary>
    /// Where a pixel's ray intersects the ground, metres from the vehicle; false near the horizon, above it, or below
    /// ground.
    /// </summary>
    public bool TryProjectToGround(double column, double row, out NedPosition ground)
        => Locate(column, row, out ground) == GeolocationError.None;

    /// <summary>As the other, as a position on the earth.</summary>
    public bool TryProjectToGround(double column, double row, out GeodeticPosition place)
    {
        bool isGround = TryProjectToGround(column, row, out NedPosition ground);
        place = isGround ? ToGeodetic(ground) : default;
        return isGround;
    }

    /// <summary>The position on the earth of a place that <see cref="Locate"/> found.</summary>
    public GeodeticPosition ToGeodetic(NedPosition ground) => _frame.ToGeodetic(ground);

    /// <summary>How far a pixel reaches on the ground.</summary>
    public bool TryScale(double column, double row, out GroundScale scale)
    {
        scale = default;
        if (!TryProjectToGround(column - 0.5, row, out NedPosition left)
            || !TryProjectToGround(column + 0.5, row, out NedPosition right)
            || !TryProjectToGround(column, row - 0.5, out NedPosition above)
            || !TryProjectToGround(column, row + 0.5, out NedPosition below))
            return false;
        scale.NorthByColumn = right.North - left.North;
        scale.EastByColumn = right.East - left.East;
        scale.NorthByRow = below.North - above.North;
        scale.EastByRow = below.East - above.East;
        return true;
    }

    /// <summary>
    /// The covariance of a pixel's place: of random errors, new in each observation, and of systematic ones, the same
    /// in all.
    /// </summary>
    public bool TryCovariances(
        double column, double row, out HorizontalCovariance random, out HorizontalCovariance systematic)
    {
        NedPosition ground = default;
        if (_projector.Terrain is null || TryProjectToGround(column, row, out ground))
            return TryCovariances(column, row, ground, out random, out systematic);
        (random, systematic) = (default, default);
        return false;
    }

    /// <summary>
    /// As the other, for a pixel that is known to show a place: over terrain that saves the search for it.
    /// </summary>
    public bool TryCovariances(
        double column, double row, NedPosition ground, out HorizontalCovariance random,
        out HorizontalCovariance systematic)
    {
        (random, systematic) = (default, default);
        if (!TryComputeJacobian(column, row, ground))
            return false;
        random = _projector.Jacobian.Covariance(_projector.RandomErrors(_geometry.Pose.ExtrapolatedSeconds));
        systematic = _projector.Jacobian.Covariance(_projector.SystematicErrors(_geometry.Pose.TimeErrorSeconds));
        return true;
    }

    /// <summary>The same for a place that a detector found, with its own statement of how uncertain that is.</summary>
    public bool TryCovariances(
        double column, double row, in PixelCovariance pixel, out HorizontalCovariance random,
        out HorizontalCovariance systematic)
    {
        (random, systematic) = (default, default);
        NedPosition ground = default;
        if (_projector.Terrain is not null && !TryProjectToGround(column, row, out ground))
            return false;
        if (!TryComputeJacobian(column, row, ground))
            return false;
        GroundJacobian jacobian = _projector.Jacobian;
        random = jacobian.Covariance(_projector.RandomErrors(_geometry.Pose.ExtrapolatedSeconds, pixel));
        if (pixel.ColumnRow != 0)
            random += jacobian.CovarianceOfPair(ViewingParameter.Column, ViewingParameter.Row, pixel.ColumnRow);
        systematic = jacobian.Covariance(_projector.SystematicErrors(_geometry.Pose.TimeErrorSeconds));
        return true;
    }

    /// <summary>Where a pixel's ray meets the level of an altitude; false where it does not.</summary>
    public bool TryProjectToLevel(double column, double row, double altitudeAmslMetres, out GeodeticPosition place)
    {
        place = default;
        double down = _geometry.Pose.Position.AltitudeAmslMetres - altitudeAmslMetres;
        if (!_projector.Camera.TryUndistort(column, row, out double x, out double y)
            || !_geometry.RayOf(_projector.Mount, x, y)
                .TryIntersectLevel(down, _projector.MinDepression, out NedPosition ground))
            return false;
        place = ToGeodetic(ground);
        return true;
    }

    /// <summary>How the place moves for errors that stay the same; of the pixel of the last covariances.</summary>
    /// <param name="byOffset">The same for errors of the time.</param>
    public TargetSensitivity CreateSensitivity(ImmutableArray<NedVector> byOffset) => new()
    {
        ByOffset = byOffset,
        ByRoll = _projector.Jacobian.By(ViewingParameter.Roll),
        ByPitch = _projector.Jacobian.By(ViewingParameter.Pitch),
        ByHeading = _projector.Jacobian.By(ViewingParameter.Yaw),
        ByGroundHeight = _projector.Jacobian.By(ViewingParameter.GroundHeight),
    };

    /// <summary>
    /// The bearing on the ground of what a detector saw with the ground scale of another pose, that of the middle row;
    /// null where the picture does not show it. The Jacobian is another one afterwards.
    /// </summary>
    /// <param name="column">Of its centre.</param>
    /// <param name="row">Of its centre.</param>
    /// <param name="seen">As the detector says.</param>
    /// <param name="seenBy">The ground scale that the detector had there.</param>
    public TargetBearing? BearingOf(double column, double row, in TargetBearing seen, in GroundScale seenBy)
    {
        double determinant = (seenBy.NorthByColumn * seenBy.EastByRow) - (seenBy.NorthByRow * seenBy.EastByColumn);
        (double north, double east) = (Trig.Cos(seen.Angle.Radians), Trig.Sin(seen.Angle.Radians));
        double dx = ((seenBy.EastByRow * north) - (seenBy.NorthByRow * east)) / determinant;
        double dy = ((seenBy.NorthByColumn * east) - (seenBy.EastByColumn * north)) / determinant;
        double length = Math.Sqrt((dx * dx) + (dy * dy)) / HalfAxisPixels;
        (double Column, double Row) from = (column - (dx / length), row - (dy / length));
        (double Column, double Row) to = (column + (dx / length), row + (dy / length));
        if (!TryProjectToGround(column, row, out NedPosition centre)
            || !TryProjectToGround(from.Column, from.Row, out NedPosition start)
            || !TryProjectToGround(to.Column, to.Row, out NedPosition end)
            || !_projector.BearingJacobian.TryCompute(GeometryAt(centre), from, to, end - start))
            return null;
        double random = _projector.BearingJacobian.Variance(
            _projector.RandomErrors(_geometry.Pose.ExtrapolatedSeconds));
        double systematic = _projector.BearingJacobian.Variance(
            _projector.SystematicErrors(_geometry.Pose.TimeErrorSeconds));
        return new TargetBearing(
            Angle.FromRadians(Math.Atan2(end.East - start.East, end.North - start.North)),
            Angle.FromRadians(Math.Sqrt((seen.Sigma.Radians * seen.Sigma.Radians) + random)), seen.Symmetry)
        {
            SystematicSigma = Angle.FromRadians(Math.Sqrt(systematic)),
        };
    }

    private bool TryComputeJacobian(double column, double row, NedPosition ground)
        => _projector.Jacobian.TryCompute(GeometryAt(ground), column, row);

    private ViewingGeometry GeometryAt(NedPosition ground)
    {
        ViewingGeometry geometry = _geometry;
        if (_projector.Terrain is { } terrain)
        {
            // As if the ground were the plane that touches it there.
            TerrainRay.Slope(_frame, terrain, ground, out double downByNorth, out double downByEast);
            (geometry.GroundPoint, geometry.GroundDownMetres) = (ground, ground.Down);
            (geometry.GroundDownByNorth, geometry.GroundDownByEast) = (downByNorth, downByEast);
        }

        return geometry;
    }
}
