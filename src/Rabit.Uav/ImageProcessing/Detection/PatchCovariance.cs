using System;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How uncertain the centre of a patch is.</summary>
internal static class PatchCovariance
{
    // What no picture is without: the edge by the curve of the light, the steps of the levels, JPEG.
    private const double BaseSigma = 0.08;

    // A form that is not seen whole, shade over a part of it, windows: parts of the side.
    private const double FormSigma = 0.012;
    private const double PartsSigma = 0.025;
    private const double CutSigma = 0.03;

    // Ground that is not even counts as covered here and there, all around the edge.
    private const double NoiseGain = 1.5;

    public static PixelCovariance Of(in PatchCandidate candidate, bool hasParts)
    {
        ref readonly PatchShape shape = ref candidate.Shape;
        double side = Math.Sqrt(shape.Area);
        double form = side * (shape.TouchesBorder ? CutSigma : hasParts ? PartsSigma : FormSigma);
        double own = (BaseSigma * BaseSigma) + (form * form);
        double noise = NoiseGain * shape.GroundNoise * shape.GroundNoise / side;
        return new PixelCovariance(
            own + (noise * shape.MomentXX), noise * shape.MomentXY, own + (noise * shape.MomentYY));
    }
}
