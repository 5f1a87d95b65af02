using System;
using System.Collections.Generic;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// What <see cref="ColourTargetDetector"/> takes for a target, beside colour and size. Read once, when the detector is
/// made.
/// </summary>
public sealed class ColourDetectorOptions
{
    /// <summary>How much longer than wide a target may be.</summary>
    /// <value>The default is 1.7: a square that is seen aslant or small.</value>
    public double MaxAspect { get; set; } = 1.7;

    /// <summary>Side of the smallest target in the picture, pixels: fewer do not show its form.</summary>
    /// <value>The default is 4.</value>
    public double MinSidePixels { get; set; } = 4;

    internal ColourDetectorOptions Copy() => (ColourDetectorOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (!(MaxAspect > 1))
            yield return FormattableString.Invariant($"{nameof(MaxAspect)} is {MaxAspect}; it must be above 1");
        if (!(MinSidePixels >= 4))
            yield return FormattableString.Invariant(
                $"{nameof(MinSidePixels)} is {MinSidePixels}; it must be at least 4");
    }
}
