using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace Rabit.Vision;

/// <summary>
/// What templates found in pictures that they were not trained with: threshold, probability and error of a template
/// come from it.
/// </summary>
internal sealed class HeldOutScores
{
    // Low enough for the tail of what is the object.
    private const double MinScore = -1.5;
    private const int MinForCalibration = 10;
    private const int Steps = 400;

    private readonly List<(double Score, bool IsObject, double ErrorSquared)> _found = [];
    private readonly HeadingSearch _search = new();
    private readonly MatchSelection _selection = new(1000);
    private int _pictures;
    private int _objects;

    /// <summary>Searches a picture that was left out.</summary>
    public void Add(TrainingPicture picture, ObjectTemplate template, CancellationToken cancellation)
    {
        _pictures++;
        _objects += picture.Objects.Count;
        _selection.Clear();
        for (int heading = 0; heading < template.Headings; heading++)
        {
            cancellation.ThrowIfCancellationRequested();
            if (_search.Prepare(
                picture.Plane, picture.Scale, TemplateScanner.HeadingOf(heading, template), template, picture.Frame))
            {
                TemplateScanner.Collect(
                    _search, template, picture.Scale, heading, picture.Frame, MinScore, _selection);
            }
        }

        _selection.Select(template.LengthMetres, template.WidthMetres);
        var isTaken = new HashSet<TrainingObject>();
        foreach (TemplateCandidate one in _selection.Selected)
            Add(one.Match, picture, isTaken);
    }

    /// <summary>Sets what a template says of its scores.</summary>
    public void Calibrate(TemplateTrainingResult result, double falseAlarmsPerPicture)
    {
        int wrong = _found.Count(f => !f.IsObject);
        int right = _found.Count - wrong;
        if (wrong < MinForCalibration || right < MinForCalibration)
        {
            result.Folds = 0;
            return;
        }

        ObjectTemplate template = result.Template;
        int allowed = (int)(falseAlarmsPerPicture * _pictures);
        double[] scores = _found.Where(f => !f.IsObject).Select(f => f.Score).OrderByDescending(s => s).ToArray();
        // Half way between the last false alarm that is allowed and the next.
        template.Threshold = allowed >= scores.Length ? MinScore
            : allowed == 0 ? scores[0] + 0.1
            : (scores[allowed - 1] + scores[allowed]) / 2;
        (template.Slope, template.Offset) = Logistic();
        var over = _found.Where(f => f.Score >= template.Threshold).ToArray();
        double[] errors = over.Where(f => f.IsObject).Select(f => f.ErrorSquared).ToArray();
        if (errors.Length > 0)
            template.SigmaMetres = Math.Max(template.SigmaMetres / 4, Math.Sqrt(errors.Average() / 2));
        result.Recall = (double)errors.Length / _objects;
        result.FalseAlarmsPerPicture = (double)(over.Length - errors.Length) / _pictures;
    }

    private void Add(in TemplateMatch match, TrainingPicture picture, HashSet<TrainingObject> isTaken)
    {
        (double x, double y) = (match.CentreX, match.CentreY);
        TrainingObject? nearest = null;
        double least = double.MaxValue;
        foreach (TrainingObject one in picture.Objects)
        {
            double square = Square(one.Box.CentreX - x) + Square(one.Box.CentreY - y);
            if (one.Box.Contains(x, y) && square < least && !isTaken.Contains(one))
                (nearest, least) = (one, square);
        }

        if (nearest is null && picture.Ignored.Any(b => b.Contains(x, y)))
            return;
        if (nearest is not null)
            isTaken.Add(nearest);
        _found.Add((match.Score, nearest is not null, least * picture.Scale.PixelArea));
    }

    // Newton's method on the logistic likelihood, with the targets of J. Platt (1999) against certainty.
    private (double Slope, double Offset) Logistic()
    {
        double right = _found.Count(f => f.IsObject);
        double wrong = _found.Count - right;
        (double slope, double offset) = (2, 0);
        for (int step = 0; step < Steps; step++)
        {
            (double g0, double g1, double h00, double h01, double h11) = (0, 0, 1e-6, 0, 1e-6);
            foreach ((double score, bool isObject, _) in _found)
            {
                double p = 1 / (1 + Math.Exp(-((slope * score) + offset)));
                double error = p - (isObject ? (right + 1) / (right + 2) : 1 / (wrong + 2));
                double weight = Math.Max(p * (1 - p), 1e-9);
                (g0, g1) = (g0 + (error * score), g1 + error);
                (h00, h01, h11) = (h00 + (weight * score * score), h01 + (weight * score), h11 + weight);
            }

            double determinant = (h00 * h11) - (h01 * h01);
            double first = ((h11 * g0) - (h01 * g1)) / determinant;
            double second = ((h00 * g1) - (h01 * g0)) / determinant;
            double shorter = Math.Min(1, 1 / Math.Max(Math.Abs(first), Math.Abs(second)));
            slope = Math.Max(0.1, slope - (shorter * first));
            offset -= shorter * second;
        }

        return (slope, offset);
    }

    private static double Square(double value) => value * value;
}
