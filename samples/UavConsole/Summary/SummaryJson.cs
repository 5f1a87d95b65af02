using System.Collections.Generic;
using System.IO;
using System.Text.Json;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;

namespace UavConsole;

/// <summary>Writes the summary for programs; docs/uavconsole-summary.md tells the fields. Times are log times.</summary>
internal static class SummaryJson
{
    /// <summary>The whole file.</summary>
    public static byte[] Write(RunSummary summary)
    {
        using var stream = new MemoryStream();
        using (var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true }))
            Write(json, summary);
        return stream.ToArray();
    }

    private static void Write(Utf8JsonWriter json, RunSummary summary)
    {
        json.WriteStartObject();
        WriteVehicle(json, summary.Flight);
        WriteModeChanges(json, summary.Flight);
        WriteRanges(json, summary.Flight);
        WriteStatusTexts(json, summary.Flight);
        WriteAcknowledgements(json, summary.Flight);
        WriteLinks(json, summary);
        WriteCounts(json, "own_frames", summary.OwnFrames);
        WriteCamera(json, summary.Camera);
        WriteRun(json, summary);
        if (summary.Outcome is { } outcome)
            MissionJson.Write(json, summary, outcome);
        else
            json.WriteNull("mission");
        json.WriteEndObject();
    }

    private static void WriteCamera(Utf8JsonWriter json, FolderCamera? camera)
    {
        if (camera is null)
        {
            json.WriteNull("camera");
            return;
        }

        json.WriteStartObject("camera");
        json.WriteNumber("taken", camera.PicturesDelivered);
        json.WriteNumber("before_run", camera.PicturesBeforeRun);
        json.WriteNumber("late", camera.PicturesLate);
        json.WriteNumber("refused", camera.PicturesRefused);
        json.WriteNumber("without_buffer", camera.PicturesWithoutBuffer);
        json.WriteString("last_refusal", camera.LastRefusal);
        json.WriteEndObject();
    }

    private static void WriteVehicle(Utf8JsonWriter json, FlightSummary flight)
    {
        json.WriteString("autopilot", flight.Autopilot?.ToString());
        json.WriteString("vehicle_type", flight.VehicleType?.ToString());
        json.WriteNumber("system_id", flight.SystemId);
        json.WriteNumber("component_id", flight.ComponentId);
        WriteNumberOrNull(json, "first_us", flight.FirstUtcMicroseconds);
        WriteNumberOrNull(json, "last_us", flight.LastUtcMicroseconds);
    }

    private static void WriteModeChanges(Utf8JsonWriter json, FlightSummary flight)
    {
        json.WriteStartArray("mode_changes");
        foreach (FlightModeChange change in flight.ModeChanges)
        {
            json.WriteStartObject();
            WritePlace(json, change.Link, change.Record, change.UtcMicroseconds);
            json.WriteString("mode", change.Mode);
            json.WriteNumber("custom_mode", change.CustomMode);
            json.WriteNumber("base_mode", (uint)change.BaseMode);
            json.WriteBoolean("armed", change.IsArmed);
            json.WriteNumber("system_status", (int)change.SystemStatus);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteNumber("mode_changes_left_out", flight.ModeChangesLeftOut);
    }

    private static void WriteRanges(Utf8JsonWriter json, FlightSummary flight)
    {
        json.WriteStartObject("global_position_int");
        WriteRange(json, "lat", flight.LatitudeDegE7);
        WriteRange(json, "lon", flight.LongitudeDegE7);
        WriteRange(json, "alt", flight.AltitudeAmslMillimetres);
        WriteRange(json, "relative_alt", flight.HeightAboveHomeMillimetres);
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

    private static void WriteStatusTexts(Utf8JsonWriter json, FlightSummary flight)
    {
        json.WriteStartArray("status_texts");
        foreach (FlightStatusText text in flight.StatusTexts)
        {
            json.WriteStartObject();
            WritePlace(json, text.Link, text.Record, text.UtcMicroseconds);
            WriteSource(json, text.SystemId, text.ComponentId);
            json.WriteNumber("severity", (int)text.Severity);
            json.WriteString("text", text.Text);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteNumber("status_texts_left_out", flight.StatusTextsLeftOut);
    }

    private static void WriteAcknowledgements(Utf8JsonWriter json, FlightSummary flight)
    {
        json.WriteStartArray("command_acks");
        foreach (FlightAcknowledgement ack in flight.Acknowledgements)
        {
            json.WriteStartObject();
            WritePlace(json, ack.Link, ack.Record, ack.UtcMicroseconds);
            WriteSource(json, ack.SystemId, ack.ComponentId);
            json.WriteNumber("command", (int)ack.Command);
            json.WriteNumber("result", (int)ack.Result);
            json.WriteNumber("progress", ack.Progress);
            json.WriteNumber("result_param2", ack.ResultParam2);
            json.WriteNumber("target_system", ack.TargetSystem);
            json.WriteNumber("target_component", ack.TargetComponent);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteNumber("command_acks_left_out", flight.AcknowledgementsLeftOut);
    }

    private static void WriteLinks(Utf8JsonWriter json, RunSummary summary)
    {
        json.WriteStartArray("links");
        for (int index = 0; index < summary.Links.Count; index++)
        {
            LinkSummary link = summary.Links[index];
            json.WriteStartObject();
            json.WriteString("url", link.Url);
            json.WriteString("state", summary.LinkStatus[index].State.ToString());
            json.WriteNumber("frames", link.Frames);
            json.WriteNumber("frames_out", summary.LinkStatus[index].FramesOut);
            json.WriteNumber("frames_dropped_in", summary.LinkStatus[index].FramesDroppedIn);
            json.WriteNumber("frames_dropped_out", summary.LinkStatus[index].FramesDroppedOut);
            json.WriteNumber("bytes_lost", link.BytesLost);
            WriteNumberOrNull(json, "first_damage_offset", link.FirstDamageOffset);
            json.WriteNumber("frames_incompatible", link.IncompatibleFrames);
            WriteSignatures(json, summary.LinkStatus[index].Signatures);
            WriteSources(json, link.Sources);
            WriteCounts(json, "counts", link.Counts);
            json.WriteNumber("frames_not_listed", link.FramesNotListed);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteSignatures(Utf8JsonWriter json, in MavlinkSignatureCounters signatures)
    {
        json.WriteStartObject("signatures");
        json.WriteNumber("valid", signatures.Valid);
        json.WriteNumber("unsigned_allowed", signatures.UnsignedAllowed);
        json.WriteNumber("rejected", signatures.Rejected);
        json.WriteNumber("not_signed", signatures.NotSigned);
        json.WriteNumber("bad", signatures.BadSignatures);
        json.WriteNumber("too_old", signatures.OldTimestamps);
        json.WriteNumber("new_too_old", signatures.NewStreamsTooOld);
        json.WriteNumber("too_many", signatures.TooManyStreams);
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
            json.WriteNumber("out_of_order", source.OutOfOrder);
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
            json.WriteNumber("msgid", count.MessageId);
            json.WriteString("name", count.Name);
            WriteSource(json, count.SystemId, count.ComponentId);
            json.WriteNumber("version", (int)count.Version);
            json.WriteNumber("count", count.Count);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteRun(Utf8JsonWriter json, RunSummary summary)
    {
        json.WriteStartObject("health");
        json.WriteString("level", summary.Health.Level.ToString());
        json.WriteString("reasons", summary.Health.Reasons.ToString());
        json.WriteString("text", summary.Health.Text);
        json.WriteEndObject();

        json.WriteStartObject("run");
        json.WriteString("stop_reason", summary.Result.StopReason);
        json.WriteNumber("exit_code", summary.ExitCode);
        json.WriteStartArray("managers");
        foreach (ManagerResult manager in summary.Result.Managers)
        {
            json.WriteStartObject();
            json.WriteString("name", manager.Name);
            json.WriteString("outcome", manager.Outcome.ToString());
            json.WriteNumber("runs", manager.Runs);
            json.WriteNumber("faults", manager.FaultCount);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void WritePlace(Utf8JsonWriter json, int link, long record, long utcMicroseconds)
    {
        json.WriteNumber("link", link);
        json.WriteNumber("record", record);
        json.WriteNumber("t_us", utcMicroseconds);
    }

    private static void WriteSource(Utf8JsonWriter json, byte systemId, byte componentId)
    {
        json.WriteNumber("sysid", systemId);
        json.WriteNumber("compid", componentId);
    }

    private static void WriteNumberOrNull(Utf8JsonWriter json, string name, long? value)
    {
        if (value is { } known)
            json.WriteNumber(name, known);
        else
            json.WriteNull(name);
    }
}
