using System;

namespace Rabit.Vision;

/// <summary>An upright box of whole pixels, the last ones in it.</summary>
internal readonly struct RegionBox(int left, int top, int right, int bottom)
{
    public readonly int Left = left;
    public readonly int Top = top;
    public readonly int Right = right;
    public readonly int Bottom = bottom;

    public int Width => Right - Left + 1;

    public int Height => Bottom - Top + 1;

    public RegionBox With(in RegionBox other) => new(
        Math.Min(Left, other.Left), Math.Min(Top, other.Top), Math.Max(Right, other.Right),
        Math.Max(Bottom, other.Bottom));
}
