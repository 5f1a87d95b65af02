using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Computes the ground scale of the picture that is being searched.</summary>
internal interface IGroundScaleSource
{
    bool TryScale(double column, double row, out GroundScale scale);
}
