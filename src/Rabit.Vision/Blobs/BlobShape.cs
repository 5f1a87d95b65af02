namespace Rabit.Vision;

/// <summary>What was measured of a blob below the size of a pixel. A plain value; lengths in pixels.</summary>
public struct BlobShape
{
    /// <summary>Column of the centre, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreX { get; set; }

    /// <summary>Row of the centre, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreY { get; set; }

    /// <summary>Square pixels, with those at the edge counted by the part that is covered.</summary>
    public double Area { get; set; }

    /// <summary>Second moment of the columns about the centre, square pixels.</summary>
    public double MomentXX { get; set; }

    /// <summary>Mixed second moment about the centre, square pixels.</summary>
    public double MomentXY { get; set; }

    /// <summary>Second moment of the rows about the centre, square pixels.</summary>
    public double MomentYY { get; set; }

    /// <summary>The red inside, 0 to 255.</summary>
    public double Red { get; set; }

    /// <summary>The green inside, 0 to 255.</summary>
    public double Green { get; set; }

    /// <summary>The blue inside, 0 to 255.</summary>
    public double Blue { get; set; }
}
