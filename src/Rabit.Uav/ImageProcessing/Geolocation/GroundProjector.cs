using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// Tells where on the ground a pixel is, for one picture at a time: pose at mid-exposure, mount, gimbal, lens, and ground that is flat
/// and level, or a grid of heights. Fixed memory; for one thread.
/// </summary>
internal sealed class GroundProjector
{
    private readonly CameraModel _camera;
    private readonly CameraMount _mount;
    private readonly double _minimumDepressionRadians;
    private readonly GroundJacobian _jacobian;
    private readonly double[] _perLook;
    private readonly double[] _common;
    private readonly double[] _perLookNow = new double[GroundJacobian.Inputs];
    private readonly ErrorBudget _budget;
    private readonly TerrainGrid? _terrain;
    private ViewingGeometry _sighting;
    private LocalNedFrame _frame;

    public GroundProjector(CameraModel camera, CameraMount mount, ErrorBudget budget, double minimumDepressionRadians, TerrainGrid? terrain = null)
    {
        _camera = camera;
        _mount = mount;
        _minimumDepressionRadians = minimumDepressionRadians;
        _jacobian = new GroundJacobian(camera, mount);
        _budget = budget;
        _terrain = terrain;
        _perLook = PerLook(budget);
        _common = Common(budget);
    }

    /// <summary>Turns to a picture.</summary>
    public void Aim(in Pose pose, in ImagingCommand order)
    {
        _frame = LocalNedFrame.IgnoringGeoid(pose.Position);
        _sighting.Pose = pose;
        _sighting.GimbalPitchRadians = order.CameraPitchRadians;
        _sighting.GimbalYawRadians = order.CameraYawRadians;
        _sighting.GroundDownMetres = pose.Position.AltitudeAmslMetres - order.GroundAltitudeAmslMetres;
    }

    /// <summary>Where a pixel meets the ground, metres from the vehicle; or why it does not.</summary>
    public GeolocationError Locate(double column, double row, out NedVector ground)
    {
        ground = default;
        if (!_camera.TryUndistort(column, row, out double x, out double y))
            return GeolocationError.LensCannotBeUndone;
        GroundRay ray = _sighting.RayOf(_mount, x, y);
        if (_terrain is not null)
            return TerrainRay.Meet(ray, _frame, _terrain, _minimumDepressionRadians, out ground);
        if (ray.TryIntersectLevel(_sighting.GroundDownMetres, _minimumDepressionRadians, out ground))
            return GeolocationError.None;
        return ray.FromMetres.Down < _sighting.GroundDownMetres ? GeolocationError.NearHorizon : GeolocationError.CameraBelowGround;
    }

    /// <summary>Where a pixel meets the ground, metres from the vehicle; false near the horizon, above it, or below ground.</summary>
    public bool TryProjectToGround(double column, double row, out NedVector ground) => Locate(column, row, out ground) == GeolocationError.None;

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

    /// <summary>How uncertain the place of a pixel is: what is new in each look, and what is the same in all.</summary>
    public bool TryCovariances(double column, double row, out HorizontalCovariance perLook, out HorizontalCovariance common)
    {
        (perLook, common) = (default, default);
        ViewingGeometry sighting = _sighting;
        if (_terrain is not null)
        {
            // As if the ground were the plane that touches it there.
            if (!TryProjectToGround(column, row, out NedVector ground))
                return false;
            TerrainRay.Slope(_frame, _terrain, ground, out double downByNorth, out double downByEast);
            (sighting.GroundPoint, sighting.GroundDownMetres) = (ground, ground.Down);
            (sighting.GroundDownByNorth, sighting.GroundDownByEast) = (downByNorth, downByEast);
        }

        if (!_jacobian.TryCompute(sighting, column, row))
            return false;
        perLook = _jacobian.Covariance(PerLookNow());
        common = _jacobian.Covariance(_common);
        return true;
    }

    // A pose that was drawn on is wrong by what the vehicle may have done since.
    private double[] PerLookNow()
    {
        double t = _sighting.Pose.ExtrapolatedSeconds;
        if (t <= 0)
            return _perLook;
        Array.Copy(_perLook, _perLookNow, _perLook.Length);
        for (ViewingParameter input = ViewingParameter.North; input <= ViewingParameter.Yaw; input++)
        {
            double rate = input <= ViewingParameter.Down ? _budget.AccelerationMetresPerSecondSquared : _budget.AngularAccelerationRadiansPerSecondSquared;
            double drift = 0.5 * rate * t * t;
            _perLookNow[(int)input] = Math.Sqrt((_perLook[(int)input] * _perLook[(int)input]) + (drift * drift));
        }

        return _perLookNow;
    }

    private static double[] PerLook(ErrorBudget budget)
    {
        var sigmas = new double[GroundJacobian.Inputs];
        sigmas[(int)ViewingParameter.North] = sigmas[(int)ViewingParameter.East] = budget.PositionNoiseMetres;
        sigmas[(int)ViewingParameter.Down] = budget.AltitudeNoiseMetres;
        sigmas[(int)ViewingParameter.Roll] = sigmas[(int)ViewingParameter.Pitch] = budget.AttitudeNoiseRadians;
        sigmas[(int)ViewingParameter.Yaw] = budget.HeadingNoiseRadians;
        sigmas[(int)ViewingParameter.Column] = sigmas[(int)ViewingParameter.Row] = budget.PixelNoise;
        sigmas[(int)ViewingParameter.Time] = budget.TimeNoise.TotalSeconds;
        return sigmas;
    }

    private static double[] Common(ErrorBudget budget)
    {
        var sigmas = new double[GroundJacobian.Inputs];
        sigmas[(int)ViewingParameter.North] = sigmas[(int)ViewingParameter.East] = budget.PositionBiasMetres;
        sigmas[(int)ViewingParameter.GroundHeight] = budget.AltitudeBiasMetres;
        sigmas[(int)ViewingParameter.Roll] = sigmas[(int)ViewingParameter.Pitch] = budget.AttitudeBiasRadians;
        sigmas[(int)ViewingParameter.Yaw] = budget.HeadingBiasRadians;
        sigmas[(int)ViewingParameter.MountRoll] = sigmas[(int)ViewingParameter.MountPitch] = sigmas[(int)ViewingParameter.MountYaw] = budget.MountBiasRadians;
        return sigmas;
    }
}
