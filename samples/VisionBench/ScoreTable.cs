using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace VisionBench;

/// <summary>The figures as text.</summary>
internal static class ScoreTable
{
    private const double FarOffPixels = 1;

    // Of a chi-square distribution with two degrees of freedom.
    private const double Ellipse99 = 9.21;

    public static void Write(SetScore score, Baseline? baseline, TextWriter output)
    {
        output.WriteLine($"{score.Name}, {score.Frames} frames");
        output.WriteLine($"  {"",-34}{"this",14}{(baseline is null ? "" : "OpenCV"),14}".TrimEnd());
        foreach ((string name, string value, string reference) in ScoreRows.Of(score, baseline))
            output.WriteLine($"  {name,-34}{value,14}{reference,14}".TrimEnd());
        if (score.FalseAlarmsOn.Count > 0)
            output.WriteLine(
                "  false alarms on: " + string.Join(", ", score.FalseAlarmsOn.Select(a => $"{a.On} {a.Count}")));
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
        }
    }

    private static bool IsFarOff(TargetMatch match)
        => match.Error > FarOffPixels || match.NormalisedErrorSquared > Ellipse99;
}
