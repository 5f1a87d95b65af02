using System;
using System.Collections.Generic;
using System.Linq;

namespace VisionBench;

/// <summary>The figures of a set, or of a part of it.</summary>
internal sealed class SetScore
{
    // Of a chi-square distribution with two degrees of freedom.
    private const double Ellipse95 = 5.991;

    private readonly List<TargetMatch> _matches;

    public SetScore(string name, IEnumerable<FrameScore> frames)
    {
        Name = name;
        FrameScore[] all = frames.ToArray();
        Frames = all.Length;
        _matches = all.SelectMany(f => f.Matches).ToList();
        FalseAlarms = all.Sum(f => f.FalseAlarms.Count);
        Duplicates = all.Sum(f => f.Duplicates);
        Markers = new MarkerTotals(all.Select(f => f.Markers).OfType<MarkerScore>());
        FalseAlarmsOn = all.SelectMany(f => f.FalseAlarms).GroupBy(a => a.On, StringComparer.Ordinal)
            .OrderByDescending(g => g.Count()).ThenBy(g => g.Key, StringComparer.Ordinal)
            .Select(g => (g.Key, g.Count())).ToArray();
    }

    public string Name { get; }

    public int Frames { get; }

    public int FalseAlarms { get; }

    public MarkerTotals Markers { get; }

    public int Duplicates { get; }

    public IReadOnlyList<(string On, int Count)> FalseAlarmsOn { get; }

    public double FalseAlarmsPerFrame => (double)FalseAlarms / Frames;

    /// <summary>Found and counted targets of a size, pixels.</summary>
    public (int Found, int Of) BySize(double from, double to)
        => Count(m => m.Target.Size >= from && m.Target.Size < to);

    public (int Found, int Of) ByKind(string kind) => Count(m => m.Target.Kind == kind);

    /// <summary>Panels that are whole, in full sight and at least 6 px large: root mean square, pixels.</summary>
    public double ClearPanelRms
        => Rms(_matches.Where(m => m.Target.Kind == "panel" && m.Target.IsWhole && m.Target.Size >= 6));

    public double Rms() => Rms(_matches);

    /// <summary>Of targets in full sight whose colour is not lost.</summary>
    public (double Mean, double Inside, int Count) ClearErrors
        => Consistency(m => m.Target.IsWhole && !m.IsClipped);

    /// <summary>Of those in full sight that are overexposed.</summary>
    public (double Mean, double Inside, int Count) ClippedErrors
        => Consistency(m => m.Target.IsWhole && m.IsClipped);

    /// <summary>Of those that are hidden in part or cut by the edge of the picture.</summary>
    public (double Mean, double Inside, int Count) PartialErrors => Consistency(m => !m.Target.IsWhole);

    private static double Rms(IEnumerable<TargetMatch> matches)
    {
        double[] errors = matches.Where(m => m.Found is not null).Select(m => m.Error).ToArray();
        return errors.Length == 0 ? double.NaN : Math.Sqrt(errors.Sum(e => e * e) / errors.Length);
    }

    private (double Mean, double Inside, int Count) Consistency(Func<TargetMatch, bool> which)
    {
        double[] squares = _matches.Where(m => m.Found is not null && which(m))
            .Select(m => m.NormalisedErrorSquared).ToArray();
        return squares.Length == 0
            ? (double.NaN, double.NaN, 0)
            : (squares.Average(), (double)squares.Count(s => s <= Ellipse95) / squares.Length, squares.Length);
    }

    private (int Found, int Of) Count(Func<TargetMatch, bool> which)
        => (_matches.Count(m => which(m) && m.Found is not null), _matches.Count(which));
}
