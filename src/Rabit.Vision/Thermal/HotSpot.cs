namespace Rabit.Vision;

/// <summary>A connected warm area of a thermal picture, against the ground around it. A plain value.</summary>
public struct HotSpot
{
    /// <summary>Column of its centroid, weighted by contrast, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreX { get; set; }

    /// <summary>Row of its centroid, weighted by contrast, pixels; the centre of the top left pixel is 0.</summary>
    public double CentreY { get; set; }

    /// <summary>Variance of the centroid's column by the noise of the picture, square pixels.</summary>
    public double VarianceX { get; set; }

    /// <summary>Covariance of the centroid's column and row by the noise of the picture, square pixels.</summary>
    public double CovarianceXY { get; set; }

    /// <summary>Variance of the centroid's row by the noise of the picture, square pixels.</summary>
    public double VarianceY { get; set; }

    /// <summary>
    /// Area, pixels: its contrast in sum by that of its warmest part, so that pixels of its edge count in part.
    /// </summary>
    public double Area { get; set; }

    /// <summary>Second central moment of the columns, square pixels.</summary>
    public double MomentXX { get; set; }

    /// <summary>Second central moment of columns and rows, square pixels.</summary>
    public double MomentXY { get; set; }

    /// <summary>Second central moment of the rows, square pixels.</summary>
    public double MomentYY { get; set; }

    /// <summary>How much warmer than the ground around it its warmest part is, counts.</summary>
    public double Contrast { get; set; }

    /// <summary>The noise of a pixel in this picture, one standard deviation, counts.</summary>
    public double Noise { get; set; }

    /// <summary>First column of its box.</summary>
    public int Left { get; set; }

    /// <summary>First row of its box.</summary>
    public int Top { get; set; }

    /// <summary>Last column of its box.</summary>
    public int Right { get; set; }

    /// <summary>Last row of its box.</summary>
    public int Bottom { get; set; }

    /// <summary>Pixels at the end of the sensor's range: its contrast is more than what is given.</summary>
    public int SaturatedPixels { get; set; }
}
