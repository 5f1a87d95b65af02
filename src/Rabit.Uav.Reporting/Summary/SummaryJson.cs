using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Writes the summary of a run for programs: JSON with names in camelCase that spell out the unit.
/// docs/uavconsole-summary.md describes the fields.
/// </summary>
/// <example>
/// <code>
/// using FileStream file = File.Create("summary.json");
/// SummaryJson.Write(file, new FlightSummary(recorder.Record, reactor.Run()));
/// </code>
/// </example>
public static class SummaryJson
{
    /// <summary>Writes the summary.</summary>
    /// <param name="stream">Where to, UTF-8; it is not closed.</param>
    /// <param name="summary">What to write.</param>
    public static void Write(Stream stream, FlightSummary summary)
    {
        if (summary is null)
            throw new ArgumentNullException(nameof(summary));
        using var json = new Utf8JsonWriter(
            stream ?? throw new ArgumentNullException(nameof(stream)), new JsonWriterOptions { Indented = true });
        Write(json, summary);
    }

    private static void Write(Utf8JsonWriter json, FlightSummary summary)
    {
        json.WriteStartObject();
        TelemetryRecord telemetry = summary.Record.Telemetry;
        WriteVehicle(json, telemetry);
        WriteModeChanges(json, telemetry);
        WriteRanges(json, telemetry);
        WriteStatusTexts(json, telemetry);
        WriteAcknowledgements(json, telemetry);
        WriteRecorder(json, telemetry);
        WriteLinks(json, summary);
        WriteCounts(json, "ownFrames", summary.OwnFrames);
        WriteCamera(json, summary.Camera);
        WriteRun(json, summary);
        WriteCircumstances(json, summary);
        if (summary.Mission is { } mission)
            MissionSummaryJson.Write(json, summary, mission);
        else
            json.WriteNull("mission");
        json.WriteEndObject();
    }

    private static void WriteCamera(Utf8JsonWriter json, CameraSummary? camera)
    {
        if (camera is null)
        {
            json.WriteNull("camera");
            return;
        }

        json.WriteStartObject("camera");
        json.WriteString("name", camera.Name);
        json.WriteNumber("taken", camera.Delivered);
        json.WriteNumber("beforeRun", camera.BeforeRun);
        json.WriteNumber("late", camera.Late);
        json.WriteNumber("ahead", camera.Ahead);
        json.WriteNumber("refused", camera.Refused);
        json.WriteNumber("skipped", camera.Skipped);
        json.WriteNumber("withoutBuffer", camera.WithoutBuffer);
        json.WriteNumber("withoutTime", camera.WithoutTime);
        json.WriteString("timeSource", camera.TimeSource);
        json.WriteNumber("restarts", camera.Restarts);
        json.WriteString("lastRefusal", camera.LastRefusal);
        json.WriteEndObject();
    }

    private static void WriteRecorder(Utf8JsonWriter json, TelemetryRecord telemetry)
    {
        json.WriteStartObject("recorder");
        json.WriteNumber("frames", telemetry.Frames);
        json.WriteNumber("framesDropped", telemetry.FramesDropped);
        json.WriteEndObject();
    }

    private static void WriteVehicle(Utf8JsonWriter json, TelemetryRecord telemetry)
    {
        json.WriteString("autopilot", telemetry.Autopilot?.ToString());
        json.WriteString("vehicleType", telemetry.VehicleType?.ToString());
        json.WriteString("firmware", telemetry.Firmware);
        json.WriteNumber("systemId", telemetry.SystemId);
        json.WriteNumber("componentId", telemetry.ComponentId);
        WriteNumberOrNull(json, "firstUtcMicroseconds", telemetry.FirstUtcMicroseconds);
        WriteNumberOrNull(json, "lastUtcMicroseconds", telemetry.LastUtcMicroseconds);
    }

    private static void WriteCircumstances(Utf8JsonWriter json, FlightSummary summary)
    {
        json.WriteString(
            "startTime", summary.StartTime?.ToString("yyyy-MM-dd'T'HH:mm:sszzz", CultureInfo.InvariantCulture));
        json.WriteString("operator", NullIfEmpty(summary.OperatorName));
        json.WriteString("missionFile", NullIfEmpty(summary.MissionFile));
        json.WriteString("missionFileSha256", NullIfEmpty(summary.MissionFileSha256));
    }

