using System;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How uncertain the centre of a patch is: by what is known of its ground, contrast and form.</summary>
internal static class PatchCovariance
{
    // Square pixels, what no picture is without: the samples of the edge, the curve of the light, the steps of the
    // levels.
    private const double BaseVariance = 0.86e-3;

    // Ground whose texture is as coarse as the patch is wide counts as covered on one side and not on the other: the
    // more so the less the patch stands out, and whatever its size.
    private const double GroundGain = 1.38;

    // Levels: a JPEG has colour in half of the rows and columns and in coarse steps. It shifts an edge that only colour
    // shows, and the more the less that is.
    private const double ColourLevels = 3.2;

    // What is seen through or darker within the outline, as the windows and the sides of a car: in parts of its extent,
    // of its standard deviation; and where its edge is such.
    private const double PartsSigma = 0.066;
    private const double PartsEdgeVariance = 0.019;

    // Ground that differs much from side to side is what hides a part of the target: how far its edge goes beneath the
    // blur is not known.
    private const double HiddenGain = 0.6;
    private const double AlikeUpTo = 0.05;

    // Square pixels, where the border cuts it along as much as its side; and shade over a part of it, in parts of the
    // side, by how uneven it is.
    private const double CutVariance = 2.4e-3;
    private const double MaxCut = 2;
    private const double ShadeGain = 0.3;
    private const double EvenUpTo = 0.15;

    // What is about twice as long as wide and of one colour ends in parts of another colour, as a person does in head
    // and boots: of its standard deviation along its length.
    private const double EndSigma = 0.157;
    private const double MaxPlainAspect = 1.8;
    private const double LongAspect = 2.3;

    public static PixelCovariance Of(in PatchShape shape, bool hasParts)
    {
        double side = Math.Sqrt(shape.Area);
        double cut = Math.Min(MaxCut, shape.CutLength / side);
        double hidden = Math.Max(0, shape.GroundDifference - AlikeUpTo);
        double shade = ShadeGain * side * Math.Max(0, shape.Unevenness - EvenUpTo);
        double colour = ColourLevels / shape.Contrast;
        double own = BaseVariance + (GroundGain * shape.GroundNoise * shape.GroundNoise)
            + (HiddenGain * hidden * hidden) + (colour * colour * ColourShare(shape)) + (CutVariance * cut * cut)
            + (shade * shade);
        if (!hasParts)
            return WithEnds(shape, own);
        own += PartsEdgeVariance;
        double parts = PartsSigma * PartsSigma;
        return new PixelCovariance(
            own + (parts * shape.MomentXX), parts * shape.MomentXY, own + (parts * shape.MomentYY));
    }

    private static PixelCovariance WithEnds(in PatchShape shape, double own)
    {
        double mean = (shape.MomentXX + shape.MomentYY) / 2;
        double off = (shape.MomentXX - shape.MomentYY) / 2;
        double half = Math.Sqrt((off * off) + (shape.MomentXY * shape.MomentXY));
        double least = mean - half;
        double aspect = Math.Sqrt(Math.Max(0.2, mean + half - PatchCost.BlurVariance)
            / Math.Max(0.2, least - PatchCost.BlurVariance));
        double isLong = (aspect - MaxPlainAspect) / (LongAspect - MaxPlainAspect);
        double ends = EndSigma * EndSigma * Math.Min(1, Math.Max(0, isLong));
        return new PixelCovariance(
            own + (ends * (shape.MomentXX - least)), ends * shape.MomentXY, own + (ends * (shape.MomentYY - least)));
    }

    // Of the squared contrast, what is in blue and red against brightness, as a JPEG divides them (ITU-R BT.601).
    private static double ColourShare(in PatchShape shape)
    {
        (double red, double green, double blue) =
            (shape.Red - shape.GroundRed, shape.Green - shape.GroundGreen, shape.Blue - shape.GroundBlue);
        double luma = (0.299 * red) + (0.587 * green) + (0.114 * blue);
        (double cb, double cr) = (0.564 * (blue - luma), 0.713 * (red - luma));
        double colour = (cb * cb) + (cr * cr);
        return colour / Math.Max(1, colour + (luma * luma));
    }
}
