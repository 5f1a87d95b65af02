using System;

namespace Rabit.Vision;

/// <summary>
/// Finds what looks like a template in pictures, at every heading. <see cref="Begin"/> takes a picture,
/// <see cref="Scan"/> searches a part of it in which a pixel reaches about equally far on the ground, and
/// <see cref="Finish"/> gives the matches, of which none covers another. Memory that is used again: nothing is
/// allocated for further pictures of a size. One thread.
/// </summary>
/// <example>
/// A picture from 60 m above, whose pixels are 6 cm large on the ground:
/// <code>
/// var scanner = new TemplateScanner(ObjectTemplate.Load("car.template"));
/// scanner.Begin(picture.Pixels, picture.Width, picture.Height);
/// scanner.Scan(PlaneScale.Uniform(0.06), 0, 0, picture.Width - 1, picture.Height - 1);
/// foreach (TemplateMatch match in scanner.Finish())
///     Console.WriteLine($"{match.Probability} at {match.CentreX}, {match.CentreY}");
/// </code>
/// </example>
public sealed class TemplateScanner
{
    /// <summary>How many matches of a picture are kept, the best.</summary>
    public const int MaxMatches = 256;

    // The others stay where the search found them, within a quarter of a cell.
    private const int MaxRefined = 64;

    // Pixels so much coarser than those of the template do not show its edges.
    private const double MaxCoarseness = 1.7;

    private readonly ObjectTemplate _template;
    private readonly BrightnessPlane _plane = new();
    private readonly HeadingSearch _search = new();
    private readonly TemplateRefiner _refiner = new();
    private readonly MatchSelection _selection = new(MaxMatches);
    private readonly TemplateMatch[] _matches = new TemplateMatch[MaxMatches];
    private ReadOnlyMemory<byte> _pixels;
    private int _width;
    private int _height;
    private bool _isPlaneSet;

    /// <summary>Makes it.</summary>
    /// <param name="template">What to find.</param>
    public TemplateScanner(ObjectTemplate template)
        => _template = template ?? throw new ArgumentNullException(nameof(template));

    /// <summary>Matches of the last picture that had no room.</summary>
    public int Dropped => _selection.Dropped;

    /// <summary>Takes a picture, which must stay as it is until <see cref="Finish"/>.</summary>
    /// <param name="pixels">Red, green and blue, row by row from the top left.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <exception cref="ArgumentException">The size is not positive, or the bytes are too few for it.</exception>
    public void Begin(ReadOnlyMemory<byte> pixels, int width, int height)
    {
        if (width < 1 || height < 1 || pixels.Length / 3 / width < height)
            throw new ArgumentException(
                $"A buffer of {pixels.Length} bytes does not hold a picture of {width} x {height} pixels.",
                nameof(pixels));
        (_pixels, _width, _height, _isPlaneSet) = (pixels, width, height, false);
        _selection.Clear();
    }

    /// <summary>
    /// Whether a part whose pixels reach so far can be searched: finer ones can, much coarser ones not.
    /// </summary>
    /// <param name="scale">In the part.</param>
    public bool CanSearch(in PlaneScale scale)
        => scale.PixelArea > 0 && Math.Sqrt(scale.PixelArea) <= MaxCoarseness * _template.MetresPerPixel;

    /// <summary>Searches a part.</summary>
    /// <param name="scale">How far a pixel reaches in it, 15 % either way.</param>
    /// <param name="left">First column.</param>
    /// <param name="top">First row.</param>
    /// <param name="right">Last column.</param>
    /// <param name="bottom">Last row.</param>
    /// <returns>False where its pixels are too coarse (<see cref="CanSearch"/>).</returns>
    public bool Scan(in PlaneScale scale, double left, double top, double right, double bottom)
    {
        if (!CanSearch(scale))
            return false;
        SetPlane(scale);
        if (_plane.Width < 1 || _plane.Height < 1)
            return true;
        var part = new PixelRectangle(left, top, right, bottom);
        for (int i = 0; i < _template.Headings; i++)
        {
            if (_search.Prepare(_plane, scale, HeadingOf(i, _template), _template, part))
                Collect(_search, _template, scale, i, part, _template.Threshold, _selection);
        }

        return true;
    }

    /// <summary>Ends with a picture.</summary>
    /// <returns>The matches, the best first; valid until the next picture.</returns>
    public ReadOnlySpan<TemplateMatch> Finish()
    {
        _selection.Select(_template.LengthMetres, _template.WidthMetres);
        int count = 0;
        foreach (ref readonly TemplateCandidate candidate in _selection.Selected)
        {
            _matches[count] = candidate.Match;
            _matches[count].Probability = _template.ProbabilityOf(candidate.Match.Score);
            if (count < MaxRefined)
                Refine(ref _matches[count]);
            count++;
        }

        _pixels = default;
        return new ReadOnlySpan<TemplateMatch>(_matches, 0, count);
    }

    private void SetPlane(in PlaneScale scale)
    {
        int factor = FactorOf(scale, _template);
        if (!_isPlaneSet || _plane.Factor != factor)
            _plane.Set(_pixels.Span, _width, _height, factor);
        _isPlaneSet = true;
    }

    private void Refine(ref TemplateMatch match)
    {
        SetPlane(match.Scale);
        _refiner.Refine(_plane, _template, ref match);
        match.CentreX = Math.Max(-0.5, Math.Min(match.CentreX, _width - 0.5));
        match.CentreY = Math.Max(-0.5, Math.Min(match.CentreY, _height - 0.5));
    }

    /// <summary>How much smaller a picture is made before it is sampled.</summary>
    internal static int FactorOf(in PlaneScale scale, ObjectTemplate template)
        => Math.Max(1, (int)(template.MetresPerPixel / Math.Sqrt(scale.PixelArea)));

    internal static double HeadingOf(int index, ObjectTemplate template) => index * Math.PI / template.Headings;

    /// <summary>Scores the windows of a heading, and adds the peaks among them.</summary>
    internal static void Collect(
        HeadingSearch search, ObjectTemplate template, in PlaneScale scale, int heading, in PixelRectangle part,
        double threshold, MatchSelection selection)
    {
        search.ScoreAll(template);
        var candidate = default(TemplateCandidate);
        (candidate.Heading, candidate.Match.Scale) = (heading, scale);
        candidate.Match.HeadingRadians = HeadingOf(heading, template);
        candidate.Match.HeadingStepRadians = HeadingOf(1, template);
        for (int row = 0; row < search.Rows; row++)
        {
            for (int column = 0; column < search.Columns; column++)
            {
                float score = search.ScoreOf(row, column);
                if (score < threshold || !search.IsPeak(row, column))
                    continue;
                (double x, double y) = search.CentreOf(row, column, isBetween: true);
                if (!part.Contains(x, y))
                    continue;
                (candidate.Match.CentreX, candidate.Match.CentreY, candidate.Match.Score) = (x, y, score);
                (candidate.Row, candidate.Column) = (row, column);
                selection.Add(candidate);
            }
        }
    }
}