    private static string? NullIfEmpty(string text) => text.Length == 0 ? null : text;

    private static void WriteModeChanges(Utf8JsonWriter json, TelemetryRecord telemetry)
    {
        json.WriteStartArray("modeChanges");
        foreach (FlightModeChange change in telemetry.ModeChanges)
        {
            json.WriteStartObject();
            WritePlace(json, change.Link, change.Record, change.UtcMicroseconds);
            json.WriteString("mode", change.Mode);
            json.WriteNumber("customMode", change.CustomMode);
            json.WriteNumber("baseMode", (uint)change.BaseMode);
            json.WriteBoolean("armed", change.IsArmed);
            json.WriteNumber("systemStatus", (int)change.SystemStatus);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteNumber("modeChangesLeftOut", telemetry.ModeChangesLeftOut);
    }

    private static void WriteRanges(Utf8JsonWriter json, TelemetryRecord telemetry)
    {
        json.WriteStartObject("globalPositionInt");
        WriteRange(json, "latitudeDegE7", telemetry.LatitudeDegE7);
        WriteRange(json, "longitudeDegE7", telemetry.LongitudeDegE7);
        WriteRange(json, "altitudeAmslMillimetres", telemetry.AltitudeAmslMillimetres);
        WriteRange(json, "heightAboveHomeMillimetres", telemetry.HeightAboveHomeMillimetres);
        json.WriteEndObject();
    }

    private static void WriteRange(Utf8JsonWriter json, string name, FlightRange? range)
    {
        if (range is not { } known)
        {
            json.WriteNull(name);
            return;
        }

        json.WriteStartObject(name);
        json.WriteNumber("min", known.Minimum);
        json.WriteNumber("max", known.Maximum);
        json.WriteEndObject();
    }

    private static void WriteStatusTexts(Utf8JsonWriter json, TelemetryRecord telemetry)
    {
        json.WriteStartArray("statusTexts");
        foreach (FlightStatusText text in telemetry.StatusTexts)
        {
            json.WriteStartObject();
            WritePlace(json, text.Link, text.Record, text.UtcMicroseconds);
            WriteSource(json, text.SystemId, text.ComponentId);
            json.WriteNumber("severity", (int)text.Severity);
            json.WriteString("text", text.Text);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteNumber("statusTextsLeftOut", telemetry.StatusTextsLeftOut);
    }

    private static void WriteAcknowledgements(Utf8JsonWriter json, TelemetryRecord telemetry)
    {
        json.WriteStartArray("commandAcknowledgements");
        foreach (FlightAcknowledgement ack in telemetry.Acknowledgements)
        {
            json.WriteStartObject();
            WritePlace(json, ack.Link, ack.Record, ack.UtcMicroseconds);
            WriteSource(json, ack.SystemId, ack.ComponentId);
            json.WriteNumber("command", (int)ack.Command);
            json.WriteNumber("result", (int)ack.Result);
            json.WriteNumber("progressPercent", ack.Progress);
            json.WriteNumber("resultParam2", ack.ResultParam2);
            json.WriteNumber("targetSystemId", ack.TargetSystem);
            json.WriteNumber("targetComponentId", ack.TargetComponent);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteNumber("commandAcknowledgementsLeftOut", telemetry.AcknowledgementsLeftOut);
    }

    private static void WriteRefused(Utf8JsonWriter json, IReadOnlyDictionary<int, long> refused)
    {
        json.WriteStartArray("framesRefused");
        foreach (KeyValuePair<int, long> id in refused.OrderBy(r => r.Key))
        {
            json.WriteStartObject();
            json.WriteNumber("messageId", id.Key);
            json.WriteNumber("count", id.Value);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteLinks(Utf8JsonWriter json, FlightSummary summary)
    {
        json.WriteStartArray("links");
        for (int index = 0; index < summary.Links.Count; index++)
        {
            LinkSummary link = summary.Links[index];
            LinkStatus status = index < summary.LinkStatus.Count ? summary.LinkStatus[index] : default;
            json.WriteStartObject();
            json.WriteString("url", link.Url);
            json.WriteString("state", status.State.ToString());
            json.WriteNumber("frames", link.Frames);
            json.WriteNumber("framesOut", status.FramesOut);
            json.WriteNumber("framesDroppedIn", status.FramesDroppedIn);
            json.WriteNumber("framesDroppedOut", status.FramesDroppedOut);
            json.WriteNumber("bytesLost", link.BytesLost);
            WriteNumberOrNull(json, "firstDamageOffsetBytes", link.FirstDamageOffset);
            json.WriteNumber("framesIncompatible", link.IncompatibleFrames);
            json.WriteNumber("framesMended", link.MendedFrames);
            WriteRefused(json, link.RefusedFrames);
            WriteSignatures(json, status.Signatures);
            WriteSources(json, link.Sources);
            WriteCounts(json, "counts", link.Counts);
            json.WriteNumber("framesNotListed", link.FramesNotListed);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteSignatures(Utf8JsonWriter json, in MavlinkSignatureCounters signatures)
    {
        json.WriteStartObject("signatures");
        json.WriteNumber("valid", signatures.Valid);
        json.WriteNumber("unsignedAllowed", signatures.UnsignedAllowed);
        json.WriteNumber("rejected", signatures.Rejected);
        json.WriteNumber("notSigned", signatures.NotSigned);
        json.WriteNumber("bad", signatures.BadSignatures);
        json.WriteNumber("tooOld", signatures.OldTimestamps);
        json.WriteNumber("newTooOld", signatures.NewStreamsTooOld);
        json.WriteNumber("tooMany", signatures.TooManyStreams);
        json.WriteEndObject();
    }

    private static void WriteSources(Utf8JsonWriter json, IReadOnlyList<MavlinkSequenceStatistics> sources)
    {
        json.WriteStartArray("sources");
        foreach (MavlinkSequenceStatistics source in sources)
        {
            json.WriteStartObject();
            WriteSource(json, source.SystemId, source.ComponentId);
            json.WriteNumber("frames", source.Frames);
            json.WriteNumber("missing", source.Missing);
            json.WriteNumber("outOfOrder", source.OutOfOrder);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteCounts(Utf8JsonWriter json, string name, IReadOnlyList<FrameCount> counts)
    {
        json.WriteStartArray(name);
        foreach (FrameCount count in counts)
        {
            json.WriteStartObject();
            json.WriteNumber("messageId", count.MessageId);
            json.WriteString("name", count.Name);
            WriteSource(json, count.SystemId, count.ComponentId);
            json.WriteNumber("version", (int)count.Version);
            json.WriteNumber("count", count.Count);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteRun(Utf8JsonWriter json, FlightSummary summary)
    {
        json.WriteStartObject("health");
        json.WriteString("level", summary.Health.Level.ToString());
        json.WriteString("reasons", summary.Health.Reasons.ToString());
        json.WriteString("text", summary.Health.Text);
        json.WriteEndObject();

        json.WriteStartObject("run");
        json.WriteString("stopReason", summary.StopReason);
        json.WriteNumber("exitCode", summary.ExitCode);
        json.WriteStartArray("managers");
        foreach (ManagerSummary manager in summary.Managers)
        {
            json.WriteStartObject();
            json.WriteString("name", manager.Name);
            json.WriteString("outcome", manager.Outcome);
            json.WriteNumber("runs", manager.Runs);
            json.WriteNumber("faults", manager.Faults);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void WritePlace(Utf8JsonWriter json, int link, long record, long utcMicroseconds)
    {
        json.WriteNumber("link", link);
        json.WriteNumber("record", record);
        json.WriteNumber("utcMicroseconds", utcMicroseconds);
    }

    private static void WriteSource(Utf8JsonWriter json, byte systemId, byte componentId)
    {
        json.WriteNumber("systemId", systemId);
        json.WriteNumber("componentId", componentId);
    }

    private static void WriteNumberOrNull(Utf8JsonWriter json, string name, long? value)
    {
        if (value is { } known)
            json.WriteNumber(name, known);
        else
            json.WriteNull(name);
    }
}
