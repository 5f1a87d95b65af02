namespace Rabit.Vision;

/// <summary>A marker that was found in a picture. A plain value.</summary>
public struct DetectedMarker
{
    /// <summary>Which family it belongs to.</summary>
    public MarkerFamily Family { get; set; }

    /// <summary>Which of the family it is.</summary>
    public int Id { get; set; }

    /// <summary>How many cells were read wrong and corrected.</summary>
    public int CorrectedBits { get; set; }

    /// <summary>
    /// How clearly the cells were read, 0 to 1: how far they lie, in the mean, from the grey between black and white.
    /// </summary>
    public double Margin { get; set; }

    /// <summary>White less black, grey levels.</summary>
    public double Contrast { get; set; }

    /// <summary>The outer corners of the black square.</summary>
    public MarkerCorners Corners { get; set; }

    /// <summary>How uncertain each coordinate of a corner is, one standard deviation, pixels.</summary>
    public double CornerSigmaPixels { get; set; }
}
