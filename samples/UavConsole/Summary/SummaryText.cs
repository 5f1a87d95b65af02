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

namespace UavConsole;

/// <summary>Writes the summary for people. Times are log times: seconds since the first frame that Autopilot Interface was given.</summary>
internal sealed class SummaryText(TextWriter output, RunSummary summary)
{
    private const int AcknowledgementsListed = 20;

    public void Write()
    {
        Line($"--- summary: {summary.Result.StopReason} ---");
        WriteFlight(summary.Flight);
        for (int index = 0; index < summary.Links.Count; index++)
            WriteLink(summary.Links[index], summary.LinkStatus[index]);
        if (summary.Camera is { } camera)
            WriteCamera(camera);
        Line("sent by us: " + Counts(summary.OwnFrames));
        Line("health at the end: " + Text.Health(summary.Health));
        foreach (ManagerResult manager in summary.Result.Managers)
            Line("manager " + Text.Printable(manager.ToString()));
        if (summary.Outcome is { } outcome)
            new MissionText(output, summary, outcome).Write();
        if (summary.HasReplayLostFrames)
            Line("FAILED: frames of a recorded flight were dropped, or it could not be read to its end");
    }

    private void WriteFlight(FlightSummary flight)
    {
        if (flight.Autopilot is not { } autopilot)
        {
            Line("no autopilot was heard");
            return;
        }

        double seconds = ((flight.LastUtcMicroseconds - flight.FirstUtcMicroseconds) ?? 0) / 1e6;
        Line($"{Text.Name(autopilot)} {flight.VehicleType}, system {flight.SystemId}, component {flight.ComponentId}, "
            + seconds.ToString("0.0", CultureInfo.InvariantCulture) + " s");
        Line("mode changes:");
        foreach (FlightModeChange change in flight.ModeChanges)
            Line($"{At(change.UtcMicroseconds)}{change.Mode}, {(change.IsArmed ? "armed" : "disarmed")}, {change.SystemStatus}");
        Line("latitude   " + Range(flight.LatitudeDegE7, 1e7, "0.0000000", "degrees"));
        Line("longitude  " + Range(flight.LongitudeDegE7, 1e7, "0.0000000", "degrees"));
        Line("altitude   " + Range(flight.AltitudeAmslMillimetres, 1e3, "0.000", "m AMSL"));
        Line("height     " + Range(flight.HeightAboveHomeMillimetres, 1e3, "0.000", "m above home"));
        Line("status texts:" + (flight.StatusTexts.Count == 0 ? " none" : string.Empty));
        foreach (FlightStatusText text in flight.StatusTexts)
            Line($"{At(text.UtcMicroseconds)}{text.Severity.ToString().ToLowerInvariant()}: {Text.Printable(text.Text)}");
        Line("command acknowledgements:" + (flight.Acknowledgements.Count == 0 ? " none" : string.Empty));
        if (flight.Acknowledgements.Count <= AcknowledgementsListed)
        {
            foreach (FlightAcknowledgement ack in flight.Acknowledgements)
                Line($"{At(ack.UtcMicroseconds)}{ack.Command} ({(int)ack.Command}): {ack.Result}");
        }
        else
        {
            WriteAcknowledgementCounts(flight);
        }
    }

    // A mission of our own is hundreds of go-to steps: nobody reads them one by one, and --summary has them all.
    private void WriteAcknowledgementCounts(FlightSummary flight)
    {
        foreach (var kind in flight.Acknowledgements.GroupBy(a => (a.Command, a.Result)))
        {
            Line(string.Format(
                CultureInfo.InvariantCulture,
                "{0}{1} ({2}): {3}, {4} times, the last at {5}",
                At(kind.First().UtcMicroseconds),
                kind.Key.Command,
                (int)kind.Key.Command,
                kind.Key.Result,
                kind.Count(),
                At(kind.Last().UtcMicroseconds).Trim()));
        }
    }

    // What a folder holds and nobody has seen: otherwise a person wonders why the camera gave no picture.
    private void WriteCamera(FolderCamera camera)
    {
        Line(string.Format(
            CultureInfo.InvariantCulture,
            "camera folder: {0} pictures taken, {1} from before the run, {2} too late, {3} refused, {4} without a free buffer",
            camera.PicturesDelivered,
            camera.PicturesBeforeRun,
            camera.PicturesLate,
            camera.PicturesRefused,
            camera.PicturesWithoutBuffer));
        if (camera.LastRefusal is { } why)
            Line("  refused last: " + Text.Printable(why));
    }

    private void WriteLink(LinkSummary link, LinkStatus status)
    {
        string fault = status.Fault is null ? string.Empty : $" ({status.Fault})";
        Line($"link {link.Url}: {status.State}{fault}, {link.Frames.ToString(CultureInfo.InvariantCulture)} frames");
        WriteRejected(status.Signatures);
        if (link.IncompatibleFrames > 0)
            Line($"  {link.IncompatibleFrames.ToString(CultureInfo.InvariantCulture)} frames left out, because they have an incompatibility flag that is not known");
        if (link.BytesLost > 0)
        {
            string where = link.FirstDamageOffset is { } offset ? $", the first at offset {offset.ToString(CultureInfo.InvariantCulture)}" : string.Empty;
            Line($"  {link.BytesLost.ToString(CultureInfo.InvariantCulture)} bytes belong to no intact record or frame{where}");
        }

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
            Line("    " + Counts(link.Counts.Where(c => c.SystemId == source.SystemId && c.ComponentId == source.ComponentId)));
        }

        WriteUncertain(link);
    }

    // They were counted, and went nowhere: without this line nobody would know why an autopilot was not heard.
    private void WriteRejected(in MavlinkSignatureCounters signatures)
    {
        if (signatures.Rejected == 0)
            return;
        Line(string.Format(
            CultureInfo.InvariantCulture,
            "  {0} frames were rejected: {1} not signed, {2} with a bad signature, {3} too old, {4} of new senders too old, {5} of too many senders",
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
        FrameCount[] uncertain = link.Counts.Where(c => !link.Sources.Any(s => s.SystemId == c.SystemId && s.ComponentId == c.ComponentId)).ToArray();
        if (uncertain.Length > 0)
            Line($"  from others, with ids that are not known: {uncertain.Sum(c => c.Count).ToString(CultureInfo.InvariantCulture)} frames of {uncertain.Length.ToString(CultureInfo.InvariantCulture)} kinds");
        if (link.FramesNotListed > 0)
            Line($"  of more kinds than are listed: {link.FramesNotListed.ToString(CultureInfo.InvariantCulture)} frames");
    }

    private static string Counts(IEnumerable<FrameCount> counts)
    {
        string text = string.Join(", ", counts.Select(c => $"{c.Name ?? "id"} ({c.MessageId.ToString(CultureInfo.InvariantCulture)}) {c.Count.ToString(CultureInfo.InvariantCulture)}"));
        return text.Length == 0 ? "nothing" : text;
    }

    private static string Range(FlightRange? range, double unit, string format, string name) => range is not { } known
        ? "never told"
        : $"{(known.Minimum / unit).ToString(format, CultureInfo.InvariantCulture)} to {(known.Maximum / unit).ToString(format, CultureInfo.InvariantCulture)} {name}";

    private string At(long utcMicroseconds)
        => Text.At(TimeSpan.FromTicks((utcMicroseconds - (summary.Flight.FirstUtcMicroseconds ?? utcMicroseconds)) * 10));

    private void Line(string text) => output.WriteLine(text);
}
