using System;
using Rabit.Mavlink.Logs;

namespace Rabit.Mavlink;

/// <summary>One record of a telemetry log without its frame: its time, and where it is. A plain value.</summary>
public readonly struct TlogRecord
{
    internal TlogRecord(
        long index, long offset, long timeMicroseconds, bool isChecked, in MavlinkMessageInfo message, bool isMended)
    {
        Index = index;
        Offset = offset;
        TimeMicroseconds = timeMicroseconds;
        IsChecked = isChecked;
        Message = message;
        IsMended = isMended;
    }

    /// <summary>Which intact record of the log it is, from 0.</summary>
    public long Index { get; }

    /// <summary>Where in the file it begins (its time, then its frame), in bytes.</summary>
    public long Offset { get; }

    /// <summary>When the recorder saw the frame, by its clock: microseconds since 1970-01-01 UTC.</summary>
    public long TimeMicroseconds { get; }

    /// <summary>The same as a date.</summary>
    public DateTime TimeUtc => TlogFormat.ToUtc(TimeMicroseconds);

    /// <summary>Whether the dialect knows the id, so that the checksum was checked and is right.</summary>
    public bool IsChecked { get; }

    /// <summary>
    /// Whether zeros that the recorder had cut off the end of its payload were put back: then the checksum, which is
    /// the sender's, is right.
    /// </summary>
    public bool IsMended { get; }

    /// <summary>The description of the message; <c>default</c> where the id is unknown.</summary>
    public MavlinkMessageInfo Message { get; }
}
