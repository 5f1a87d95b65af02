using System;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How uncertain the centre of a patch is.</summary>
internal static class PatchCovariance
{
    // What no picture is without: the edge by the curve of the light, the steps of the levels, JPEG.
    private const double BaseSigma = 0.07;

    // A form that is not seen whole, shade over a part of it, windows: parts of the side.
    private const double FormSigma = 0.012;
    private const double PartsSigma = 0.022;
    private const double CutSigma = 0.03;

    // What is more than twice as long as wide ends in parts of another colour, as a person does in head and boots: of
    // its standard deviation along its length.
    private const double EndSigma = 0.11;
    private const double MaxPlainAspect = 2;

    // Ground that is not even counts as covered here and there, all around the edge.
    private const double NoiseGain = 1.35;

    public static PixelCovariance Of(in PatchShape shape, bool hasParts)
    {
        double side = Math.Sqrt(shape.Area);
        double form = side * (shape.TouchesBorder ? CutSigma : hasParts ? PartsSigma : FormSigma);
        double own = (BaseSigma * BaseSigma) + (form * form);
        double noise = NoiseGain * shape.GroundNoise * shape.GroundNoise / side;
        double mean = (shape.MomentXX + shape.MomentYY) / 2;
        double off = (shape.MomentXX - shape.MomentYY) / 2;
        double half = Math.Sqrt((off * off) + (shape.MomentXY * shape.MomentXY));
        double least = mean - half;
        double aspect = Math.Sqrt(Math.Max(0.2, mean + half - PatchCost.BlurVariance)
            / Math.Max(0.2, least - PatchCost.BlurVariance));
        double ends = EndSigma * EndSigma * Math.Min(1, Math.Max(0, aspect - MaxPlainAspect));
        return new PixelCovariance(
            own + (noise * shape.MomentXX) + (ends * (shape.MomentXX - least)),
            (noise + ends) * shape.MomentXY,
            own + (noise * shape.MomentYY) + (ends * (shape.MomentYY - least)));
    }
}
