namespace Rabit.Uav.ImageProcessing;

/// <summary>Pixels of one colour that touch each other, and the upright box around them. A plain value.</summary>
internal struct Blob
{
    /// <summary>As in <see cref="ColourTable.Classes"/>.</summary>
    public byte Class;

    public int Left;
    public int Right;
    public int Top;
    public int Bottom;

    /// <summary>How many.</summary>
    public int Pixels;
}
