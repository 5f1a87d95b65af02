using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// How unlike a patch is to a target of a class: the sum of squared deviations in size, form, colour and outline, each
/// in its standard deviations, as far as it lies outside what the class may be.
/// </summary>
internal static class PatchCost
{
    /// <summary>
    /// Square pixels: the light of a pixel comes from its whole square, and lens and JPEG blur it by about 1 px in
    /// colour.
    /// </summary>
    public const double BlurVariance = (1.0 / 12) + 0.95;

    // What covers half a side of it at the border of the picture may go on beyond; at half of a target seen, its side
    // is smaller by 0.35 (natural logarithm), and rarely by more.
    private const double FullCut = 0.5;
    private const double CutSizeSigma = 0.2;
    private const double CutAspectSigma = 0.3;

    // Whatever is large, a roof or a pool, gives pieces of any size at the border.
    private const double CutPrior = 3;

    // Pixels across: of what is so thin, a JPEG that has colour in half of the rows and columns mixes in the ground
    // beside it all over its width; a pixel thinner, by how much its colour then counts less.
    private const double ThinSide = 3.75;
    private const double ThinGain = 0.35;
    private const double MaxAspectOfThin = 4;

    // Degrees of hue. In simulated flights 7 and more beside a jacket, and mostly below 6 beside a panel.
    private const double MinOther = 8.5;
    private const double MaxOther = 9;
    private const double OtherSigma = 2;

    // How much brightness and tint of what is white, grey or black count: a square of one colour may be a slab of
    // concrete, which they show; what has parts of other colours has a form that few such things have, unless the
    // border cuts it. No less than for a car, 0.65 of which is of its colour.
    private const double NeutralWeight = 3;
    private const double MinNeutralWeight = 1.95;

    // A filled rectangle of area A has sigma_long * sigma_short = A / 12.
    private const double RectangleFactor = 12;

    /// <summary>The cost, and how much of it is of the colour (0 for white and black).</summary>
    public static double Of(
        in PatchShape shape, in GroundScale scale, TargetClass target, in ColourLikeness colour, out double side,
        out double ofColour)
    {
        double root = Math.Sqrt(shape.Area);
        side = root * Math.Sqrt((1 - colour.Mixed) * scale.PixelArea);
        (double longSpread, double shortSpread) = SpreadMetres(shape, scale, BlurVariance);
        double aspect = longSpread / shortSpread;
        (double longWhole, double shortWhole) = SpreadMetres(shape, scale, 0);
        double fill = shape.Area * scale.PixelArea / (RectangleFactor * longWhole * shortWhole);
        double other = 1 - target.MinColourShare;
        double cut = Math.Min(1, shape.CutLength / (FullCut * root));
        double logSide = Math.Log(side);
        (double logMin, double logMax) = (Math.Log(target.MinSideMetres), Math.Log(target.MaxSideMetres));
        double sizeSigma = colour.IsNeutral ? 0.03 + (0.1 / root) : 0.06 + (0.5 / root);
        double cost = Square(Outside(logSide, logMin, logMax))
            / (Square(sizeSigma) + (logSide < logMin ? Square(CutSizeSigma * cut) : 0));
        double rest = Math.Min(1, Math.Max(0.1, (logMax - logSide) / (logMax - logMin)));
        cost += cut * (CutPrior - (2 * Math.Log(rest)));
        cost += Square(Outside(Math.Log(aspect), Math.Log(target.MinAspect), Math.Log(target.MaxAspect)))
            / (Square(0.06 + (0.8 / root)) + Square(CutAspectSigma * cut));
        cost += Square((logSide - ((logMin + logMax) / 2)) / (logMax - logMin));
        cost += Square(Math.Log(aspect / Math.Sqrt(target.MinAspect * target.MaxAspect))
            / Math.Log(target.MaxAspect / target.MinAspect));
        (double minFill, double maxOutline) = FillAndOutlineOf(target.Shape);
        cost += Square(Outside(fill, minFill - (0.4 * other), 1.08) / 0.1);
        cost += Square(Math.Max(0, shape.Outline - maxOutline - (3 * other)) / 0.15);
        cost += Square(shape.Continuation / 0.1);
        cost += Square(Math.Max(0, shape.Unevenness - 0.15 - (0.2 * other)) / 0.08);
        double noise = colour.IsNeutral ? 0.15 / colour.PartOfWhite : 0.1;
        cost += Square(Math.Max(0, shape.GroundNoise - noise) / 0.08);
        cost += colour.Darkness;
        ofColour = 0;
        if (colour.IsNeutral)
        {
            cost += 3 + (NeutralWeightOf(target, cut) * colour.Cost);
            cost += Square(Math.Max(0, 8 - root) / 0.65);
            cost += Square(Math.Max(0, shape.Unevenness - ((0.02 + (0.3 / root)) / colour.PartOfWhite)) / 0.015);
            cost += Square(Math.Max(0, 130 - shape.Contrast) / 30);
            return cost;
        }

        ofColour = colour.Cost * ColourWeight(root, aspect);
        cost += ofColour;
        cost += Square(Math.Max(0, 75 + (20 * Large(root)) - shape.Contrast) / 17);
        return cost;
    }

