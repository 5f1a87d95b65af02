using System;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// How unlike the form of a patch is to the shapes that classes declare; measured once for all of them, and only where
/// one asks. One thread.
/// </summary>
internal sealed class PatchForm
{
    private bool _isMeasured;

    /// <summary>Begins with another patch.</summary>
    public void Clear() => _isMeasured = false;

    /// <summary>The cost for a class; 0 for one without a shape, and where the border of the picture cuts it.</summary>
    /// <param name="shape">What was measured last; its form is added.</param>
    /// <param name="target">The class.</param>
    /// <param name="measure">What measured it.</param>
    public double CostFor(ref PatchShape shape, TargetClass target, PatchMeasure measure)
    {
        if (target.Shape == TargetShape.Any || shape.TouchesBorder)
            return 0;
        if (!_isMeasured)
            measure.MeasureForm(ref shape, PatchCost.BlurVariance);
        _isMeasured = true;
        return FormCost.Of(shape.Form, target.Shape, shape.Area, isOfWholePixels: false);
    }
}
