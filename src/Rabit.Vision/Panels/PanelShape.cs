namespace Rabit.Vision;

/// <summary>A part of a picture that may be a panel. A plain value; lengths in pixels.</summary>
public struct PanelShape
{
    /// <summary>Column of its centroid; the centre of the top left pixel is 0.</summary>
    public double CentreX { get; set; }

    /// <summary>Row of its centroid; the centre of the top left pixel is 0.</summary>
    public double CentreY { get; set; }

    /// <summary>Its area, with the pixels of its edge counted by the part that is covered.</summary>
    public double Area { get; set; }

    /// <summary>Pixels within its outline.</summary>
    public int OutlinePixels { get; set; }

    /// <summary>First column of the upright box around it.</summary>
    public int Left { get; set; }

    /// <summary>First row of that box.</summary>
    public int Top { get; set; }

    /// <summary>Columns of that box.</summary>
    public int Width { get; set; }

    /// <summary>Rows of that box.</summary>
    public int Height { get; set; }

    /// <summary>The part of it that shows the first colour, 0 to 1.</summary>
    public double FirstShare { get; set; }

    /// <summary>The part of it that shows the second colour, 0 to 1.</summary>
    public double SecondShare { get; set; }

    /// <summary>The part of the ring around it that is no bare ground, 0 to 1.</summary>
    public double CoveredRing { get; set; }

    /// <summary>
    /// How bright it is by the ground around it, both in linear light: above 1 for what is brighter.
    /// </summary>
    public double BrightnessByGround { get; set; }

    /// <summary>
    /// How much its brightness varies, one standard deviation of the pixels within its edge, by its difference from the
    /// ground: little for one colour.
    /// </summary>
    public double Unevenness { get; set; }

    /// <summary>
    /// What its outline is like; all 0 where <see cref="PanelLimits.MeasuresForm"/> does not ask for it.
    /// </summary>
    public FormMoments Form { get; set; }

    /// <summary>Whether the border of the picture may cut a part of it off.</summary>
    public bool TouchesBorder { get; set; }

    /// <summary>Where its outline begins among those of the picture.</summary>
    internal int FirstPoint { get; set; }

    /// <summary>How many points it has.</summary>
    internal int Points { get; set; }
}
