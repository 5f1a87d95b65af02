using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>
/// Where a point on the ground is seen in a picture, for given biases, and how that changes with each. For one thread.
/// </summary>
internal sealed class BiasModel(CameraModel camera, CameraMount mount)
{
    public const int Biases = (int)BiasParameter.Down + 1;

    // Biases, then north and east of the point.
    public const int Inputs = Biases + 2;

    private readonly double[] _values = new double[Inputs];

    /// <summary>The pixel of a point; false where it is not in front of the camera.</summary>
    /// <param name="observation">The observation; its position is not used but for <paramref name="vehicle"/>.</param>
    /// <param name="vehicle">Its position in the frame.</param>
    /// <param name="groundDown">Where the ground is in the frame.</param>
    /// <param name="values">Biases, then the point.</param>
    /// <param name="column">The pixel.</param>
    /// <param name="row">The pixel, too.</param>
    public bool TryProject(
        in BiasObservation observation, NedPosition vehicle, double groundDown, double[] values, out double column,
        out double row)
    {
        // What was reported is the truth and the bias; the truth is what is needed.
        double earlier = -values[(int)BiasParameter.Time];
        NedPosition position = vehicle + (earlier * observation.VelocityNed)
            - new NedVector(
                values[(int)BiasParameter.North], values[(int)BiasParameter.East], values[(int)BiasParameter.Down]);
        Rotation attitude = Rotation.FromEuler(EulerAngles.FromRadians(
            observation.Attitude.Roll.Radians - values[(int)BiasParameter.AttitudeRoll],
            observation.Attitude.Pitch.Radians - values[(int)BiasParameter.AttitudePitch],
            observation.Attitude.Yaw.Radians - values[(int)BiasParameter.AttitudeYaw]))
                .After(observation.Rates, earlier);
        var gimbal = new GimbalAttitude(
            new EulerAngles(Angle.Zero, observation.GimbalPitch, observation.GimbalYaw), mount.GimbalFrame);
        CameraExtrinsics placement = mount.At(gimbal, attitude, EulerAngles.FromRadians(
            values[(int)BiasParameter.MountRoll], values[(int)BiasParameter.MountPitch],
            values[(int)BiasParameter.MountYaw]));
        NedVector fromCamera = new NedPosition(values[Biases], values[Biases + 1], groundDown) - position
            - attitude.ToNed(placement.PositionMetres);
        (double x, double y, double z) = (attitude * placement.BodyFromCamera).Inverse.Apply(
            fromCamera.North, fromCamera.East, fromCamera.Down);
        return camera.TryProject(x, y, z, out column, out row);
    }

    /// <summary>Derivatives of the pixel by everything, by central differences.</summary>
    public bool TryDerive(
        in BiasObservation observation, NedPosition vehicle, double groundDown, double[] values, double[] byColumn,
        double[] byRow)
    {
        Array.Copy(values, _values, Inputs);
        for (int i = 0; i < Inputs; i++)
        {
            double step = i >= (int)BiasParameter.North ? 1e-3 : 1e-5;
            _values[i] = values[i] + step;
            bool isSeen = TryProject(
                observation, vehicle, groundDown, _values, out double columnPlus, out double rowPlus);
            _values[i] = values[i] - step;
            isSeen &= TryProject(
                observation, vehicle, groundDown, _values, out double columnMinus, out double rowMinus);
            _values[i] = values[i];
            if (!isSeen)
                return false;
            byColumn[i] = (columnPlus - columnMinus) / (2 * step);
            byRow[i] = (rowPlus - rowMinus) / (2 * step);
        }

        return true;
    }
}
