using System;

namespace Rabit.Vision;

/// <summary>A grey picture between whose pixels can be read. Valid as long as its bytes.</summary>
internal readonly ref struct GreyView(ReadOnlySpan<byte> pixels, int width, int height)
{
    private readonly ReadOnlySpan<byte> _pixels = pixels;

    public int Width { get; } = width;

    public int Height { get; } = height;

    /// <summary>Between four pixels; those of the edge go on beyond it.</summary>
    public double At(double x, double y)
    {
        x = x > 0 ? Math.Min(x, Width - 1) : 0;
        y = y > 0 ? Math.Min(y, Height - 1) : 0;
        int column = Math.Min((int)x, Width - 2);
        int row = Math.Min((int)y, Height - 2);
        double right = x - column;
        double down = y - row;
        int at = (row * Width) + column;
        double top = _pixels[at] + (right * (_pixels[at + 1] - _pixels[at]));
        at += Width;
        double bottom = _pixels[at] + (right * (_pixels[at + 1] - _pixels[at]));
        return top + (down * (bottom - top));
    }
}
