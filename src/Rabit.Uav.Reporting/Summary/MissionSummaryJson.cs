using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>Writes the result of a mission for programs; docs/uavconsole-summary.md describes the fields.</summary>
internal static class MissionSummaryJson
{
    public static void Write(Utf8JsonWriter json, FlightSummary summary, MissionSummary mission)
    {
        json.WriteStartObject("mission");
        WriteResult(json, summary, mission);
        WriteScore(json, mission.Score);
        WriteTracks(json, summary.Record.Tracks.Tracks);
        WritePhases(json, summary.Record.Phases);
        WriteHealth(json, summary.Record.HealthChanges);
        WriteImaging(json, summary.Record.Imaging);
        WriteManagers(json, summary.Managers);
        json.WriteEndObject();
    }

    private static void WriteResult(Utf8JsonWriter json, FlightSummary summary, MissionSummary mission)
    {
        json.WriteString("name", mission.Plan?.Name);
        json.WriteString("commandLine", summary.CommandLine);
        if (summary.Seed is { } seed)
            json.WriteNumber("seed", seed);
        else
            json.WriteNull("seed");
        json.WriteBoolean("passed", mission.HasPassed);
        json.WriteStartArray("failures");
        foreach (string failure in mission.Failures)
            json.WriteStringValue(failure);
        json.WriteEndArray();
        json.WriteStartArray("headlines");
        foreach (string headline in mission.Headlines)
            json.WriteStringValue(headline);
        json.WriteEndArray();
        json.WriteString("phase", mission.Phase.ToString());
        json.WriteString("aborted", mission.Aborted);
        json.WriteString("stopResult", mission.StopResult.ToString());
        WriteNumber(json, "coveragePercent", mission.CoveragePercent);
        WriteNumber(json, "requiredCoveragePercent", mission.RequiredCoveragePercent);
        WriteNumber(json, "pathMetres", mission.FlownMetres);
        WriteNumber(json, "flightTimeSeconds", mission.FlightTime.TotalSeconds);
        WriteNumber(json, "runTimeSeconds", summary.RunTime.TotalSeconds);
        WriteNumber(json, "batteryUsedPercent", mission.BatteryUsedPercent);
        WriteEnergy(json, mission.Energy);
        json.WriteBoolean("landed", mission.HasLanded);
        WriteNumber(json, "distanceFromHomeMetres", mission.DistanceFromHomeMetres);
        WriteNumber(json, "outsideFenceMetres", mission.OutsideFenceMetres);
        json.WriteNumber("lanesFlown", mission.LanesFlown);
        json.WriteNumber("revisits", mission.Revisits);
    }

