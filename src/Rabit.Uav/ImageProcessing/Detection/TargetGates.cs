using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// What a blob must be like on the ground, in metres, to be a target, and how like it is. Targets are squares.
/// </summary>
internal sealed class TargetGates(ColourDetectorOptions options)
{
    // A solid rectangle of area A has sigma_long * sigma_short = A / 12, however it lies; what has holes or arms has
    // more.
    private const double RectangleFactor = 12;
    private const double MinFill = 0.7;
    private const double MaxFill = 1.3;

    // How far from the best value a good target may be: one standard deviation.
    private const double FillSpread = 0.2;
    private const double AspectSpread = 0.4;

    /// <summary>The score of a blob, 0 to 1; 0 where it is no target of the class.</summary>
    public double Score(in BlobShape shape, in GroundScale scale, TargetClass target)
    {
        (double min, double max) = (target.MinSideMetres, target.MaxSideMetres);
        double side = BlobOnGround.SideMetres(shape, scale);
        if (!(side >= min && side <= max) || Math.Sqrt(shape.Area) < options.MinSidePixels)
            return 0;
        (double longSpread, double shortSpread) = BlobOnGround.SpreadMetres(shape, scale);
        double aspect = longSpread / shortSpread;
        double fill = side * side / (RectangleFactor * longSpread * shortSpread);
        if (!(aspect <= options.MaxAspect && fill >= MinFill && fill <= MaxFill))
            return 0;

        // The middle of the range, as a ratio.
        double size = Math.Log(side / Math.Sqrt(min * max)) / Math.Log(Math.Sqrt(max / min));
        double shapeLikeness =
            Likeness((fill - 1) / FillSpread) * Likeness((aspect - 1) / AspectSpread) * Likeness(size);
        return Math.Sqrt(shapeLikeness * target.Colour!.Closeness(shape.Red, shape.Green, shape.Blue));
    }

    private static double Likeness(double deviations) => Math.Exp(-0.5 * deviations * deviations);
}
