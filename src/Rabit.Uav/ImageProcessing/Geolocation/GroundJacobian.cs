using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// How far a position on the ground moves for a small error of each thing that it is reckoned from, by central differences. Fixed memory;
/// for one thread.
/// </summary>
internal sealed class GroundJacobian(CameraModel camera, CameraMount mount)
{
    /// <summary>How many things there are.</summary>
    public const int Inputs = (int)SightingInput.Time + 1;

    private readonly double[] _north = new double[Inputs];
    private readonly double[] _east = new double[Inputs];
    private readonly double[] _errors = new double[Inputs];

    /// <summary>Reckons all derivatives for one pixel; false where one cannot be reckoned because a line of sight misses the ground.</summary>
    public bool TryCompute(in Sighting sighting, double column, double row)
    {
        if (!camera.TryUndistort(column, row, out double x, out double y))
            return false;
        EulerAngles attitude = sighting.Pose.Attitude.ToEuler();
        for (int input = 0; input < Inputs; input++)
        {
            double step = StepOf((SightingInput)input);
            (double columnStep, double rowStep) = (
                input == (int)SightingInput.Column ? step : 0, input == (int)SightingInput.Row ? step : 0);
            (double plusX, double plusY, double minusX, double minusY) = (x, y, x, y);
            if ((columnStep > 0 || rowStep > 0)
                && !(camera.TryUndistort(column + columnStep, row + rowStep, out plusX, out plusY)
                && camera.TryUndistort(column - columnStep, row - rowStep, out minusX, out minusY)))
                return false;
            _errors[input] = step;
            bool meets = TryMeetWithErrors(sighting, attitude, plusX, plusY, out NedVector plus);
            _errors[input] = -step;
            meets &= TryMeetWithErrors(sighting, attitude, minusX, minusY, out NedVector minus);
            _errors[input] = 0;
            if (!meets)
                return false;
            _north[input] = (plus.North - minus.North) / (2 * step);
            _east[input] = (plus.East - minus.East) / (2 * step);
        }

        return true;
    }

    /// <summary>The covariance of the position for independent errors of the given standard deviations, in the order of <see cref="SightingInput"/>.</summary>
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

    private static double StepOf(SightingInput input) => input switch
    {
        SightingInput.Column or SightingInput.Row => 1e-2,
        SightingInput.North or SightingInput.East or SightingInput.Down or SightingInput.GroundHeight => 1e-2,
        SightingInput.Time => 1e-3,
        _ => 1e-5,
    };

    private bool TryMeetWithErrors(in Sighting sighting, EulerAngles attitude, double x, double y, out NedVector point)
    {
        double later = Error(SightingInput.Time);
        NedVector velocity = sighting.Pose.VelocityNed;
        var vehicle = new NedVector(
            Error(SightingInput.North) + (velocity.North * later),
            Error(SightingInput.East) + (velocity.East * later),
            Error(SightingInput.Down) + (velocity.Down * later));
        Rotation turned = Rotation.FromEuler(EulerAngles.FromRadians(
            attitude.RollRadians + Error(SightingInput.Roll),
            attitude.PitchRadians + Error(SightingInput.Pitch),
            attitude.YawRadians + Error(SightingInput.Yaw))).After(sighting.Pose.Rates, later);
        CameraPlacement placement = mount.At(
            sighting.GimbalPitchRadians + Error(SightingInput.GimbalPitch),
            sighting.GimbalYawRadians + Error(SightingInput.GimbalYaw),
            EulerAngles.FromRadians(Error(SightingInput.MountRoll), Error(SightingInput.MountPitch), Error(SightingInput.MountYaw)));
        double down = sighting.GroundDownMetres - Error(SightingInput.GroundHeight);
        return Sighting.Ray(turned, placement, vehicle, x, y).TryMeetPlane(
            new NedVector(sighting.GroundPoint.North, sighting.GroundPoint.East, down), sighting.GroundDownByNorth, sighting.GroundDownByEast, out point);
    }

    private double Error(SightingInput input) => _errors[(int)input];
}