    private static void WriteEnergy(Utf8JsonWriter json, in EnergyStatus energy)
    {
        if (!energy.IsKnown)
        {
            json.WriteNull("energy");
            return;
        }

        json.WriteStartObject("energy");
        WriteNumber(json, "leftPercent", energy.ChargeLeft * 100);
        WriteNumber(json, "leftDeviationPercent", energy.ChargeLeftDeviation * 100);
        WriteNumber(json, "wayHomePercent", energy.ChargeHome * 100);
        WriteNumber(json, "reservePercent", energy.Reserve * 100);
        WriteNumber(json, "capacityPercent", energy.CapacityFraction * 100);
        WriteNumber(json, "capacityDeviationPercent", energy.CapacityFractionDeviation * 100);
        WriteNumber(json, "planPercent", energy.PlanCharge * 100);
        WriteNumber(json, "planSeconds", energy.PlanTime.TotalSeconds);
        json.WriteBoolean("windMeasured", energy.IsWindMeasured);
        json.WriteEndObject();
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
        json.WriteNumber("identitySwitches", score.IdentitySwitches);
        WriteNumber(json, "rmseMetres", score.RmseMetres);
        json.WriteNumber("inEllipse", score.InEllipse);
        json.WriteStartArray("falseTrackIds");
        foreach (TargetTrack track in score.FalseTracks)
            json.WriteNumberValue(track.Id);
        json.WriteEndArray();
        json.WriteStartArray("rejectedTrackIds");
        foreach (TargetTrack track in score.RejectedTracks)
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
        json.WriteString("name", target.Name);
        json.WriteString("class", TargetClassNames.Name(target.Class));
        WritePosition(json, target.Position);
        json.WriteBoolean("found", target.IsFound);
        json.WriteBoolean("rejected", target.IsRejected);
        if (target.Track is { } track)
        {
            json.WriteNumber("trackId", track.Id);
            WriteNumber(json, "errorMetres", target.ErrorMetres);
            WriteNumber(json, "errorNorthMetres", target.ErrorNorthMetres);
            WriteNumber(json, "errorEastMetres", target.ErrorEastMetres);
            WriteEllipse(json, track.Covariance);
            json.WriteBoolean("ellipseContainsTruth", target.EllipseContainsTruth);
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
            json.WriteString("decision", track.Decision.ToString());
            json.WriteString("class", TargetClassNames.Name(track.Class));
            WritePosition(json, track.Position);
            WriteEllipse(json, track.Covariance);
            WriteBearing(json, track.Bearing);
            json.WriteNumber("reports", track.Reports);
            json.WriteNumber("misses", track.Misses);
            WriteNumber(json, "firstSeenSeconds", track.FirstSeen.TotalSeconds);
            WriteNumber(json, "lastSeenSeconds", track.LastSeen.TotalSeconds);
            if (track.Motion != TargetMotion.Standing)
            {
                json.WriteString("motion", track.Motion.ToString());
                WriteNumber(json, "northMetresPerSecond", track.VelocityNed.North);
                WriteNumber(json, "eastMetresPerSecond", track.VelocityNed.East);
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteBearing(Utf8JsonWriter json, TargetBearing? bearing)
    {
        WriteNumber(json, "bearingDegrees", bearing?.Angle.Degrees ?? double.NaN, 2);
        WriteNumber(json, "bearingDeviationDegrees", bearing?.TotalSigma.Degrees ?? double.NaN, 2);
        if (bearing is { } known)
            json.WriteString("bearingSymmetry", known.Symmetry.ToString());
        else
            json.WriteNull("bearingSymmetry");
    }

    private static void WritePhases(Utf8JsonWriter json, IEnumerable<PhaseChange> phases)
    {
        json.WriteStartArray("phases");
        foreach (PhaseChange change in phases)
        {
            json.WriteStartObject();
            WriteNumber(json, "timeSeconds", change.Time.TotalSeconds);
            json.WriteString("phase", change.Phase.ToString());
            json.WriteString("text", change.Text);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteHealth(Utf8JsonWriter json, IEnumerable<HealthChange> changes)
    {
        json.WriteStartArray("healthChanges");
        foreach (HealthChange change in changes)
        {
            json.WriteStartObject();
            WriteNumber(json, "timeSeconds", change.Time.TotalSeconds);
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
        json.WriteNumber("framesDropped", imaging.FramesDropped);
        json.WriteNumber("framesRefused", imaging.FramesRefused);
        WritePictures(json, imaging.Pictures);
        json.WriteNumber("reports", imaging.Reports);
        json.WriteNumber("detectorFailures", imaging.DetectorFailures);
        json.WriteNumber("detectionsRefused", imaging.DetectionsRefused);
        json.WriteNumber("detectionsCut", imaging.DetectionsCut);
        json.WriteNumber("detectorOverruns", imaging.DetectorOverruns);
        json.WriteString("fault", imaging.Fault);
        json.WriteEndObject();
    }

    // By quality, those that there were.
    private static void WritePictures(Utf8JsonWriter json, in PictureCounts pictures)
    {
        json.WriteStartObject("pictures");
        for (PictureQuality quality = PictureQuality.Usable; quality <= PictureQuality.MotionBlurred; quality++)
        {
            if (pictures.Of(quality) > 0 || quality == PictureQuality.Usable)
                json.WriteNumber(JsonNamingPolicy.CamelCase.ConvertName(quality.ToString()), pictures.Of(quality));
        }

        json.WriteEndObject();
    }

    private static void WriteManagers(Utf8JsonWriter json, IEnumerable<ManagerSummary> managers)
    {
        json.WriteStartArray("managers");
        foreach (ManagerSummary manager in managers)
        {
            json.WriteStartObject();
            json.WriteString("name", manager.Name);
            json.WriteString("outcome", manager.Outcome);
            json.WriteNumber("runs", manager.Runs);
            WriteNumber(json, "workMeanMilliseconds", manager.MeanWork.TotalMilliseconds);
            WriteNumber(json, "workMaxMilliseconds", manager.LongestWork.TotalMilliseconds);
            WriteNumber(json, "workTotalSeconds", manager.TotalWork.TotalSeconds);
            json.WriteNumber("faults", manager.Faults);
            json.WriteString("firstFault", manager.FirstFault);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WritePosition(Utf8JsonWriter json, GeodeticPosition position)
    {
        WriteNumber(json, "latitudeDegrees", Angle.FromRadians(position.Latitude.Radians).Degrees, 9);
        WriteNumber(json, "longitudeDegrees", Angle.FromRadians(position.Longitude.Radians).Degrees, 9);
    }

    private static void WriteEllipse(Utf8JsonWriter json, in HorizontalCovariance covariance)
    {
        WriteNumber(json, "ellipse95HalfMajorAxisMetres", covariance.HalfMajorAxis95Metres);
        WriteNumber(json, "ellipse95HalfMinorAxisMetres", covariance.HalfMinorAxis95Metres);
        WriteNumber(json, "ellipseMajorAxisDegrees", Angle.FromRadians(covariance.MajorAxis.Radians).Degrees);
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
