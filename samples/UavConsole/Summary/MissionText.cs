using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>Writes what a mission came to, for people.</summary>
internal sealed class MissionText(TextWriter output, RunSummary summary, MissionOutcome outcome)
{
    // The verdict last: there a person looks first.
    public void Write()
    {
        WriteManagers();
        WriteDecisions();
        if (outcome.Score is { } score)
            WriteScore(score);
        else
            WriteTracks();
        WriteFlight();
        Line($"mission {outcome.Plan?.Name ?? "without a plan"}: {(outcome.HasPassed ? "ACCOMPLISHED" : "FAILED")}");
        foreach (string failure in outcome.Failures)
            Line("  failed: " + failure);
        if (outcome is { Aborted: { } why, Score: not null })
            Line("  given up before its end: " + why);
    }

    private void WriteFlight()
    {
        Line($"phase at the end: {PhaseStyle.Name(outcome.Phase)}{(summary.Record.Mission.Text is { } text ? ", " + text : string.Empty)}");
        Line(string.Format(
            CultureInfo.InvariantCulture,
            "coverage {0} %, path {1} m, time {2} s, battery used {3} %, landed {4}",
            Figures.Of(outcome.CoveragePercent, "0.0"),
            Figures.Of(outcome.FlownMetres, "0"),
            Figures.Of(outcome.FlightTime.TotalSeconds, "0.0"),
            Figures.Of(outcome.BatteryUsedPercent, "0.0"),
            outcome.HasLanded ? Figures.Of(outcome.DistanceFromHomeMetres, "0.00") + " m from home" : "not"));
    }

    private void WriteScore(MissionScore score)
    {
        Line($"targets: {Figures.Of(score.Found)} of {Figures.Of(score.Targets.Count)} found, {Figures.Of(score.FalseTracks.Count)} false; "
            + $"error {Figures.Of(score.RmseMetres, "0.00")} m RMS; {Figures.Of(score.InEllipse)} in their 95 % ellipse");
        foreach (TargetScore target in score.Targets)
        {
            string name = $"  {target.Target.Name,-8} {Colours.Name(target.Target.Class),-8} ";
            Line(name + (target.Track is not { } track
                ? "MISSED"
                : $"found, error {Figures.Of(target.ErrorMetres, "0.00")} m, 95 % ellipse {Ellipse(track)} {(target.EllipseHoldsTruth ? "holds it" : "DOES NOT HOLD IT")}, track {Figures.Of(track.Id)}, {Figures.Of(track.Reports)} reports"));
        }

        foreach (TargetTrack track in score.FalseTracks)
            Line($"  FALSE    {Describe(track)}");
    }

    private void WriteTracks()
    {
        TargetTrack[] tracks = summary.Record.Tracks.Confirmed.ToArray();
        Line($"targets: {Figures.Of(tracks.Length)} confirmed; nobody knows where they really are");
        foreach (TargetTrack track in tracks)
            Line("  " + Describe(track));
    }

    private void WriteDecisions()
    {
        Line("decisions:");
        foreach (PhaseChange change in summary.Record.Phases)
            Line(Text.At(change.Time) + Describe(change));
        IEnumerable<HealthChange> asked = summary.Record.HealthChanges.Where(c => c.Report.Advice != HealthAdvice.None);
        foreach (HealthChange change in asked)
            Line($"{Text.At(change.Time)}health asks for {change.Report.Advice}: {Text.Health(change.Report)}");
    }

    // A text that names its phase itself is not given the name twice.
    private static string Describe(PhaseChange change)
    {
        string name = PhaseStyle.Name(change.Phase);
        if (change.Text is not { } text)
            return name;
        return text.StartsWith(name + ": ", StringComparison.Ordinal) ? text : $"{name}: {text}";
    }

    private void WriteManagers()
    {
        foreach (ManagerFigures manager in summary.Managers)
        {
            Line(string.Format(
                CultureInfo.InvariantCulture,
                "work of {0}: {1} runs, mean {2:0.000} ms, longest {3:0.0} ms, {4:0.00} s in all",
                manager.Name,
                manager.Runs,
                manager.MeanWork.TotalMilliseconds,
                manager.LongestWork.TotalMilliseconds,
                manager.TotalWork.TotalSeconds));
        }
    }

    private static string Describe(TargetTrack track)
        => $"{Colours.Name(track.Class),-8} track {Figures.Of(track.Id)} at {Figures.Degrees(track.Position.Latitude)} {Figures.Degrees(track.Position.Longitude)}, "
            + $"95 % ellipse {Ellipse(track)}, {Figures.Of(track.Reports)} reports";

    private static string Ellipse(TargetTrack track)
        => $"{Figures.Of(track.Covariance.HalfMajorAxis95Metres, "0.0")} x {Figures.Of(track.Covariance.HalfMinorAxis95Metres, "0.0")} m";

    private void Line(string text) => output.WriteLine(Text.Printable(text));
}
