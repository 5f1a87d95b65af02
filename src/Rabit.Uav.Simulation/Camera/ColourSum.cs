namespace Rabit.Uav.Simulation;

/// <summary>
/// The colours that the rays of one pixel meet. A changing value: keep it in a local that is not copied.
/// </summary>
internal struct ColourSum
{
    private int _red;
    private int _green;
    private int _blue;
    private int _count;

    public void Add(SurfaceColour colour)
    {
        _red += colour.Red;
        _green += colour.Green;
        _blue += colour.Blue;
        _count++;
    }

    /// <summary>Mixes them into a pixel, whose own colour all other rays meet.</summary>
    /// <param name="pixels">The picture.</param>
    /// <param name="at">Where its red is.</param>
    /// <param name="all">How many rays a pixel has.</param>
    public readonly void Cover(byte[] pixels, int at, int all)
    {
        int others = all - _count;
        pixels[at] = (byte)(((pixels[at] * others) + _red) / all);
        pixels[at + 1] = (byte)(((pixels[at + 1] * others) + _green) / all);
        pixels[at + 2] = (byte)(((pixels[at + 2] * others) + _blue) / all);
    }
}
