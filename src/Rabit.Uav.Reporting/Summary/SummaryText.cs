using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Writes the summary of a run for people. Times of frames are seconds since the first frame that the recorder
/// received.
/// </summary>
/// <example>
/// <code>
/// SummaryText.Write(Console.Out, new FlightSummary(recorder.Record, reactor.Run()));
/// </code>
/// </example>
public sealed class SummaryText
{
    private const int AcknowledgementsListed = 20;

    private readonly TextWriter _output;
    private readonly FlightSummary _summary;
    private readonly TelemetryRecord _telemetry;

    private SummaryText(TextWriter output, FlightSummary summary)
    {
        _output = output;
        _summary = summary;
        _telemetry = summary.Record.Telemetry;
    }

    /// <summary>Writes the summary.</summary>
    /// <param name="output">Where to; it is neither flushed nor closed.</param>
    /// <param name="summary">What to write.</param>
    public static void Write(TextWriter output, FlightSummary summary)
        => new SummaryText(
            output ?? throw new ArgumentNullException(nameof(output)),
            summary ?? throw new ArgumentNullException(nameof(summary))).Write();

    private void Write()
    {
        Line($"--- summary: {_summary.StopReason} ---");
        MissionSummaryText? mission = _summary.Mission is null
            ? null
            : new MissionSummaryText(_output, _summary, _summary.Mission);
        mission?.WriteHeadlines();
        WriteFlight(_telemetry);
        if (_telemetry.FramesDropped > 0)
            Line($"NOT RECORDED: {FlightText.Number(_telemetry.FramesDropped)} frames had no room in the recorder's "
                + "queue");
        for (int index = 0; index < _summary.Links.Count; index++)
            WriteLink(_summary.Links[index], index < _summary.LinkStatus.Count ? _summary.LinkStatus[index] : default);
        if (_summary.Camera is { } camera)
            WriteCamera(camera);
        Line("sent by us: " + Counts(_summary.OwnFrames));
        Line("health at the end: " + FlightText.Health(_summary.Health));
        foreach (ManagerSummary manager in _summary.Managers)
            Line("manager " + FlightText.Printable(manager.Description));
        mission?.Write();
        if (_summary.HasReplayLostFrames)
            Line("FAILED: frames of a recorded flight were dropped, or it could not be read to its end");
    }

    private void WriteFlight(TelemetryRecord flight)
    {
        if (flight.Autopilot is not { } autopilot)
        {
            Line("no autopilot was connected");
            return;
        }

        double seconds = ((flight.LastUtcMicroseconds - flight.FirstUtcMicroseconds) ?? 0) / 1e6;
        string firmware = flight.Firmware is { } version ? " " + version : string.Empty;
        Line($"{FlightText.Autopilot(autopilot)}{firmware} {flight.VehicleType}, system {flight.SystemId}, component "
            + $"{flight.ComponentId}, telemetry of "
            + seconds.ToString("0.0", CultureInfo.InvariantCulture) + " s");
        Line("mode changes:");
        foreach (FlightModeChange change in flight.ModeChanges)
            Line($"{At(change.UtcMicroseconds)}{change.Mode}, {(change.IsArmed ? "armed" : "disarmed")}, "
                + $"{change.SystemStatus}");
        Line("latitude   " + Range(flight.LatitudeDegE7, 1e7, "0.0000000", "degrees"));
        Line("longitude  " + Range(flight.LongitudeDegE7, 1e7, "0.0000000", "degrees"));
        Line("altitude   " + Range(flight.AltitudeAmslMillimetres, 1e3, "0.000", "m AMSL"));
        Line("height     " + Range(flight.HeightAboveHomeMillimetres, 1e3, "0.000", "m above home"));
        Line("status texts:" + (flight.StatusTexts.Count == 0 ? " none" : string.Empty));
        foreach (FlightStatusText text in flight.StatusTexts)
            Line($"{At(text.UtcMicroseconds)}{text.Severity.ToString().ToLowerInvariant()}: "
                + $"{FlightText.Printable(text.Text)}");
        Line("command acknowledgements:" + (flight.Acknowledgements.Count == 0 ? " none" : string.Empty));
        if (flight.Acknowledgements.Count <= AcknowledgementsListed)
        {
            foreach (FlightAcknowledgement ack in flight.Acknowledgements)
                Line($"{At(ack.UtcMicroseconds)}{MavlinkNames.Of(ack.Command)} ({(int)ack.Command}): "
                    + MavlinkNames.Of(ack.Result));
        }
        else
        {
            WriteAcknowledgementCounts(flight);
        }
    }

    // A mission is hundreds of go-to steps, too many to read one by one; the JSON summary has them all.
    private void WriteAcknowledgementCounts(TelemetryRecord flight)
    {
        foreach (var kind in flight.Acknowledgements.GroupBy(a => (a.Command, a.Result)))
        {
            Line(string.Format(
                CultureInfo.InvariantCulture,
                "{0}{1} ({2}): {3}, {4} times, the last at {5}",
                At(kind.First().UtcMicroseconds),
                MavlinkNames.Of(kind.Key.Command),
                (int)kind.Key.Command,
                MavlinkNames.Of(kind.Key.Result),
                kind.Count(),
                At(kind.Last().UtcMicroseconds).Trim()));
        }
    }

