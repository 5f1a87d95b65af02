using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>Writes what a mission came to, for programs; docs/uavconsole-summary.md tells the fields.</summary>
internal static class MissionJson
{

    public static void Write(Utf8JsonWriter json, RunSummary summary, MissionOutcome outcome)
    {
        json.WriteStartObject("mission");
        WriteOutcome(json, summary, outcome);
        WriteScore(json, outcome.Score);
        WriteTracks(json, summary.Record.Tracks.Tracks);
        WritePhases(json, summary.Record.Phases);
        WriteHealth(json, summary.Record.HealthChanges);
        WriteImaging(json, summary.Record.Imaging);
        WriteManagers(json, summary.Managers);
        json.WriteEndObject();
    }

    private static void WriteOutcome(Utf8JsonWriter json, RunSummary summary, MissionOutcome outcome)
    {
        json.WriteString("name", outcome.Plan?.Name);
        json.WriteString("command_line", summary.Options.CommandLine);
        if (summary.Options.IsSimulated)
            json.WriteNumber("seed", summary.Options.Seed);
        else
            json.WriteNull("seed");
        json.WriteBoolean("passed", outcome.HasPassed);
        json.WriteStartArray("failures");
        foreach (string failure in outcome.Failures)
            json.WriteStringValue(failure);
        json.WriteEndArray();
        json.WriteString("phase", outcome.Phase.ToString());
        json.WriteString("aborted", outcome.Aborted);
        WriteNumber(json, "coverage_percent", outcome.CoveragePercent);
        WriteNumber(json, "path_m", outcome.FlownMetres);
        WriteNumber(json, "flight_time_s", outcome.FlightTime.TotalSeconds);
        WriteNumber(json, "run_time_s", summary.Result.Duration.TotalSeconds);
        WriteNumber(json, "battery_used_percent", outcome.BatteryUsedPercent);
        json.WriteBoolean("landed", outcome.HasLanded);
        WriteNumber(json, "from_home_m", outcome.DistanceFromHomeMetres);
        WriteNumber(json, "outside_fence_m", outcome.OutsideFenceMetres);
        json.WriteNumber("lanes_flown", summary.Record.Mission.LanesFlown);
        json.WriteNumber("second_looks", summary.Record.Mission.Revisits);
    }

    private static void WriteScore(Utf8JsonWriter json, MissionScore? score)
    {
        if (score is null)
        {
            json.WriteNull("score");
            return;
        }

        json.WriteStartObject("score");
        json.WriteNumber("targets", score.Targets.Count);
        json.WriteNumber("found", score.Found);
        json.WriteNumber("false", score.FalseTracks.Count);
        WriteNumber(json, "rmse_m", score.RmseMetres);
        json.WriteNumber("in_ellipse", score.InEllipse);
        json.WriteStartArray("false_track_ids");
        foreach (TargetTrack track in score.FalseTracks)
            json.WriteNumberValue(track.Id);
        json.WriteEndArray();
        json.WriteEndObject();

        json.WriteStartArray("targets");
        foreach (TargetScore target in score.Targets)
            WriteTarget(json, target);
        json.WriteEndArray();
    }

    private static void WriteTarget(Utf8JsonWriter json, TargetScore target)
    {
        json.WriteStartObject();
        json.WriteString("name", target.Target.Name);
        json.WriteString("class", Colours.Name(target.Target.Class));
        WritePosition(json, target.Target.Position);
        json.WriteBoolean("found", target.IsFound);
        if (target.Track is { } track)
        {
            json.WriteNumber("track_id", track.Id);
            WriteNumber(json, "error_m", target.ErrorMetres);
            WriteNumber(json, "error_north_m", target.ErrorNorthMetres);
            WriteNumber(json, "error_east_m", target.ErrorEastMetres);
            WriteEllipse(json, track.Covariance);
            json.WriteBoolean("ellipse_holds_truth", target.EllipseHoldsTruth);
        }

        json.WriteEndObject();
    }