    /// <summary>
    /// How unlike the surroundings are to those of a target of a class: what shows its colour by less than half has
    /// its other parts beside that, and what has one colour alone has the ground there.
    /// </summary>
    public static double OfSurroundings(in PatchShape shape, TargetClass target)
        => target.IsMostlyOfOtherColours ? Square(Math.Max(0, MinOther - shape.OtherBeside) / OtherSigma)
            : target.MinColourShare == 1 ? Square(Math.Max(0, shape.OtherBeside - MaxOther) / OtherSigma)
            : 0;

    // Of its spread a cross and a triangle fill less than a rectangle, and a cross that stands on two arms has dents.
    private static (double MinFill, double MaxOutline) FillAndOutlineOf(TargetShape shape) => shape switch
    {
        TargetShape.Cross => (0.55, 1.7),
        TargetShape.Triangle => (0.75, 1.3),
        _ => (0.84, 1.3),
    };

    private static double NeutralWeightOf(TargetClass target, double cut)
    {
        double ofForm = Math.Max(MinNeutralWeight, NeutralWeight * target.MinColourShare);
        return ofForm + (cut * (NeutralWeight - ofForm));
    }

    private static double ColourWeight(double root, double aspect)
    {
        double across = root / Math.Sqrt(Math.Min(MaxAspectOfThin, aspect));
        return (2.5 + (3 * Large(root))) * (1 - (ThinGain * Math.Min(1, Math.Max(0, ThinSide - across))));
    }

    private static double Large(double side) => Math.Min(1, Math.Max(0, (side - 4.5) / 2));

    /// <summary>Standard deviations on the ground along its long and its short axis, metres.</summary>
    public static (double Long, double Short) SpreadMetres(in PatchShape shape, in GroundScale scale, double blur)
    {
        double xx = Math.Max(0.2, shape.MomentXX - blur);
        double yy = Math.Max(0.2, shape.MomentYY - blur);
        double nn = Project(
            scale.NorthByColumn, scale.NorthByRow, scale.NorthByColumn, scale.NorthByRow, xx, shape.MomentXY, yy);
        double ne = Project(
            scale.NorthByColumn, scale.NorthByRow, scale.EastByColumn, scale.EastByRow, xx, shape.MomentXY, yy);
        double ee = Project(
            scale.EastByColumn, scale.EastByRow, scale.EastByColumn, scale.EastByRow, xx, shape.MomentXY, yy);
        double mean = (nn + ee) / 2;
        double half = Math.Sqrt((((nn - ee) / 2) * ((nn - ee) / 2)) + (ne * ne));
        return (Math.Sqrt(mean + half), Math.Sqrt(Math.Max(0.2 * scale.PixelArea, mean - half)));
    }

    private static double Project(
        double aByColumn, double aByRow, double bByColumn, double bByRow, double xx, double xy, double yy)
        => (aByColumn * bByColumn * xx) + (((aByColumn * bByRow) + (aByRow * bByColumn)) * xy) + (aByRow * bByRow * yy);

    private static double Outside(double value, double min, double max)
        => value < min ? min - value : value > max ? value - max : 0;

    private static double Square(double value) => value * value;
}