    // Also the pictures that were not used: otherwise it remains open why the camera gave none.
    private void WriteCamera(CameraSummary camera)
    {
        string skipped = camera.Skipped == 0
            ? string.Empty
            : $", {FlightText.Number(camera.Skipped)} passed over";
        string restarts = camera.Restarts == 0
            ? string.Empty
            : $"; opened again {FlightText.Number(camera.Restarts)} times";
        string withoutTime = camera.WithoutTime == 0
            ? string.Empty
            : $", {FlightText.Number(camera.WithoutTime)} with the time of their arrival alone";
        Line(string.Format(
            CultureInfo.InvariantCulture,
            "camera {0}: {1} pictures taken, {2} from before the run, {3} too late, {4} refused, {5} without a free "
                + "buffer{6}{7}{8}",
            FlightText.Printable(camera.Name),
            camera.Delivered,
            camera.BeforeRun,
            camera.Late,
            camera.Refused,
            camera.WithoutBuffer,
            skipped,
            withoutTime,
            restarts));
        if (camera.TimeSource is { } source)
            Line("  time of a picture: " + FlightText.Printable(source));
        if (camera.LastRefusal is { } why)
            Line((camera.Restarts == 0 ? "  refused last: " : "  last fault: ") + FlightText.Printable(why));
    }

    private void WriteLink(LinkSummary link, LinkStatus status)
    {
        string fault = status.Fault is null ? string.Empty : $" ({status.Fault})";
        Line($"link {link.Url}: {status.State}{fault}, {link.Frames.ToString(CultureInfo.InvariantCulture)} frames");
        WriteRejected(status.Signatures);
        if (link.IncompatibleFrames > 0)
            Line($"  {link.IncompatibleFrames.ToString(CultureInfo.InvariantCulture)} frames left out, because they "
                + "have an incompatibility flag that is not known");
        if (link.BytesLost > 0)
        {
            string where = link.FirstDamageOffset is { } offset
                ? $", the first at offset {offset.ToString(CultureInfo.InvariantCulture)}"
                : string.Empty;
            Line($"  {link.BytesLost.ToString(CultureInfo.InvariantCulture)} bytes belong to no intact record or "
                + $"frame{where}");
        }

        if (link.MendedFrames > 0)
            Line($"  {link.MendedFrames.ToString(CultureInfo.InvariantCulture)} frames had been stored without their "
                + "trailing zeros");
        foreach (KeyValuePair<int, long> refused in link.RefusedFrames.OrderBy(r => r.Key))
            Line(string.Format(
                CultureInfo.InvariantCulture, "  {0} frames of id {1} refused: another message has that id",
                refused.Value, refused.Key));
        foreach (MavlinkSequenceStatistics source in link.Sources)
        {
            Line(string.Format(
                CultureInfo.InvariantCulture,
                "  from {0}/{1}: {2} frames, {3} missing, {4} out of order",
                source.SystemId,
                source.ComponentId,
                source.Frames,
                source.Missing,
                source.OutOfOrder));
            Line("    "
                + Counts(link.Counts.Where(c => c.SystemId == source.SystemId && c.ComponentId == source.ComponentId)));
        }

        WriteUncertain(link);
    }

    // They were counted and not handled: this line explains an autopilot that is not connected.
    private void WriteRejected(in MavlinkSignatureCounters signatures)
    {
        if (signatures.Rejected == 0)
            return;
        Line(string.Format(
            CultureInfo.InvariantCulture,
            "  {0} frames were rejected: {1} not signed, {2} with a bad signature, {3} too old, {4} of new senders too "
                + "old, {5} of too many senders",
            signatures.Rejected,
            signatures.NotSigned,
            signatures.BadSignatures,
            signatures.OldTimestamps,
            signatures.NewStreamsTooOld,
            signatures.TooManyStreams));
    }

    // Sources of which nothing could be checked: their ids are unknown, so that even who sent them is not certain.
    private void WriteUncertain(LinkSummary link)
    {
        FrameCount[] uncertain = link.Counts
            .Where(c => !link.Sources.Any(s => s.SystemId == c.SystemId && s.ComponentId == c.ComponentId))
            .ToArray();
        if (uncertain.Length > 0)
            Line("  from others, with ids that are not known: "
                + $"{uncertain.Sum(c => c.Count).ToString(CultureInfo.InvariantCulture)} frames of "
                + $"{uncertain.Length.ToString(CultureInfo.InvariantCulture)} kinds");
        if (link.FramesNotListed > 0)
            Line($"  of more kinds than are listed: {link.FramesNotListed.ToString(CultureInfo.InvariantCulture)} "
                + "frames");
    }

    private static string Counts(IEnumerable<FrameCount> counts)
    {
        string text = string.Join(
            ", ",
            counts.Select(c => $"{c.Name ?? "id"} ({c.MessageId.ToString(CultureInfo.InvariantCulture)}) "
                + $"{c.Count.ToString(CultureInfo.InvariantCulture)}"));
        return text.Length == 0 ? "nothing" : text;
    }

    private static string Range(FlightRange? range, double unit, string format, string name) => range is not { } known
        ? "never received"
        : $"{(known.Minimum / unit).ToString(format, CultureInfo.InvariantCulture)} to "
            + $"{(known.Maximum / unit).ToString(format, CultureInfo.InvariantCulture)} {name}";

    private string At(long utcMicroseconds)
        => FlightText.TimeStamp(
            TimeSpan.FromTicks((utcMicroseconds - (_telemetry.FirstUtcMicroseconds ?? utcMicroseconds)) * 10));

    private void Line(string text) => _output.WriteLine(text);
}
