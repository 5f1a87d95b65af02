using System;
using System.Collections.Generic;
using System.Globalization;

namespace VisionBench;

/// <summary>The figures of a set as lines: what it is, the value, and that of the reference where it has one.</summary>
internal static class ScoreRows
{
    private static readonly string[] Kinds = ["panel", "person", "vehicle"];

    public static IEnumerable<(string Name, string Value, string Reference)> Of(SetScore score, Baseline? baseline)
    {
        yield return ("found, 4 to 6 px", Text(score.BySize(4, 6)), Counted(baseline, "4-6"));
        yield return ("found, 6 to 10 px", Text(score.BySize(6, 10)), Counted(baseline, "6-10"));
        yield return ("found, 10 px and more", Text(score.BySize(10, 1e9)), Counted(baseline, "10+"));
        yield return ("recall, 6 px and more", Share(score.BySize(6, 1e9)),
            baseline is null ? "" : Share(baseline.Sum("6-10", "10+")));
        foreach (string kind in Kinds)
            yield return (kind + "s found", Text(score.ByKind(kind)), Counted(baseline, kind));
        yield return ("false alarms per frame", Number(score.FalseAlarmsPerFrame),
            baseline is null ? "" : Number(baseline.FalseAlarmsPerFrame));
        yield return ("targets reported twice", score.Duplicates.ToString(CultureInfo.InvariantCulture), "");
        yield return ("centroid RMS, clear panels, px", Number(score.ClearPanelRms),
            baseline is null ? "" : Number(baseline.ClearPanelRms));
        yield return ("centroid RMS, all found, px", Number(score.Rms()), "");
        yield return ("NEES, in 95 % ellipse: clear", Text(score.ClearErrors), "");
        yield return ("  overexposed", Text(score.ClippedErrors), "");
        yield return ("  hidden or cut", Text(score.PartialErrors), "");
        if (score.Markers.Of + score.Markers.Wrong == 0)
            yield break;
        foreach ((string Name, string Value, string Reference) row in score.Markers.Rows(baseline?.Markers))
            yield return row;
    }

    private static string Counted(Baseline? baseline, string what) => baseline?.Count(what) ?? "";

    private static string Text((int Found, int Of) count) => count.Of == 0 ? "-" : $"{count.Found}/{count.Of}";

    private static string Share((int Found, int Of) count)
        => count.Of == 0 ? "-" : ((double)count.Found / count.Of).ToString("0.000", CultureInfo.InvariantCulture);

    private static string Text((double Mean, double Inside, int Count) errors) => errors.Count == 0
        ? "-"
        : FormattableString.Invariant($"{errors.Mean:0.00} {100 * errors.Inside:0.0} % of {errors.Count}");

    private static string Number(double value)
        => double.IsNaN(value) ? "-" : value.ToString("0.00", CultureInfo.InvariantCulture);
}
