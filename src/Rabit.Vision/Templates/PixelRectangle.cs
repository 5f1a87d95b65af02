namespace Rabit.Vision;

/// <summary>An upright part of a picture, with its borders, pixels.</summary>
internal readonly struct PixelRectangle(double left, double top, double right, double bottom)
{
    public double Left { get; } = left;

    public double Top { get; } = top;

    public double Right { get; } = right;

    public double Bottom { get; } = bottom;

    public double CentreX => (Left + Right) / 2;

    public double CentreY => (Top + Bottom) / 2;

    public bool Contains(double x, double y) => x >= Left && x <= Right && y >= Top && y <= Bottom;

    public PixelRectangle Grown(double by) => new(Left - by, Top - by, Right + by, Bottom + by);
}
