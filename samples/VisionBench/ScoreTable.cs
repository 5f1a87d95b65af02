using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Vision;

namespace VisionBench;

/// <summary>The figures as text.</summary>
internal static class ScoreTable
{
    private const double FarOffPixels = 1;

    // Of a chi-square distribution with two degrees of freedom.
    private const double Ellipse99 = 9.21;

    public static void Write(SetScore score, Baseline? baseline, TextWriter output)
    {
        Write($"{score.Name}, {score.Frames} frames", ScoreRows.Of(score, baseline), baseline is not null, output);
        if (score.FalseAlarmsOn.Count > 0)
            output.WriteLine(
                "  false alarms on: " + string.Join(", ", score.FalseAlarmsOn.Select(a => $"{a.On} {a.Count}")));
    }

    public static void Write(
        string title, IEnumerable<(string Name, string Value, string Reference)> rows, bool hasReference,
        TextWriter output)
    {
        output.WriteLine(title);
        output.WriteLine($"  {"",-34}{"this",14}{(hasReference ? "OpenCV" : ""),14}".TrimEnd());
        foreach ((string name, string value, string reference) in rows)
            output.WriteLine($"  {name,-34}{value,14}{reference,14}".TrimEnd());
    }

    /// <summary>Each marker that was missed, of which a corner is far off, and each wrong id.</summary>
    public static void List(MarkerScore score, TextWriter output)
    {
        string name = score.Picture.Name;
        foreach (MarkerMatch match in score.Matches)
        {
            if (match.Found is null)
                output.WriteLine($"  {name} missed {match.Marker.Describe()}");
            else if (match.CornerErrors.Max() > FarOffPixels)
                output.WriteLine($"  {name} off {match.Marker.Describe()}: "
                    + FormattableString.Invariant($"corner {match.CornerErrors.Max():0.00} px"));
        }

        foreach (DetectedMarker wrong in score.Wrong)
            output.WriteLine($"  {name} false {MarkerScore.Describe(wrong)}");
    }

    /// <summary>Each miss, each centre that is far off, and each false alarm.</summary>
    public static void List(IEnumerable<FrameScore> scores, TextWriter output)
    {
        foreach (FrameScore score in scores)
        {
            foreach (TargetMatch match in score.Matches.Where(m => m.Found is null))
                output.WriteLine($"  {score.Frame.Name} missed {match.Target.Describe()}");
            foreach (TargetMatch match in score.Matches.Where(IsFarOff))
            {
                output.WriteLine(
                    $"  {score.Frame.Name} off {match.Target.Describe()}: "
                    + FormattableString.Invariant($"{match.Error:0.00} px, NEES {match.NormalisedErrorSquared:0.0}"));
            }

            foreach (FalseAlarm alarm in score.FalseAlarms)
                output.WriteLine($"  {score.Frame.Name} false {alarm.Describe()}");
            if (score.Markers is { } markers)
                List(markers, output);
        }
    }

    private static bool IsFarOff(TargetMatch match)
        => match.Error > FarOffPixels || match.NormalisedErrorSquared > Ellipse99;
}
