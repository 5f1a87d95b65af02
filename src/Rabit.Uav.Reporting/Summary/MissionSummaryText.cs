using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>Writes the result of a mission for people.</summary>
internal sealed class MissionSummaryText(TextWriter output, FlightSummary summary, MissionSummary mission)
{
    /// <summary>What a reader of a file must not miss, each in a line of its own.</summary>
    public void WriteHeadlines()
    {
        foreach (string headline in mission.Headlines)
            Line("ATTENTION: " + headline);
    }

    // The verdict last: in a terminal that is what one sees first.
    public void Write()
    {
        WriteManagers();
        WriteDecisions();
        if (mission.Score is { } score)
            WriteScore(score);
        else
            WriteTracks();
        WriteOperatorDecisions();
        WriteFlight();
        bool hasFlown = summary.Record.Mission.Result.HasFlown;
        string title = mission.Plan is { } plan ? $"mission {plan.Name}"
            : (hasFlown ? "flown without a plan" : "mission not started") + WaitedFor();
        Line($"{title}: {(mission.HasPassed ? "ACCOMPLISHED" : "FAILED")}");
        foreach (string failure in mission.Failures)
            Line("  failed: " + failure);
        foreach (string headline in mission.Remarks)
            Line("  " + headline);
        if (mission is { Aborted: { } why, Score: not null })
            Line("  given up before its end: " + why);
    }

    // Mission Control plans when the vehicle is ready; before that its text says what it waits for, or has waited for.
    private string WaitedFor() => mission.Text is { } text ? $" ({text})" : string.Empty;

    private string? StopText() => mission.StopResult switch
    {
        MissionStopResult.Held => "it holds its position, accepted by the autopilot",
        MissionStopResult.Returning => "it returns to launch, accepted by the autopilot",
        MissionStopResult.NotVerified or MissionStopResult.InProgress =>
            "IN THE AIR, and whether it holds or returns is NOT KNOWN",
        _ => null,
    };

    private void WriteFlight()
    {
        Line("phase at the end: "
            + $"{FlightText.Phase(mission.Phase)}{(mission.Text is { } text ? ", " + text : string.Empty)}");
        if (StopText() is { } stop)
            Line("vehicle at the stop of the program: " + stop);
        Line(string.Format(
            CultureInfo.InvariantCulture,
            "coverage {0} %, path {1} m, motors on for {2} s, battery used {3} %, landed {4}",
            FlightText.Number(mission.CoveragePercent, "0.0"),
            FlightText.Number(mission.FlownMetres, "0"),
            FlightText.Number(mission.FlightTime.TotalSeconds, "0.0"),
            FlightText.Number(mission.BatteryUsedPercent, "0.0"),
            mission.HasLanded ? FlightText.Number(mission.DistanceFromHomeMetres, "0.00") + " m from home" : "not"));
        if (mission.Energy is { IsKnown: true } energy)
            WriteEnergy(energy);
    }

    private void WriteEnergy(in EnergyStatus energy)
        => Line(string.Format(
            CultureInfo.InvariantCulture,
            "energy: {0} % left (+- {1} %) of a battery with {2} % of its stated capacity (+- {3} %)",
            FlightText.Number(energy.ChargeLeft * 100, "0"),
            FlightText.Number(energy.ChargeLeftDeviation * 100, "0"),
            FlightText.Number(energy.CapacityFraction * 100, "0"),
            FlightText.Number(energy.CapacityFractionDeviation * 100, "0")));

    private void WriteScore(MissionScore score)
    {
        Line($"targets: {FlightText.Number(score.Found)} of {FlightText.Number(score.Targets.Count)} found, "
            + $"{FlightText.Number(score.FalseTracks.Count)} false{FlightText.RejectedTracks(score)}"
            + $"{FlightText.IdentitySwitches(score)}; "
            + (double.IsNaN(score.RmseMetres)
                ? string.Empty
                : $"error {FlightText.Number(score.RmseMetres, "0.00")} m RMS; ")
            + $"{FlightText.Number(score.InEllipse)} in their 95 % ellipse");
        foreach (TargetScore target in score.Targets)
        {
            string name = $"  {target.Name,-8} {TargetClassNames.Name(target.Class),-8} ";
            Line(name + (target.Track is not { } track
                ? "MISSED"
                : $"found, error {FlightText.Number(target.ErrorMetres, "0.00")} m, 95 % ellipse {Ellipse(track)} "
                    + $"{(target.EllipseContainsTruth ? "contains it" : "DOES NOT CONTAIN IT")}, track "
                    + $"{FlightText.Number(track.Id)}, {FlightText.Number(track.Reports)} reports{Bearing(track)}{Motion(track)}"));
        }

        foreach (TargetTrack track in score.FalseTracks)
            Line($"  FALSE    {Describe(track)}");
    }

    private void WriteTracks()
    {
        TargetTrack[] tracks = summary.Record.Tracks.Confirmed.ToArray();
        Line($"targets: {FlightText.Number(tracks.Length)} confirmed; their true positions are not known");
        foreach (TargetTrack track in tracks)
            Line("  " + Describe(track));
    }

    private void WriteOperatorDecisions()
    {
        foreach (TargetTrack track in summary.Record.Tracks.Tracks.Where(t => t.Decision != TargetDecision.None))
            Line($"  {track.Decision.ToString().ToLowerInvariant()} by the operator: {Describe(track)}");
    }

    private void WriteDecisions()
    {
        Line("decisions:");
        foreach (PhaseChange change in summary.Record.Phases)
            Line(FlightText.TimeStamp(change.Time) + Describe(change));
        IEnumerable<HealthChange> asked = summary.Record.HealthChanges.Where(c => c.Report.Advice != HealthAdvice.None);
        foreach (HealthChange change in asked)
            Line($"{FlightText.TimeStamp(change.Time)}health asks for {change.Report.Advice}: "
                + $"{FlightText.Health(change.Report)}");
    }

    // A text that names its phase itself is not given the name twice.
    private static string Describe(PhaseChange change)
    {
        string name = FlightText.Phase(change.Phase);
        if (change.Text is not { } text)
            return name;
        return text.StartsWith(name + ": ", StringComparison.Ordinal) ? text : $"{name}: {text}";
    }

    private void WriteManagers()
    {
        foreach (ManagerSummary manager in summary.Managers)
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
        => $"{TargetClassNames.Name(track.Class),-8} track {FlightText.Number(track.Id)} at "
            + $"{FlightText.Degrees(track.Position.Latitude.Radians)} "
            + $"{FlightText.Degrees(track.Position.Longitude.Radians)}, "
            + $"95 % ellipse {Ellipse(track)}, {FlightText.Number(track.Reports)} reports{Bearing(track)}{Motion(track)}";

    private static string Bearing(TargetTrack track)
        => track.Bearing is { } bearing ? $", bearing {FlightText.Bearing(bearing)}" : string.Empty;

    private static string Motion(TargetTrack track) => track.Motion == TargetMotion.Standing
        ? string.Empty
        : $", {FlightText.Number(track.VelocityNed.HorizontalLength, "0.0")} m/s when last seen at "
            + FlightText.Clock(track.LastSeen);

    private static string Ellipse(TargetTrack track)
        => $"{FlightText.Number(track.Covariance.HalfMajorAxis95Metres, "0.0")} x "
            + $"{FlightText.Number(track.Covariance.HalfMinorAxis95Metres, "0.0")} m";

    private void Line(string text) => output.WriteLine(FlightText.Printable(text));
}
