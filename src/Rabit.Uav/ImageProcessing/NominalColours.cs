using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>The colours of <see cref="TargetColours"/>, with the nominal values that it states: bit n is range n.</summary>
internal static class NominalColours
{
    public static ColourRange[] Ranges { get; } =
    [
        new(205, 28, 32),
        new(242, 112, 18),
        new(28, 72, 205),
        new(243, 214, 28),
        new(212, 36, 150),
    ];
}
