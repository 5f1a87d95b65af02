using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace VisionBench;

/// <summary>The figures as text.</summary>
internal static class ScoreTable
{
    public static void Write(SetScore score, Baseline? baseline, TextWriter output)
    {
        output.WriteLine($"{score.Name}, {score.Frames} frames");
        output.WriteLine($"  {"",-34}{"this",14}{"OpenCV",14}");
        Row(output, "found, 4 to 6 px", Text(score.BySize(4, 6)), baseline?.Count("4-6"));
        Row(output, "found, 6 to 10 px", Text(score.BySize(6, 10)), baseline?.Count("6-10"));
        Row(output, "found, 10 px and more", Text(score.BySize(10, 1e9)), baseline?.Count("10+"));
        (int found, int of) = score.BySize(6, 1e9);
        Row(output, "recall, 6 px and more", Number((double)found / of, "0.000"), null);
        foreach (string kind in (string[])["panel", "person", "vehicle"])
            Row(output, kind + "s found", Text(score.ByKind(kind)), baseline?.Count(kind));
        Row(output, "false alarms per frame", Number(score.FalseAlarmsPerFrame, "0.00"),
            baseline is null ? null : Number(baseline.FalseAlarmsPerFrame, "0.00"));
        Row(output, "targets reported twice", score.Duplicates.ToString(CultureInfo.InvariantCulture), null);
        Row(output, "centroid RMS, clear panels, px", Number(score.ClearPanelRms, "0.00"),
            baseline is null ? null : Number(baseline.ClearPanelRms, "0.00"));
        Row(output, "centroid RMS, all found, px", Number(score.Rms(), "0.00"), null);
        Row(output, "NEES, in 95 % ellipse: clear", Text(score.ClearErrors), null);
        Row(output, "  overexposed", Text(score.ClippedErrors), null);
        Row(output, "  hidden or cut", Text(score.PartialErrors), null);
        if (score.FalseAlarmsOn.Count > 0)
            output.WriteLine(
                "  false alarms on: " + string.Join(", ", score.FalseAlarmsOn.Select(a => $"{a.On} {a.Count}")));
    }

    /// <summary>Each miss and each false alarm.</summary>
    public static void List(IEnumerable<FrameScore> scores, TextWriter output)
    {
        foreach (FrameScore score in scores)
        {
            foreach (TargetMatch match in score.Matches.Where(m => m.Found is null))
                output.WriteLine(FormattableString.Invariant(
                    $"  {score.Frame.Name} missed {match.Target.Class} {match.Target.Shape} {match.Target.Size:0.0} px at {match.Target.X:0.0}, {match.Target.Y:0.0}, {match.Target.FractionVisible:0.00} visible"));
            foreach (FalseAlarm alarm in score.FalseAlarms)
                output.WriteLine(FormattableString.Invariant(
                    $"  {score.Frame.Name} false {alarm.Detection.Class} {alarm.Detection.Score:0.00} on {alarm.On} at {alarm.Detection.CentreX:0.0}, {alarm.Detection.CentreY:0.0}, {alarm.Detection.SideMetres:0.00} m"));
        }
    }

    private static void Row(TextWriter output, string name, string value, string? reference)
        => output.WriteLine($"  {name,-34}{value,14}{reference ?? "",14}");

    private static string Text((int Found, int Of) count) => count.Of == 0 ? "-" : $"{count.Found}/{count.Of}";

    private static string Text((double Mean, double Inside, int Count) errors) => errors.Count == 0
        ? "-"
        : FormattableString.Invariant($"{errors.Mean:0.00} {100 * errors.Inside:0} % of {errors.Count}");

    private static string Number(double value, string format)
        => double.IsNaN(value) ? "-" : value.ToString(format, CultureInfo.InvariantCulture);
}
