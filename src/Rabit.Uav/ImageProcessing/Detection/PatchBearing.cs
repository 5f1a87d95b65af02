using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Where what a patch shows points.</summary>
internal static class PatchBearing
{
    // Windows, shadows and what hides a part of it are in it: more than the edge of an even patch.
    private const double EdgeSigma = 0.6;

    // A jacket is wider than long, and says nothing of where the person lies.
    private const double MinColourShare = 0.5;

    /// <summary>
    /// The direction of its long axis; null where it has none, may be but a part of the target, or the picture may cut
    /// it.
    /// </summary>
    public static TargetBearing? Of(in PatchShape shape, TargetClass target, in PictureGroundScale ground)
    {
        if (shape.TouchesBorder || target.MinColourShare < MinColourShare
            || !ground.TryAt(shape.CentreX, shape.CentreY, out GroundScale scale))
            return null;
        var blob = new BlobShape
        {
            MomentXX = shape.MomentXX,
            MomentXY = shape.MomentXY,
            MomentYY = shape.MomentYY,
        };
        return BlobOnGround.BearingOf(blob, scale, EdgeSigma);
    }
}
