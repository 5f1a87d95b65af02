namespace Rabit.Vision;

/// <summary>What was measured of a patch below the size of a pixel. A plain value; lengths in pixels.</summary>
public struct PatchShape
{
    /// <summary>Column of the centre; the centre of the top left pixel is 0.</summary>
    public double CentreX { get; set; }

    /// <summary>Row of the centre; the centre of the top left pixel is 0.</summary>
    public double CentreY { get; set; }

    /// <summary>Square pixels, with those at the edge counted by the part that is covered.</summary>
    public double Area { get; set; }

    /// <summary>Second moment of the columns about the centre.</summary>
    public double MomentXX { get; set; }

    /// <summary>Mixed second moment about the centre.</summary>
    public double MomentXY { get; set; }

    /// <summary>Second moment of the rows about the centre.</summary>
    public double MomentYY { get; set; }

    /// <summary>Columns of the upright box around it.</summary>
    public double Width { get; set; }

    /// <summary>Rows of the upright box around it.</summary>
    public double Height { get; set; }

    /// <summary>Red inside, with the tint of the picture undone.</summary>
    public double Red { get; set; }

    /// <summary>Green inside.</summary>
    public double Green { get; set; }

    /// <summary>Blue inside, with the tint of the picture undone.</summary>
    public double Blue { get; set; }

    /// <summary>Red of the ground around it, with the tint of the picture undone.</summary>
    public double GroundRed { get; set; }

    /// <summary>Green of the ground around it.</summary>
    public double GroundGreen { get; set; }

    /// <summary>Blue of the ground around it, with the tint of the picture undone.</summary>
    public double GroundBlue { get; set; }

    /// <summary>How far apart the two colours are, levels.</summary>
    public double Contrast { get; set; }

    /// <summary>The part of its surroundings that is more like it than like the ground, 0 to 1.</summary>
    public double Continuation { get; set; }

    /// <summary>Its outline, as a part of that of the upright box around it: 1 for what has no dents.</summary>
    public double Outline { get; set; }

    /// <summary>How much its colour varies inside, as a part of the contrast.</summary>
    public double Unevenness { get; set; }

    /// <summary>How much the ground around it varies, as a part of the contrast.</summary>
    public double GroundNoise { get; set; }

    /// <summary>
    /// How much the ground differs from side to side, as a part of the contrast: much where something lies over a part
    /// of it, as the crown of a tree. 0 until <see cref="PatchMeasure.CorrectCentre"/>.
    /// </summary>
    public double GroundDifference { get; set; }

    /// <summary>
    /// How far the hue of what lies beside it in one direction is from that of the ground around, degrees between the
    /// two colours as vectors: what else may belong to it, as the trousers below a jacket. 0 until
    /// <see cref="PatchMeasure.MeasureSurroundings"/>.
    /// </summary>
    public double OtherBeside { get; set; }

    /// <summary>What its form is like; all 0 until <see cref="PatchMeasure.MeasureForm"/>.</summary>
    public FormMoments Form { get; set; }

    /// <summary>Whether the border of the picture may cut a part of it off.</summary>
    public readonly bool TouchesBorder => CutLength > 0;

    /// <summary>
    /// How much of the border of the picture it covers, pixels: what is only touched by a corner goes on hardly at all
    /// beyond it.
    /// </summary>
    public double CutLength { get; set; }
}
