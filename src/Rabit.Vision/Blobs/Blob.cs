namespace Rabit.Vision;

/// <summary>
/// Pixels of one class of colours that touch each other, and the upright box around them. A plain value.
/// </summary>
public struct Blob
{
    /// <summary>As <see cref="ColourTable.ClassOf"/> gives it.</summary>
    public byte Class { get; set; }

    /// <summary>First column.</summary>
    public int Left { get; set; }

    /// <summary>Last column.</summary>
    public int Right { get; set; }

    /// <summary>First row.</summary>
    public int Top { get; set; }

    /// <summary>Last row.</summary>
    public int Bottom { get; set; }

    /// <summary>How many pixels.</summary>
    public int Pixels { get; set; }
}
