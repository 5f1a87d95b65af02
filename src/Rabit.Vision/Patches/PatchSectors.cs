using System;

namespace Rabit.Vision;

/// <summary>Directions around a patch, in equal parts of a turn.</summary>
internal static class PatchSectors
{
    public const int Count = 16;

    private const double TangentOfEighth = 0.41421356;

    /// <summary>
    /// By halves, quarters and so on: the sign of each axis, which is longer, and whether both are about equal.
    /// </summary>
    public static int Of(double across, double down)
    {
        (double x, double y) = (Math.Abs(across), Math.Abs(down));
        return (across < 0 ? 8 : 0) + (down < 0 ? 4 : 0) + (y > x ? 2 : 0)
            + (Math.Min(x, y) > TangentOfEighth * Math.Max(x, y) ? 1 : 0);
    }
}
