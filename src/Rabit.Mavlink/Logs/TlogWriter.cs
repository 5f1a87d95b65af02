using System;
using System.IO;
using Rabit.Mavlink.Logs;

namespace Rabit.Mavlink;

/// <summary>
/// Writes a telemetry log (.tlog). A frame is written as it is, signature included, so that a log can be checked and
/// compared byte for byte; the MAVLink guide ("Message signing", Logging) would rather have signatures removed, which
/// is for the caller to do before (<see cref="MavlinkFrame.WithoutSignature()"/>). One thread at a time; allocates
/// nothing per record.
/// </summary>
/// <example>
/// <code>
/// using FileStream file = File.Create("flight.tlog");
/// var log = new TlogWriter(file);
/// MavlinkFrame frame = new MavlinkSender(systemId: 1, componentId: 191).Create(new Heartbeat { MavlinkVersion = 3 });
/// log.Write((DateTime.UtcNow - DateTime.UnixEpoch).Ticks / 10, frame);   // microseconds since 1970
/// </code>
/// </example>
public sealed class TlogWriter
{
    // It carries the secret key (MAVLink guide, "Message signing", Logging: omit it from logs).
    private const int SetupSigning = 256;

    private readonly Stream _stream;
    private readonly byte[] _record = new byte[TlogFormat.MaxRecordLength];

    /// <summary>Makes a writer.</summary>
    /// <param name="stream">Where to write. It stays the caller's to flush and close.</param>
    /// <exception cref="ArgumentNullException">No stream.</exception>
    /// <exception cref="ArgumentException">The stream cannot be written.</exception>
    public TlogWriter(Stream stream)
    {
        _stream = stream ?? throw new ArgumentNullException(nameof(stream));
        if (!stream.CanWrite)
            throw new ArgumentException("The stream cannot be written.", nameof(stream));
    }

    /// <summary>Records written.</summary>
    public long Records { get; private set; }

    /// <summary>SETUP_SIGNING frames that were not written, since a log must not hold the key.</summary>
    public long OmittedRecords { get; private set; }

    /// <summary>Writes one record, in one write to the stream.</summary>
    /// <param name="timeMicroseconds">
    /// When the frame was seen: microseconds since 1970-01-01 UTC, up to the year 2100. Should never decrease.
    /// </param>
    /// <param name="frame">The frame.</param>
    /// <returns>Whether it was written; false for SETUP_SIGNING, which is left out and counted.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The time is negative or beyond the year 2100.</exception>
    /// <exception cref="ArgumentException">The frame is <c>default</c>.</exception>
    /// <exception cref="IOException">The stream failed; whatever the stream throws passes through.</exception>
    public bool Write(long timeMicroseconds, in MavlinkFrame frame)
    {
        if (timeMicroseconds is < 0 or > TlogFormat.MaxTime)
            throw new ArgumentOutOfRangeException(
                nameof(timeMicroseconds), timeMicroseconds, "A record's time lies between 1970 and 2100.");
        if (frame.Version == MavlinkVersion.None)
            throw new ArgumentException("The frame is empty: nothing was ever put into it.", nameof(frame));
        if (frame.MessageId == SetupSigning)
        {
            OmittedRecords++;
            return false;
        }

        TlogFormat.WriteTime(_record, timeMicroseconds);
        int length = frame.WriteTo(_record.AsSpan(TlogFormat.TimeLength));
        _stream.Write(_record, 0, TlogFormat.TimeLength + length);
        Records++;
        return true;
    }
}
