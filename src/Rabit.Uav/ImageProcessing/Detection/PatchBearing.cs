using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Where what a patch shows points. Fixed memory but for outlines larger than any before; for one thread.
/// </summary>
internal sealed class PatchBearing
{
    // Windows, shadows and what hides a part of it are in it: more than the edge of an even patch.
    private const double EdgeSigma = 0.6;

    // Pixels: the outline of a smaller one is that of the raster.
    private const double MinSidePixels = 8;

    // A square fills the smallest rectangle around it; a circle 0.79 of it, and any direction fits that.
    private const double MinFill = 0.85;

    private readonly OutlineOnGround _onGround = new();

    /// <summary>
    /// The direction of its long axis, or that of the sides of a square; null where it has none, may be but a part of
    /// the target, or the picture may cut it.
    /// </summary>
    /// <param name="shape">What was measured last.</param>
    /// <param name="target">Its class.</param>
    /// <param name="scale">Where it lies.</param>
    /// <param name="measure">What measured it.</param>
    public TargetBearing? Of(in PatchShape shape, TargetClass target, in GroundScale scale, PatchMeasure measure)
    {
        // A jacket is wider than long, and says nothing of where the person lies.
        if (shape.TouchesBorder || target.IsMostlyOfOtherColours)
            return null;
        var blob = new BlobShape
        {
            MomentXX = shape.MomentXX,
            MomentXY = shape.MomentXY,
            MomentYY = shape.MomentYY,
        };
        return BlobOnGround.BearingOf(blob, scale, EdgeSigma) ?? OfSides(shape, target, scale, measure);
    }

    private TargetBearing? OfSides(
        in PatchShape shape, TargetClass target, in GroundScale scale, PatchMeasure measure)
    {
        if (target.MinColourShare < 1 || shape.Area < MinSidePixels * MinSidePixels)
            return null;
        double pixel = Math.Sqrt(scale.PixelArea);
        var rectangle = FittedRectangle.Of(
            _onGround.Project(measure.FindOutline(), shape.CentreX, shape.CentreY, scale), pixel);
        return shape.Area * scale.PixelArea < MinFill * rectangle.Length * rectangle.Width
            ? null
            : PanelClass.BearingOf(rectangle, pixel);
    }
}
