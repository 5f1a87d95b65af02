namespace Rabit.Vision;

/// <summary>Pixels of one colour that touch each other, and the upright box around them. A plain value.</summary>
public struct Patch
{
    /// <summary>Index of its colour in the table.</summary>
    public int Colour { get; set; }

    /// <summary>Whether only the pixels whose colour is clear were joined, not those of which it is possible.</summary>
    public bool IsStrong { get; set; }

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

    /// <summary>How many rows of pixels it is made of, more than one in a row of the picture counted apart.</summary>
    public int Runs { get; set; }

    /// <summary>The run that stands for all of them.</summary>
    internal int Root { get; set; }
}
