using System;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How uncertain the centre of a patch is.</summary>
internal static class PatchCovariance
{
    // What no picture is without: the edge by the curve of the light, the steps of the levels, JPEG.
    private const double BaseSigma = 0.07;

    // A form that is not seen whole, windows: parts of the side; and shade over a part of it, by how uneven it is.
    private const double FormSigma = 0.012;
    private const double PartsSigma = 0.022;
    private const double CutSigma = 0.03;
    private const double ShadeGain = 0.3;
    private const double EvenUpTo = 0.15;

    // What is about twice as long as wide and of one colour ends in parts of another colour, as a person does in head
    // and boots: of its standard deviation along its length.
    private const double EndSigma = 0.22;
    private const double MaxPlainAspect = 1.8;
    private const double LongAspect = 2.3;

    // Ground that is not even counts as covered here and there, all around the edge.
    private const double NoiseGain = 1.35;

    public static PixelCovariance Of(in PatchShape shape, bool hasParts)
    {
        double side = Math.Sqrt(shape.Area);
        double form = side * (shape.TouchesBorder ? CutSigma : hasParts ? PartsSigma : FormSigma);
        double shade = ShadeGain * side * Math.Max(0, shape.Unevenness - EvenUpTo);
        double own = (BaseSigma * BaseSigma) + (form * form) + (shade * shade);
        double noise = NoiseGain * shape.GroundNoise * shape.GroundNoise / side;
        double mean = (shape.MomentXX + shape.MomentYY) / 2;
        double off = (shape.MomentXX - shape.MomentYY) / 2;
        double half = Math.Sqrt((off * off) + (shape.MomentXY * shape.MomentXY));
        double least = mean - half;
        double aspect = Math.Sqrt(Math.Max(0.2, mean + half - PatchCost.BlurVariance)
            / Math.Max(0.2, least - PatchCost.BlurVariance));
        double isLong = (aspect - MaxPlainAspect) / (LongAspect - MaxPlainAspect);
        double ends = hasParts ? 0 : EndSigma * EndSigma * Math.Min(1, Math.Max(0, isLong));
        return new PixelCovariance(
            own + (noise * shape.MomentXX) + (ends * (shape.MomentXX - least)),
            (noise + ends) * shape.MomentXY,
            own + (noise * shape.MomentYY) + (ends * (shape.MomentYY - least)));
    }
}
