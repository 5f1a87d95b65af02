using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>
/// Who sent what, how often, and what was lost: the picture of a log on one screen. Its memory grows with the kinds of
/// messages, not with the log.
/// </summary>
internal sealed class TableOutput(TextWriter output, string file) : IDumpOutput
{
    private readonly Dictionary<long, MessageCount> _messages = [];
    private readonly Dictionary<int, string> _senderTypes = [];
    private readonly MavlinkSequenceTracker _senders = new(ushort.MaxValue + 1);
    private long _firstTime = long.MaxValue;
    private long _lastTime = long.MinValue;

    public void Add(in MavlinkFrame frame, in TlogRecord record)
    {
        long key = ((long)frame.MessageId << 16) | (uint)Sender(frame.SystemId, frame.ComponentId);
        if (!_messages.TryGetValue(key, out MessageCount? count))
            _messages.Add(key, count = new MessageCount(
                RecordText.NameOf(frame, record), frame.MessageId, frame.SystemId, frame.ComponentId));
        count.Add(frame.WireLength, record.TimeMicroseconds);
        _firstTime = Math.Min(_firstTime, record.TimeMicroseconds);
        _lastTime = Math.Max(_lastTime, record.TimeMicroseconds);

        // An unchecked frame is counted for a sender that is known to exist, since it used up one of its sequence
        // numbers.
        if (record.IsChecked || _senders.TryGet(frame.SystemId, frame.ComponentId, out _))
            _senders.Track(frame);
        if (frame.TryDecode(out Heartbeat heartbeat))
            _senderTypes[Sender(frame.SystemId, frame.ComponentId)] = $"{heartbeat.Type}, {heartbeat.Autopilot}";
    }

    public void Finish(TlogReader log)
    {
        double seconds = _messages.Count == 0 ? 0 : (_lastTime - _firstTime) / 1e6;
        Line($"{file}: {log.Records} records, {log.Position} bytes{(_messages.Count == 0 ? "" : $", {seconds:0.0} s from {Utc(_firstTime)} to {Utc(_lastTime)} UTC")}");
        if (log.LostBytes > 0)
            Line($"damage: {log.LostBytes} bytes belong to no intact record, the first at offset {log.FirstDamageOffset}");
        foreach (KeyValuePair<int, long> refused in log.RefusedRecordsById.OrderBy(r => r.Key))
            Line($"{refused.Value} records of id {refused.Key} refused: another message has that id");
        if (log.MendedRecords > 0)
            Line($"{log.MendedRecords} records had been stored without their trailing zeros");
        if (log.IncompatibleRecords > 0)
            Line($"{log.IncompatibleRecords} records have an incompatibility flag that is not known and were passed over");
        if (_messages.Count == 0)
            return;
        output.WriteLine();
        WriteSenders(seconds);
        output.WriteLine();
        WriteMessages();
    }

    private void WriteSenders(double seconds)
    {
        var table = new TextTable(output, "sender", "<type", "frames", "rate Hz", "missing", "loss %", "disorder");
        foreach (MavlinkSequenceStatistics sender
            in Enumerable.Range(0, _senders.Count).Select(index => _senders[index])
                .OrderBy(sender => Sender(sender.SystemId, sender.ComponentId)))
        {
            _senderTypes.TryGetValue(Sender(sender.SystemId, sender.ComponentId), out string? type);
            table.Add(
                $"{sender.SystemId}/{sender.ComponentId}", type ?? "-", Number(sender.Frames),
                seconds > 0 ? Decimal(sender.Frames / seconds) : "-",
                Number(sender.Missing),
                (100.0 * sender.Missing / (sender.Frames + sender.Missing))
                    .ToString("0.00", CultureInfo.InvariantCulture),
                Number(sender.OutOfOrder));
        }

        table.Write();
    }

    private void WriteMessages()
    {
        long all = _messages.Values.Sum(count => count.Bytes);
        var table = new TextTable(output, "<message", "id", "sender", "count", "rate Hz", "bytes", "share %");
        foreach (MessageCount count in _messages.Values.OrderBy(count => Sender(count.SystemId, count.ComponentId))
            .ThenBy(count => count.MessageId))
        {
            table.Add(
                count.Name, Number(count.MessageId), $"{count.SystemId}/{count.ComponentId}", Number(count.Count),
                count.RateHz is { } rate ? Decimal(rate) : "-",
                Number(count.Bytes), (100.0 * count.Bytes / all).ToString("0.0", CultureInfo.InvariantCulture));
        }

        table.Write();
    }

    private void Line(FormattableString text) => output.WriteLine(FormattableString.Invariant(text));

    private static int Sender(byte systemId, byte componentId) => (systemId << 8) | componentId;

    private static string Number(long number) => number.ToString(CultureInfo.InvariantCulture);

    private static string Decimal(double number) => number.ToString("0.00", CultureInfo.InvariantCulture);

    private static string Utc(long microseconds) =>
        new DateTime(1970, 1, 1, 0, 0, 0, DateTimeKind.Utc).AddTicks(microseconds * 10)
            .ToString("yyyy-MM-dd HH:mm:ss.fff", CultureInfo.InvariantCulture);
}
