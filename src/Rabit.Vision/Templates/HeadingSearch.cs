using System;

namespace Rabit.Vision;

/// <summary>
/// The windows of one heading in a part of a picture: it is turned so that the heading lies along the columns, and
/// every cell of it begins a window. Memory that is used again; one thread.
/// </summary>
internal sealed class HeadingSearch
{
    private readonly HogFeatures _features = new();
    private float[] _pixels = [];
    private float[] _scores = [];
    private PlaneWindow _window;
    private int _cell;
    private int _length;
    private int _width;

    /// <summary>How many windows there are one below the other.</summary>
    public int Rows { get; private set; }

    /// <summary>How many windows there are side by side.</summary>
    public int Columns { get; private set; }

    public HogFeatures Features => _features;

    /// <summary>Of the window of a row and a column; after <see cref="ScoreAll"/>.</summary>
    public float ScoreOf(int row, int column) => _scores[(row * Columns) + column];

    /// <summary>Turns the part; objects whose centre is in it, and which are whole in it, have a window.</summary>
    /// <returns>False where the part is too small for a window.</returns>
    public bool Prepare(
        BrightnessPlane plane, in PlaneScale scale, double heading, ObjectTemplate template, in PixelRectangle part)
    {
        (_cell, _length, _width) = (template.CellPixels, template.WindowLength, template.WindowWidth);
        _window = PlaneWindow.Along(scale, heading, template.MetresPerPixel);
        _window.Put(0, 0, part.CentreX, part.CentreY);
        // As much around it as the window is larger than the object.
        double marginX = Math.Max(0, (_length - (template.LengthMetres / template.MetresPerPixel)) / 2);
        double marginY = Math.Max(0, (_width - (template.WidthMetres / template.MetresPerPixel)) / 2);
        (double left, double top, double right, double bottom) = Around(part);
        int width = (int)(right - left + (2 * marginX));
        int height = (int)(bottom - top + (2 * marginY));
        Columns = (width / _cell) - template.CellsLong + 1;
        Rows = (height / _cell) - template.CellsWide + 1;
        if (Columns < 1 || Rows < 1)
            return false;
        (_window.Column, _window.Row) = _window.ToPicture(left - marginX, top - marginY);
        if (_pixels.Length < width * height)
            _pixels = new float[width * height];
        plane.Sample(_window, width, height, _pixels);
        _features.Compute(_pixels, width, height, _cell);
        return true;
    }

    /// <summary>Scores every window.</summary>
    public void ScoreAll(ObjectTemplate template)
    {
        if (_scores.Length < Rows * Columns)
            _scores = new float[Rows * Columns];
        for (int row = 0; row < Rows; row++)
        {
            Span<float> scores = _scores.AsSpan(row * Columns, Columns);
            scores.Fill((float)template.Bias);
            for (int r = 0; r < template.CellsWide; r++)
            {
                for (int c = 0; c < template.CellsLong; c++)
                    AddCell(scores, row + r, c, template, (r * template.CellsLong) + c);
            }
        }
    }

    /// <summary>Whether no window beside it, above or below has a higher score.</summary>
    public bool IsPeak(int row, int column)
    {
        float score = ScoreOf(row, column);
        for (int r = Math.Max(0, row - 1); r <= Math.Min(Rows - 1, row + 1); r++)
        {
            for (int c = Math.Max(0, column - 1); c <= Math.Min(Columns - 1, column + 1); c++)
            {
                if (ScoreOf(r, c) > score)
                    return false;
            }
        }

        return true;
    }

    /// <summary>The centre of a window in the picture.</summary>
    /// <param name="row">Of the window.</param>
    /// <param name="column">Of the window.</param>
    /// <param name="isBetween">It is a peak: its place between the cells is found by the scores beside it.</param>
    public (double X, double Y) CentreOf(int row, int column, bool isBetween)
    {
        double x = column + (isBetween && column > 0 && column < Columns - 1
            ? Peak(ScoreOf(row, column - 1), ScoreOf(row, column), ScoreOf(row, column + 1))
            : 0);
        double y = row + (isBetween && row > 0 && row < Rows - 1
            ? Peak(ScoreOf(row - 1, column), ScoreOf(row, column), ScoreOf(row + 1, column))
            : 0);
        return _window.ToPicture((x * _cell) + ((_length - 1) / 2.0), (y * _cell) + ((_width - 1) / 2.0));
    }

    // Of the parabola through three.
    private static double Peak(double before, double at, double after)
    {
        double curve = (2 * at) - before - after;
        return curve > 0 ? Math.Max(-0.5, Math.Min(0.5, 0.5 * (after - before) / curve)) : 0;
    }

    private void AddCell(Span<float> scores, int row, int column, ObjectTemplate template, int cell)
    {
        ReadOnlySpan<float> values = _features.Values;
        for (int d = 0; d < HogFeatures.Dimensions; d++)
        {
            int at = (((d * _features.Rows) + row) * _features.Columns) + column;
            FloatRows.AddMultiple(
                scores, values.Slice(at, Columns), template.Weights[(cell * HogFeatures.Dimensions) + d]);
        }
    }

    private (double Left, double Top, double Right, double Bottom) Around(in PixelRectangle part)
    {
        (double left, double top) = (double.MaxValue, double.MaxValue);
        (double right, double bottom) = (double.MinValue, double.MinValue);
        for (int corner = 0; corner < 4; corner++)
        {
            (double x, double y) = _window.FromPicture(
                corner % 2 == 0 ? part.Left : part.Right, corner / 2 == 0 ? part.Top : part.Bottom);
            (left, top) = (Math.Min(left, x), Math.Min(top, y));
            (right, bottom) = (Math.Max(right, x), Math.Max(bottom, y));
        }

        return (left, top, right, bottom);
    }
}
