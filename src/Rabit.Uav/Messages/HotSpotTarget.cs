using System;
using System.Collections.Generic;

namespace Rabit.Uav.Messages;

/// <summary>
/// That a class of targets is warmer than the ground around it, in pictures of a thermal camera. Immutable.
/// </summary>
public sealed class HotSpotTarget
{
    /// <summary>
    /// How much warmer its warmest part is at least, counts of the sensor; 0 for noise alone to decide.
    /// </summary>
    /// <value>The default is 0: what a count means in degrees is a matter of the camera and its gain.</value>
    public double MinContrastCounts { get; init; }

    /// <summary>How much warmer its warmest part is at least, by the noise of a pixel.</summary>
    /// <value>The default is 6: at 5 the noise of a picture of 640 x 512 gives some alarms an hour.</value>
    public double MinSigmas { get; init; } = 6;

    internal IEnumerable<string> FindFaults(TargetClass owner)
    {
        if (!(MinContrastCounts >= 0 && MinContrastCounts <= ushort.MaxValue))
            yield return FormattableString.Invariant(
                $"{nameof(MinContrastCounts)} of target class {owner.Name} is {MinContrastCounts}; it must be 0 to {ushort.MaxValue}");
        if (!(MinSigmas >= 3 && MinSigmas <= 1000))
            yield return FormattableString.Invariant(
                $"{nameof(MinSigmas)} of target class {owner.Name} is {MinSigmas}; it must be 3 to 1000");
        if (owner.Colour is not null || owner.Marker is not null || owner.Template is not null)
            yield return $"target class {owner.Name} is a hot spot and has a colour, a marker or a template; it can only "
                + "have one of them";
    }
}
