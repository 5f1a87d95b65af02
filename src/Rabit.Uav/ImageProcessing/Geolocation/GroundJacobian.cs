using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// The Jacobian of geolocation: how far a position on the ground moves for a small error of each thing that it is
/// computed from, by central differences; the covariance follows from it. Fixed memory; for one thread.
/// </summary>
internal sealed class GroundJacobian(CameraModel camera, CameraMount mount)
{
    /// <summary>How many things there are.</summary>
    public const int Inputs = (int)ViewingParameter.FocalLength + 1;

    private readonly double[] _north = new double[Inputs];
    private readonly double[] _east = new double[Inputs];
    private readonly double[] _errors = new double[Inputs];

    /// <summary>
    /// Computes all derivatives for one pixel; false where one cannot be computed because a ray misses the ground.
    /// </summary>
    public bool TryCompute(in ViewingGeometry geometry, double column, double row)
    {
        if (!camera.TryUndistort(column, row, out double x, out double y))
            return false;
        EulerAngles attitude = geometry.Pose.Attitude.ToEuler();
        for (int input = 0; input < Inputs; input++)
        {
            double step = StepOf((ViewingParameter)input);
            (double columnStep, double rowStep) = (
                input == (int)ViewingParameter.Column ? step : 0, input == (int)ViewingParameter.Row ? step : 0);
            (double plusX, double plusY, double minusX, double minusY) = (x, y, x, y);
            if ((columnStep > 0 || rowStep > 0)
                && !(camera.TryUndistort(column + columnStep, row + rowStep, out plusX, out plusY)
                && camera.TryUndistort(column - columnStep, row - rowStep, out minusX, out minusY)))
                return false;
            _errors[input] = step;
            bool isGround = TryIntersectWithErrors(geometry, attitude, plusX, plusY, out NedPosition plus);
            _errors[input] = -step;
            isGround &= TryIntersectWithErrors(geometry, attitude, minusX, minusY, out NedPosition minus);
            _errors[input] = 0;
            if (!isGround)
                return false;
            _north[input] = (plus.North - minus.North) / (2 * step);
            _east[input] = (plus.East - minus.East) / (2 * step);
        }

        return true;
    }

    /// <summary>
    /// The covariance of the position for independent errors of the given standard deviations, in the order of
    /// <see cref="ViewingParameter"/>.
    /// </summary>
    public HorizontalCovariance Covariance(double[] sigmas)
    {
        (double nn, double ne, double ee) = (0, 0, 0);
        for (int input = 0; input < Inputs; input++)
        {
            double variance = sigmas[input] * sigmas[input];
            nn += variance * _north[input] * _north[input];
            ne += variance * _north[input] * _east[input];
            ee += variance * _east[input] * _east[input];
        }

        return new HorizontalCovariance(nn, ne, ee);
    }

    /// <summary>How the position moves for an error of one thing, metres; down is 0.</summary>
    public NedVector By(ViewingParameter input) => new(_north[(int)input], _east[(int)input], 0);

    /// <summary>What two errors that are not independent add to that.</summary>
    public HorizontalCovariance CovarianceOfPair(ViewingParameter a, ViewingParameter b, double covariance)
    {
        (double an, double ae, double bn, double be) = (_north[(int)a], _east[(int)a], _north[(int)b], _east[(int)b]);
        return new HorizontalCovariance(
            2 * covariance * an * bn, covariance * ((an * be) + (bn * ae)), 2 * covariance * ae * be);
    }

    private static double StepOf(ViewingParameter input) => input switch
    {
        ViewingParameter.Column or ViewingParameter.Row => 1e-2,
        ViewingParameter.North or ViewingParameter.East or ViewingParameter.Down or ViewingParameter.GroundHeight =>
            1e-2,
        ViewingParameter.Time => 1e-3,
        _ => 1e-5,
    };

    private bool TryIntersectWithErrors(
        in ViewingGeometry geometry, EulerAngles attitude, double x, double y, out NedPosition point)
    {
        double later = Error(ViewingParameter.Time);
        NedPosition vehicle = new NedPosition(
            Error(ViewingParameter.North), Error(ViewingParameter.East), Error(ViewingParameter.Down))
            + (later * geometry.Pose.VelocityNed);
        Rotation rotation = Rotation.FromEuler(EulerAngles.FromRadians(
            attitude.Roll.Radians + Error(ViewingParameter.Roll),
            attitude.Pitch.Radians + Error(ViewingParameter.Pitch),
            attitude.Yaw.Radians + Error(ViewingParameter.Yaw))).After(geometry.Pose.Rates, later);
        EulerAngles gimbal = geometry.Gimbal.Angles;
        CameraExtrinsics placement = mount.At(
            geometry.Gimbal with
            {
                Angles = new EulerAngles(
                    gimbal.Roll, gimbal.Pitch + Angle.FromRadians(Error(ViewingParameter.GimbalPitch)),
                    gimbal.Yaw + Angle.FromRadians(Error(ViewingParameter.GimbalYaw))),
            },
            rotation,
            EulerAngles.FromRadians(
                Error(ViewingParameter.MountRoll), Error(ViewingParameter.MountPitch),
                Error(ViewingParameter.MountYaw)));
        double down = geometry.GroundDownMetres - Error(ViewingParameter.GroundHeight);
        double spread = 1 / (1 + Error(ViewingParameter.FocalLength));
        return ViewingGeometry.Ray(rotation, placement, vehicle, spread * x, spread * y).TryIntersectPlane(
            geometry.GroundPoint with { Down = down }, geometry.GroundDownByNorth, geometry.GroundDownByEast,
            out point);
    }

    private double Error(ViewingParameter input) => _errors[(int)input];
}
