using System;
using System.Collections.Generic;
using System.IO;

namespace Rabit.Vision;

/// <summary>
/// What an object of one kind looks like from above: weights for the edges in a window about it, as
/// <see cref="TemplateTrainer"/> finds them in labelled pictures, for a size on the ground. Immutable.
/// </summary>
/// <remarks>Its file is text, described in docs/template-file.md.</remarks>
public sealed class ObjectTemplate
{
    internal const int MaxCells = 64;
    internal const int MaxHeadings = 36;

    private const int MinCellPixels = 2;
    private const int MaxCellPixels = 16;
    private const double MinSize = 0.01;
    private const double MaxSize = 100;

    internal ObjectTemplate()
    {
    }

    /// <summary>What it is called: for people.</summary>
    public string Name { get; internal set; } = "";

    /// <summary>Length of the object, metres.</summary>
    public double LengthMetres { get; internal set; }

    /// <summary>Width of the object, metres.</summary>
    public double WidthMetres { get; internal set; }

    /// <summary>Side of a pixel on the ground at which pictures are searched, metres.</summary>
    public double MetresPerPixel { get; internal set; }

    /// <summary>Score from which on a place is a match.</summary>
    public double Threshold { get; internal set; }

    /// <summary>How far a found centre is off, one standard deviation along each axis, metres.</summary>
    public double SigmaMetres { get; internal set; }

    internal int CellPixels { get; set; }

    internal int CellsLong { get; set; }

    internal int CellsWide { get; set; }

    /// <summary>Between 0 and half a turn.</summary>
    internal int Headings { get; set; }

    internal double Bias { get; set; }

    // Probability = 1 / (1 + exp(-(Slope x score + Offset))).
    internal double Slope { get; set; }

    internal double Offset { get; set; }

    /// <summary>Of the window: row after row, cell after cell, <see cref="HogFeatures.Dimensions"/> each.</summary>
    internal float[] Weights { get; set; } = [];

    internal int WindowLength => CellsLong * CellPixels;

    internal int WindowWidth => CellsWide * CellPixels;

    /// <summary>Reads one.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PictureException">
    /// It cannot be read, or is no template; the message names file and line.
    /// </exception>
    public static ObjectTemplate Load(string path) => TemplateFile.Load(path);

    /// <summary>Writes it.</summary>
    /// <param name="path">The file; one that there is, is replaced.</param>
    /// <exception cref="PictureException">It cannot be written.</exception>
    public void Save(string path)
    {
        try
        {
            File.WriteAllBytes(path, TemplateFile.Format(this));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException
            or NotSupportedException)
        {
            throw new PictureException(path, "it cannot be written: " + e.Message, e);
        }
    }

    internal double ProbabilityOf(double score) => 1 / (1 + Math.Exp(-((Slope * score) + Offset)));

    // What a file says, or options of training lead to: comparisons with NaN are false.
    internal IEnumerable<string> FindFaults()
    {
        if (!(LengthMetres >= WidthMetres && WidthMetres >= MinSize && LengthMetres <= MaxSize))
            yield return FormattableString.Invariant(
                $"the object is {LengthMetres} x {WidthMetres} m; it must be {MinSize} to {MaxSize} m, the length first");
        if (!(MetresPerPixel > 0 && MetresPerPixel <= WidthMetres / 2))
            yield return FormattableString.Invariant(
                $"a pixel of {MetresPerPixel} m does not show an object {WidthMetres} m wide");
        if (CellPixels is < MinCellPixels or > MaxCellPixels)
            yield return $"cells of {CellPixels} pixels; {MinCellPixels} to {MaxCellPixels} are possible";
        if (CellsLong is < 1 or > MaxCells || CellsWide is < 1 or > MaxCells)
            yield return $"a window of {CellsLong} x {CellsWide} cells; 1 to {MaxCells} are possible";
        if (Headings is < 1 or > MaxHeadings)
            yield return $"{Headings} headings; 1 to {MaxHeadings} are possible";
        if (!(SigmaMetres > 0 && SigmaMetres <= LengthMetres))
            yield return FormattableString.Invariant(
                $"a sigma of {SigmaMetres} m; it must be above 0 and not above the length");
        if (!IsFinite(Threshold) || !IsFinite(Bias) || !IsFinite(Offset) || !(Slope > 0 && IsFinite(Slope)))
            yield return "threshold, bias, slope and offset must be finite numbers, the slope above 0";
    }

    private static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
}
