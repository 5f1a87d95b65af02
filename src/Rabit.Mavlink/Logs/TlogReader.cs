using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Mavlink.Framing;
using Rabit.Mavlink.Logs;

namespace Rabit.Mavlink;

/// <summary>
/// Reads a telemetry log (.tlog) record by record: constant memory, nothing allocated per record, no seeking. Damage
/// does not end it: every intact record is delivered, what lies between is counted and its first place named. One
/// thread at a time.
/// </summary>
/// <example>
/// <code>
/// using FileStream file = File.OpenRead("flight.tlog");
/// var log = new TlogReader(file, MavlinkDialect.All);
/// while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
/// {
///     if (frame.TryDecode(out Attitude attitude))
///         Console.WriteLine($"{record.TimeUtc:HH:mm:ss.fff} roll {attitude.Roll} rad");
/// }
///
/// if (log.End == TlogEnd.NoRecord)
///     Console.WriteLine("not a telemetry log");
/// </code>
/// </example>
public sealed partial class TlogReader
{
    private const int BufferLength = 64 * 1024;

    private readonly Stream _stream;
    private readonly MessageTable _messages;
    private readonly byte[] _buffer = new byte[BufferLength];

    // The bytes held: [_start, _end). _bufferOffset is the file offset of _buffer[0].
    private int _start;
    private int _end;
    private long _bufferOffset;
    private bool _streamEnded;
    private bool _readToEnd;

    private long? _lastTime;

    /// <summary>Makes a reader.</summary>
    /// <param name="stream">
    /// The log, from its beginning or from the start of any record. It stays the caller's to close.
    /// </param>
    /// <param name="dialect">The messages whose checksum can be checked.</param>
    /// <exception cref="ArgumentNullException">No stream or no dialect.</exception>
    /// <exception cref="ArgumentException">The stream cannot be read.</exception>
    public TlogReader(Stream stream, MavlinkDialect dialect)
    {
        _stream = stream ?? throw new ArgumentNullException(nameof(stream));
        _messages = (dialect ?? throw new ArgumentNullException(nameof(dialect))).Table;
        if (!stream.CanRead)
            throw new ArgumentException("The stream cannot be read.", nameof(stream));
    }

    /// <summary>Records delivered so far.</summary>
    public long Records { get; private set; }

    /// <summary>
    /// Intact records that were passed over because their frame has an incompatibility flag not known here. They count
    /// in <see cref="TlogRecord.Index"/>.
    /// </summary>
    public long IncompatibleRecords { get; private set; }

    /// <summary>
    /// Records so far whose payload was stored without its trailing zeros but with the checksum of the frame as it was
    /// sent, as QGroundControl does with senders that do not cut them. They are delivered as they were sent, and count
    /// in <see cref="Records"/>.
    /// </summary>
    public long MendedRecords { get; private set; }

    /// <summary>
    /// Records so far that stand whole among others and were refused: their checksum, or their length, is not that of
    /// the message that the dialect knows under their id. Their bytes count in <see cref="LostBytes"/>.
    /// </summary>
    public long RefusedRecords { get; private set; }

    /// <summary>
    /// The same by message id; of more than 256 ids only in <see cref="RefusedRecords"/>. A private message of an old
    /// ground station shows here.
    /// </summary>
    public IReadOnlyDictionary<int, long> RefusedRecordsById => _refused;

    /// <summary>Bytes so far that belong to no intact record, the rest of a record cut at the end included.</summary>
    public long LostBytes { get; private set; }

    /// <summary>File offset of the first of <see cref="LostBytes"/>; null while there are none.</summary>
    public long? FirstDamageOffset { get; private set; }

    /// <summary>File offset behind the last byte processed, for a progress bar.</summary>
    public long Position => _bufferOffset + _start;

    /// <summary>How it ended, once <see cref="TryRead"/> returned false.</summary>
    public TlogEnd End => !_readToEnd ? TlogEnd.NotReached
        : Records + IncompatibleRecords > 0 ? TlogEnd.Complete
        : Position == 0 ? TlogEnd.Empty
        : TlogEnd.NoRecord;

    /// <summary>Reads the next intact record.</summary>
    /// <param name="frame">The frame; <c>default</c> at the end.</param>
    /// <param name="record">Its time and place.</param>
    /// <returns>Whether there was one; false at the end of the stream.</returns>
    /// <exception cref="IOException">The stream failed; whatever the stream throws passes through.</exception>
    public bool TryRead(out MavlinkFrame frame, out TlogRecord record)
    {
        while (Fill())
        {
            ReadOnlySpan<byte> rest = _buffer.AsSpan(_start, _end - _start);
            int toSkip = BytesBeforeNextStart(rest);
            if (toSkip == 0 && TryValidate(rest, out ParsedHeader header, out long time))
            {
                if (Take(header, time, rest, out frame, out record))
                    return true;
            }
            else if (toSkip == 0 && TryMend(rest, out frame, out record))
            {
                return true;
            }
            else
            {
                Skip(Math.Max(toSkip, 1));
            }
        }
        _readToEnd = true;
        frame = default;
        record = default;
        return false;
    }

    private bool Take(
        in ParsedHeader header, long time, ReadOnlySpan<byte> rest, out MavlinkFrame frame, out TlogRecord record)
    {
        record = new TlogRecord(
            Records + IncompatibleRecords, Position, time, header.Kind == HeaderKind.KnownMessage,
            _messages.At(header.MessageIndex), isMended: false);
        MavlinkFrame.FromWire(rest.Slice(TlogFormat.TimeLength, header.Length), out frame);
        _start += TlogFormat.TimeLength + header.Length;
        _lastTime = time;
        if (header.HasUnknownFlags)
            IncompatibleRecords++;
        else
            Records++;
        return !header.HasUnknownFlags;
    }

    private void Skip(int count)
    {
        FirstDamageOffset ??= Position;
        LostBytes += count;
        _start += count;
    }

    // Makes sure that a record and the head of the one behind it are in the buffer, unless the stream ends before.
    private bool Fill()
    {
        while (!_streamEnded && _end - _start < Lookahead)
        {
            if (_start > 0)
            {
                Buffer.BlockCopy(_buffer, _start, _buffer, 0, _end - _start);
                _bufferOffset += _start;
                _end -= _start;
                _start = 0;
            }
            int count = _stream.Read(_buffer, _end, BufferLength - _end);
            _streamEnded = count == 0;
            _end += count;
        }
        return _start < _end;
    }
}
