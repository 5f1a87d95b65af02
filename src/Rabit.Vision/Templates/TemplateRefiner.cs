using System;

namespace Rabit.Vision;

/// <summary>
/// Finds where between the cells and the headings of the search a match lies, by the scores of windows a little beside
/// it. Memory that is used again; one thread.
/// </summary>
internal sealed class TemplateRefiner
{
    private const int Border = 2;   // cells, so that those of the window have neighbours

    private readonly HogFeatures _features = new();
    private float[] _pixels = [];
    private float[] _values = [];

    /// <summary>Moves and turns a match to the top of the parabolas through three scores.</summary>
    public void Refine(BrightnessPlane plane, ObjectTemplate template, ref TemplateMatch match)
    {
        double step = template.CellPixels / 2.0;
        double turn = Math.PI / template.Headings / 2;
        TemplateMatch at = match;
        double score = Score(plane, template, at, 0, 0, 0);
        double along = step * Peak(
            Score(plane, template, at, -step, 0, 0), score, Score(plane, template, at, step, 0, 0));
        double across = step * Peak(
            Score(plane, template, at, 0, -step, 0), score, Score(plane, template, at, 0, step, 0));
        double turned = turn * Peak(
            Score(plane, template, at, 0, 0, -turn), score, Score(plane, template, at, 0, 0, turn));
        var window = PlaneWindow.Along(at.Scale, at.HeadingRadians, template.MetresPerPixel);
        window.Put(0, 0, at.CentreX, at.CentreY);
        (match.CentreX, match.CentreY) = window.ToPicture(along, across);
        double heading = at.HeadingRadians + turned;
        match.HeadingRadians = heading < 0 ? heading + Math.PI : heading >= Math.PI ? heading - Math.PI : heading;
    }

    /// <summary>Of a window about a place, moved along and across by pixels of the template, and turned.</summary>
    public double Score(
        BrightnessPlane plane, ObjectTemplate template, in TemplateMatch at, double along, double across, double turn)
    {
        // Moved in the axes of the match, turned about the place it has then.
        var axes = PlaneWindow.Along(at.Scale, at.HeadingRadians, template.MetresPerPixel);
        axes.Put(0, 0, at.CentreX, at.CentreY);
        (double column, double row) = axes.ToPicture(along, across);
        int columns = template.WindowLength + (2 * Border * template.CellPixels);
        int rows = template.WindowWidth + (2 * Border * template.CellPixels);
        var window = PlaneWindow.Along(at.Scale, at.HeadingRadians + turn, template.MetresPerPixel);
        window.Put((columns - 1) / 2.0, (rows - 1) / 2.0, column, row);
        ReadOnlySpan<float> values = Values(plane, template, window);
        return FloatRows.Dot(values, template.Weights) + template.Bias;
    }

    /// <summary>The numbers of a window; valid until the next call.</summary>
    /// <param name="plane">The picture.</param>
    /// <param name="template">How large the window is.</param>
    /// <param name="window">Where it lies, with a border of two cells about it.</param>
    public ReadOnlySpan<float> Values(BrightnessPlane plane, ObjectTemplate template, in PlaneWindow window)
    {
        int columns = template.WindowLength + (2 * Border * template.CellPixels);
        int rows = template.WindowWidth + (2 * Border * template.CellPixels);
        int count = template.CellsWide * template.CellsLong * HogFeatures.Dimensions;
        if (_pixels.Length < columns * rows)
            _pixels = new float[columns * rows];
        if (_values.Length < count)
            _values = new float[count];
        plane.Sample(window, columns, rows, _pixels);
        _features.Compute(_pixels, columns, rows, template.CellPixels);
        Span<float> values = _values.AsSpan(0, count);
        _features.CopyWindow(Border, Border, template.CellsWide, template.CellsLong, values);
        return values;
    }

    // Of the parabola through three, -1 to 1 for the places of the first and the last.
    private static double Peak(double before, double at, double after)
    {
        double curve = (2 * at) - before - after;
        return curve > 0 ? Math.Max(-1, Math.Min(1, 0.5 * (after - before) / curve)) : 0;
    }
}
