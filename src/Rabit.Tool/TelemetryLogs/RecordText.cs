using System;
using System.Globalization;
using System.Text;
using Rabit.Mavlink;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>What all outputs write alike.</summary>
internal static class RecordText
{
    private const int TicksPerMicrosecond = 10;

    /// <summary>
    /// ISO 8601 in UTC, to the microsecond: <c>2026-09-21T14:13:20.000000Z</c>. Written digit by digit, since there are
    /// millions.
    /// </summary>
    public static void AppendTime(StringBuilder text, DateTime time)
    {
        AppendNumber(text, time.Year, 4);
        AppendNumber(text, time.Month, 2, '-');
        AppendNumber(text, time.Day, 2, '-');
        AppendNumber(text, time.Hour, 2, 'T');
        AppendNumber(text, time.Minute, 2, ':');
        AppendNumber(text, time.Second, 2, ':');
        AppendNumber(text, (int)(time.Ticks % TimeSpan.TicksPerSecond) / TicksPerMicrosecond, 6, '.');
        text.Append('Z');
    }

    /// <summary>The message's name, or <c>UNKNOWN_12345</c>.</summary>
    public static string NameOf(in MavlinkFrame frame, in TlogRecord record) =>
        record.Message.Name ?? "UNKNOWN_" + frame.MessageId.ToString(CultureInfo.InvariantCulture);

    public static string PayloadHex(in MavlinkFrame frame)
    {
        var hex = new StringBuilder(2 * frame.PayloadLength);
        for (int index = 0; index < frame.PayloadLength; index++)
            hex.Append(frame.PayloadByte(index).ToString("x2", CultureInfo.InvariantCulture));
        return hex.ToString();
    }

    private static void AppendNumber(StringBuilder text, int number, int digits, char before = '\0')
    {
        if (before != '\0')
            text.Append(before);
        int divisor = 1;
        for (int digit = 1; digit < digits; digit++)
            divisor *= 10;
        for (; divisor > 0; divisor /= 10)
            text.Append((char)('0' + (number / divisor % 10)));
    }
}