    private static void WriteTracks(Utf8JsonWriter json, IEnumerable<TargetTrack> tracks)
    {
        json.WriteStartArray("tracks");
        foreach (TargetTrack track in tracks.Where(t => t.State != TrackState.Tentative))
        {
            json.WriteStartObject();
            json.WriteNumber("id", track.Id);
            json.WriteString("state", track.State.ToString());
            json.WriteString("class", Colours.Name(track.Class));
            WritePosition(json, track.Position);
            WriteEllipse(json, track.Covariance);
            json.WriteNumber("reports", track.Reports);
            json.WriteNumber("misses", track.Misses);
            WriteNumber(json, "first_seen_s", track.FirstSeen.TotalSeconds);
            WriteNumber(json, "last_seen_s", track.LastSeen.TotalSeconds);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WritePhases(Utf8JsonWriter json, IEnumerable<PhaseChange> phases)
    {
        json.WriteStartArray("phases");
        foreach (PhaseChange change in phases)
        {
            json.WriteStartObject();
            WriteNumber(json, "t_s", change.Time.TotalSeconds);
            json.WriteString("phase", change.Phase.ToString());
            json.WriteString("text", change.Text);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteHealth(Utf8JsonWriter json, IEnumerable<HealthChange> changes)
    {
        json.WriteStartArray("health_changes");
        foreach (HealthChange change in changes)
        {
            json.WriteStartObject();
            WriteNumber(json, "t_s", change.Time.TotalSeconds);
            json.WriteString("level", change.Report.Level.ToString());
            json.WriteString("reasons", change.Report.Reasons.ToString());
            json.WriteString("advice", change.Report.Advice.ToString());
            json.WriteString("text", change.Report.Text);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteImaging(Utf8JsonWriter json, in ImagingStatus imaging)
    {
        json.WriteStartObject("imaging");
        json.WriteNumber("frames", imaging.Frames);
        json.WriteNumber("observations", imaging.Observations);
        json.WriteNumber("frames_dropped", imaging.FramesDropped);
        json.WriteNumber("frames_refused", imaging.FramesRefused);
        json.WriteNumber("reports", imaging.Reports);
        json.WriteNumber("detector_failures", imaging.DetectorFailures);
        json.WriteNumber("detections_refused", imaging.DetectionsRefused);
        json.WriteNumber("detector_overruns", imaging.DetectorOverruns);
        json.WriteString("fault", imaging.Fault);
        json.WriteEndObject();
    }

    private static void WriteManagers(Utf8JsonWriter json, IEnumerable<ManagerFigures> managers)
    {
        json.WriteStartArray("managers");
        foreach (ManagerFigures manager in managers)
        {
            json.WriteStartObject();
            json.WriteString("name", manager.Name);
            json.WriteString("outcome", manager.Outcome);
            json.WriteNumber("runs", manager.Runs);
            WriteNumber(json, "work_mean_ms", manager.MeanWork.TotalMilliseconds);
            WriteNumber(json, "work_max_ms", manager.LongestWork.TotalMilliseconds);
            WriteNumber(json, "work_total_s", manager.TotalWork.TotalSeconds);
            json.WriteNumber("faults", manager.Faults);
            json.WriteString("first_fault", manager.FirstFault);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WritePosition(Utf8JsonWriter json, GeodeticPosition position)
    {
        WriteNumber(json, "lat_deg", position.Latitude.Degrees, 9);
        WriteNumber(json, "lon_deg", position.Longitude.Degrees, 9);
    }

    private static void WriteEllipse(Utf8JsonWriter json, in HorizontalCovariance covariance)
    {
        WriteNumber(json, "ellipse_95_major_m", covariance.HalfMajorAxis95Metres);
        WriteNumber(json, "ellipse_95_minor_m", covariance.HalfMinorAxis95Metres);
        WriteNumber(json, "ellipse_major_axis_deg", covariance.MajorAxis.Degrees);
    }

    // JSON has no NaN. Rounded, so that runtimes that print differently give the same text.
    private static void WriteNumber(Utf8JsonWriter json, string name, double value, int decimals = 4)
    {
        if (!(Math.Abs(value) < 1e15))
            json.WriteNull(name);
        else
            json.WriteNumber(name, (decimal)Math.Round(value, decimals));
    }
}
