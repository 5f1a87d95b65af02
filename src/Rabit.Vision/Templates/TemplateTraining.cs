using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace Rabit.Vision;

/// <summary>
/// One training of a template: first with other ground as examples of what the object is not, then in rounds with what
/// the template before wrongly found.
/// </summary>
internal sealed class TemplateTraining(IReadOnlyList<TrainingPicture> pictures, TemplateTrainingOptions options)
{
    // Of all positive samples together: fewer weigh more each.
    private const double Penalty = 8;
    private const double MinPenalty = 0.005;
    private const double MaxPenalty = 0.1;
    private const int Rounds = 3;
    private const int MaxWrongMatches = 150;
    private const int MaxGround = 400;
    private const int MaxGroundInAll = 8000;

    // Scores from here on count as wrongly found: on the far side of the margin.
    private const double MinWrongScore = -1;

    // What is nearer to an object is no example of what it is not, by its length.
    private const double Margin = 0.25;

    // An object at a heading so wrong is an example of what it is not.
    private const double WrongHeadingDegrees = 40;
    private const int WrongHeadingsPerObject = 3;

    private readonly ObjectTemplate _template = options.CreateTemplate();
    private readonly HeadingSearch _search = new();
    private readonly MatchSelection _selection = new(1000);
    private readonly SampleRandom _random = new(7);
    private readonly List<float[]> _negatives = [];
    private readonly TrainingWindows _windows = new();

    public ObjectTemplate Train(Action<double> onProgress, CancellationToken cancellation)
    {
        foreach (TrainingPicture picture in pictures)
            AddGround(picture, Math.Max(24, Math.Min(MaxGround, MaxGroundInAll / pictures.Count)));
        bool isAnyClear = pictures.Any(p => p.Objects.Any(o => o.IsClear));
        Fit(Positives(o => o.IsClear || !isAnyClear ? o.Heading : null), cancellation);
        for (int round = 0; round < Rounds; round++)
        {
            onProgress((round + 0.3) / (Rounds + 0.3));
            foreach (TrainingPicture picture in pictures)
            {
                cancellation.ThrowIfCancellationRequested();
                AddWrong(picture);
            }

            List<float[]> positives = [];
            foreach (TrainingPicture picture in pictures)
            {
                foreach (TrainingObject one in picture.Objects)
                    _windows.Add(picture, one, BetterHeading(picture, one), _template, _random, positives);
            }

            Fit(positives, cancellation);
        }

        _template.Threshold = 0;
        return _template;
    }

    private List<float[]> Positives(Func<TrainingObject, double?> headingOf)
    {
        List<float[]> positives = [];
        foreach (TrainingPicture picture in pictures)
        {
            foreach (TrainingObject one in picture.Objects)
            {
                if (headingOf(one) is { } heading)
                    _windows.Add(picture, one, heading, _template, _random, positives);
            }
        }

        return positives;
    }

    private void Fit(List<float[]> positives, CancellationToken cancellation)
    {
        double penalty = Math.Max(MinPenalty, Math.Min(MaxPenalty, Penalty / positives.Count));
        (_template.Weights, _template.Bias) = LinearSvm.Train(positives, _negatives, penalty, cancellation);
    }

    private double BetterHeading(TrainingPicture picture, TrainingObject one)
        => one.Heading == one.Other
            || _windows.Score(picture, one, one.Heading, _template)
                >= _windows.Score(picture, one, one.Other, _template)
            ? one.Heading
            : one.Other;

    private void AddGround(TrainingPicture picture, int count)
    {
        int each = Math.Max(1, count / _template.Headings);
        for (int heading = 0; heading < _template.Headings; heading++)
        {
            if (!Prepare(picture, heading))
                continue;
            for (int i = 0; i < each; i++)
            {
                (int row, int column) = (_random.Below(_search.Rows), _random.Below(_search.Columns));
                (double x, double y) = _search.CentreOf(row, column, isBetween: false);
                if (!picture.IsTaken(x, y, MarginPixels(picture)))
                    AddNegative(row, column);
            }
        }
    }

    // The picture is turned twice: the first time to find them, since only few of the windows are needed.
    private void AddWrong(TrainingPicture picture)
    {
        List<TemplateCandidate> wrong = [];
        _selection.Clear();
        for (int heading = 0; heading < _template.Headings; heading++)
        {
            if (Prepare(picture, heading))
            {
                TemplateScanner.Collect(
                    _search, _template, picture.Scale, heading, picture.Frame, MinWrongScore, _selection);
            }
        }

        double margin = MarginPixels(picture);
        foreach (TrainingObject one in picture.Objects)
            wrong.AddRange(_selection.Candidates.ToArray().Where(c => IsWrongHeading(c, one))
                .OrderByDescending(c => c.Match.Score).Take(WrongHeadingsPerObject));
        _selection.Remove(c => picture.IsTaken(c.Match.CentreX, c.Match.CentreY, margin));
        _selection.Select(_template.LengthMetres, _template.WidthMetres);
        wrong.AddRange(_selection.Selected.ToArray().Take(MaxWrongMatches));
        foreach (IGrouping<int, TemplateCandidate> same in wrong.GroupBy(c => c.Heading))
        {
            Prepare(picture, same.Key);
            foreach (TemplateCandidate one in same)
                AddNegative(one.Row, one.Column);
        }
    }

    private static bool IsWrongHeading(in TemplateCandidate candidate, TrainingObject one)
    {
        double least = Trig.Sin(WrongHeadingDegrees * Math.PI / 180);
        return one.Box.Contains(candidate.Match.CentreX, candidate.Match.CentreY)
            && Math.Abs(Trig.Sin(candidate.Match.HeadingRadians - one.Heading)) > least
            && Math.Abs(Trig.Sin(candidate.Match.HeadingRadians - one.Other)) > least;
    }

    private bool Prepare(TrainingPicture picture, int heading)
        => _search.Prepare(
            picture.Plane, picture.Scale, TemplateScanner.HeadingOf(heading, _template), _template, picture.Frame);

    private void AddNegative(int row, int column)
    {
        float[] window = new float[_template.CellsWide * _template.CellsLong * HogFeatures.Dimensions];
        _search.Features.CopyWindow(row, column, _template.CellsWide, _template.CellsLong, window);
        _negatives.Add(window);
    }

    private double MarginPixels(TrainingPicture picture)
        => Margin * _template.LengthMetres / Math.Sqrt(picture.Scale.PixelArea);
}
