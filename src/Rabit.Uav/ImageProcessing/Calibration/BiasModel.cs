using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>Where a point on the ground is seen in a picture, for given biases, and how that changes with each. For one thread.</summary>
internal sealed class BiasModel(CameraModel camera, CameraMount mount)
{
    public const int Biases = (int)BiasParameter.Down + 1;

    // Biases, then north and east of the point.
    public const int Inputs = Biases + 2;

    private readonly double[] _values = new double[Inputs];

    /// <summary>The pixel of a point; false where it is not in front of the camera.</summary>
    /// <param name="look">The look; its position is not used but for <paramref name="vehicle"/>.</param>
    /// <param name="vehicle">Its position in the frame.</param>
    /// <param name="groundDown">Where the ground is in the frame.</param>
    /// <param name="values">Biases, then the point.</param>
    /// <param name="column">The pixel.</param>
    /// <param name="row">The pixel, too.</param>
    public bool TryProject(in BiasLook look, NedVector vehicle, double groundDown, double[] values, out double column, out double row)
    {
        // What was told is the truth and the bias; the truth is what is needed.
        double earlier = -values[(int)BiasParameter.Time];
        NedVector v = look.VelocityNed;
        var position = new NedVector(
            vehicle.North + (v.North * earlier) - values[(int)BiasParameter.North],
            vehicle.East + (v.East * earlier) - values[(int)BiasParameter.East],
            vehicle.Down + (v.Down * earlier) - values[(int)BiasParameter.Down]);
        Rotation attitude = Rotation.FromEuler(EulerAngles.FromRadians(
            look.Attitude.RollRadians - values[(int)BiasParameter.AttitudeRoll],
            look.Attitude.PitchRadians - values[(int)BiasParameter.AttitudePitch],
            look.Attitude.YawRadians - values[(int)BiasParameter.AttitudeYaw])).After(look.Rates, earlier);
        CameraExtrinsics placement = mount.At(look.GimbalPitchRadians, look.GimbalYawRadians, EulerAngles.FromRadians(
            values[(int)BiasParameter.MountRoll], values[(int)BiasParameter.MountPitch], values[(int)BiasParameter.MountYaw]));
        NedVector arm = attitude.ToNed(placement.PositionMetres);
        (double x, double y, double z) = (attitude * placement.BodyFromCamera).Inverse.Apply(
            values[Biases] - position.North - arm.North, values[Biases + 1] - position.East - arm.East, groundDown - position.Down - arm.Down);
        return camera.TryProject(x, y, z, out column, out row);
    }

    /// <summary>Derivatives of the pixel by everything, by central differences.</summary>
    public bool TryDerive(in BiasLook look, NedVector vehicle, double groundDown, double[] values, double[] byColumn, double[] byRow)
    {
        Array.Copy(values, _values, Inputs);
        for (int i = 0; i < Inputs; i++)
        {
            double step = i >= (int)BiasParameter.North ? 1e-3 : 1e-5;
            _values[i] = values[i] + step;
            bool isSeen = TryProject(look, vehicle, groundDown, _values, out double columnPlus, out double rowPlus);
            _values[i] = values[i] - step;
            isSeen &= TryProject(look, vehicle, groundDown, _values, out double columnMinus, out double rowMinus);
            _values[i] = values[i];
            if (!isSeen)
                return false;
            byColumn[i] = (columnPlus - columnMinus) / (2 * step);
            byRow[i] = (rowPlus - rowMinus) / (2 * step);
        }

        return true;
    }
}
