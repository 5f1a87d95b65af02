using System;
using System.Buffers;
using System.Runtime.CompilerServices;
using Rabit.Mavlink.Framing;

namespace Rabit.Mavlink;

/// <summary>
/// Finds the frames in a byte stream, however it is divided into chunks, and resynchronises after damage without losing
/// an intact frame: a false start byte costs one byte, not the frames behind it. Fixed memory, nothing allocated per
/// frame, bounded work per byte (docs/decisions/0003-frame-reader.md). One reader per link; one thread at a time.
/// </summary>
/// <example>
/// <code>
/// var reader = new MavlinkFrameReader(MavlinkDialect.Common);
///
/// static void Receive(MavlinkFrameReader reader, ReadOnlySpan&lt;byte&gt; bytes)
/// {
///     while (reader.TryRead(ref bytes, out MavlinkFrame frame, out MavlinkFrameInfo info))
///     {
///         if (info.IsChecked &amp;&amp; frame.TryDecode(out Heartbeat heartbeat))
///             Console.WriteLine($"{frame.SystemId}/{frame.ComponentId}: {heartbeat.SystemStatus}");
///     }
/// }
/// </code>
/// </example>
public sealed partial class MavlinkFrameReader
{
    // A frame that cannot be checked waits for all that could begin inside it: two frames of maximal length are the
    // most ever held back. The rest of the buffer is there so that what is held back is moved to its front seldom.
    private const int BufferLength = 4096;

    private readonly MessageTable _messages;
    private readonly MavlinkInvalidFramePolicy _policy;
    private readonly byte[] _buffer = new byte[BufferLength];

    // The bytes held: [_start, _end). _bufferOffset is the stream offset of _buffer[0].
    private int _start;
    private int _end;
    private long _bufferOffset;

    // With fewer bytes held nothing can be decided: the frame that seems to begin at _start has not arrived. Zero: not
    // parsed yet.
    private int _needed;

    // More bytes than this have to be appended before there is anything to decide; zero: unknown. For single bytes,
    // which are the most calls.
    private int _missing;

    private long _skippedBytes;
    private long _frames;
    private long _unknownFrames;
    private long _incompatibleFrames;
    private long _badChecksums;
    private long _rejectedUnknown;
    private long _checksumBytes;

    /// <summary>Makes a reader.</summary>
    /// <param name="dialect">The messages it can check. Ids outside it are delivered unchecked.</param>
    /// <param name="invalidFrames">Where it continues after an invalid frame.</param>
    /// <exception cref="ArgumentNullException">No dialect.</exception>
    public MavlinkFrameReader(
        MavlinkDialect dialect, MavlinkInvalidFramePolicy invalidFrames = MavlinkInvalidFramePolicy.NextByte)
    {
        _messages = (dialect ?? throw new ArgumentNullException(nameof(dialect))).Table;
        _policy = invalidFrames;
    }

    /// <summary>What it has read so far.</summary>
    public MavlinkReaderCounters Counters => new()
    {
        Bytes = _bufferOffset + _end,
        SkippedBytes = _skippedBytes,
        Frames = _frames,
        UnknownFrames = _unknownFrames,
        IncompatibleFrames = _incompatibleFrames,
        BadChecksums = _badChecksums,
        RejectedUnknown = _rejectedUnknown,
        ChecksumBytes = _checksumBytes,
    };

    /// <summary>How many bytes are held back until more arrive; at most 560.</summary>
    public int PendingBytes => _end - _start;

    /// <summary>
    /// Reads the next frame of the stream. Call it until it returns false: then all bytes given have been consumed.
    /// </summary>
    /// <param name="bytes">The next bytes of the stream; moved behind those that were consumed.</param>
    /// <param name="frame">The frame; <c>default</c> where there is none.</param>
    /// <param name="info">Where it began, and whether it was checked.</param>
    /// <returns>Whether there was a frame.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryRead(ref ReadOnlySpan<byte> bytes, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        if (bytes.Length >= _missing)
            return TryReadNext(ref bytes, out frame, out info);

        // The common case of single bytes and small chunks: the frame that has begun is still incomplete. Inlined, and
        // apart from the rest, whose many variables would cost more than all of this.
        _missing -= bytes.Length;
        Append(bytes);
        bytes = default;
        MavlinkFrame.Clear(out frame);
        info = default;
        return false;
    }

    /// <summary>
    /// Reads the next frame of a stream whose bytes lie in several segments, such as the buffer of a <c>PipeReader</c>.
    /// Call it until it returns false: then all bytes given have been consumed, and the pipe may be advanced to the end
    /// of its buffer.
    /// </summary>
    /// <param name="bytes">The next bytes of the stream; moved behind those that were consumed.</param>
    /// <param name="frame">The frame; <c>default</c> where there is none.</param>
    /// <param name="info">Where it began, and whether it was checked.</param>
    /// <returns>Whether there was a frame.</returns>
    public bool TryRead(ref ReadOnlySequence<byte> bytes, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        while (true)
        {
            SequencePosition next = bytes.Start;
            bytes.TryGet(ref next, out ReadOnlyMemory<byte> memory);
            ReadOnlySpan<byte> segment = memory.Span;
            bool hasFrame = TryRead(ref segment, out frame, out info);

            // By position, not by length: a slice of length zero would stay at an empty segment for ever.
            bytes = !segment.IsEmpty ? bytes.Slice(memory.Length - segment.Length)
                : next.GetObject() is null ? bytes.Slice(bytes.End)
                : bytes.Slice(next);
            if (hasFrame || bytes.IsEmpty)
                return hasFrame;
        }
    }

    /// <summary>
    /// Validates the pending bytes as if the stream ended here, and reads the next frame of them. Call it until it
    /// returns false: then no bytes are pending any more. For the end of a file, or a link that was closed or is
    /// silent; without it, what looks like the start of a long frame holds back what is behind it until enough bytes
    /// have arrived.
    /// </summary>
    /// <param name="frame">The frame; <c>default</c> where there is none.</param>
    /// <param name="info">Where it began, and whether it was checked.</param>
    /// <returns>Whether there was a frame.</returns>
    public bool TryFlush(out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        _missing = 0;
        if (TryFind(isLast: true, out ParsedHeader header))
        {
            Take(header, out frame, out info);
            return true;
        }

        _boundary = _bufferOffset + _start;
        MavlinkFrame.Clear(out frame);
        info = default;
        return false;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool TryReadNext(ref ReadOnlySpan<byte> bytes, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        _missing = 0;
        while (true)
        {
            bool hasBadChecksum = false;
            ParsedHeader header;
            if (_start == _end)
            {
                if (TryFindInPlace(ref bytes, out header, out hasBadChecksum))
                {
                    Deliver(header, bytes, out frame, out info);
                    ConsumeInPlace(ref bytes, header.Length);
                    _boundary = _bufferOffset + _start;
                    return true;
                }

                _needed = BytesNeededFor(header);
            }

            if (_end - _start >= _needed && TryFind(isLast: false, out header))
            {
                Take(header, out frame, out info);
                return true;
            }

            if (bytes.IsEmpty)
                break;
            Fill(ref bytes);
            if (hasBadChecksum)
                _scanned = _start + 1;
        }

        if (_start != _end)
            _missing = Math.Min(_needed - (_end - _start), BufferLength - _end + 1);
        MavlinkFrame.Clear(out frame);
        info = default;
        return false;
    }

    // The common case, while nothing is held back: a whole valid frame in the caller's bytes, which need no copy to be
    // validated. Everything else is copied to the buffer first; 'hasBadChecksum': the checksum there is known to be
    // wrong.
    private bool TryFindInPlace(ref ReadOnlySpan<byte> bytes, out ParsedHeader header, out bool hasBadChecksum)
    {
        hasBadChecksum = false;
        if (!bytes.IsEmpty && bytes[0] is not (WireFormat.MagicV2 or WireFormat.MagicV1))
        {
            int skipped = bytes.IndexOfAny(WireFormat.MagicV2, WireFormat.MagicV1);
            skipped = skipped < 0 ? bytes.Length : skipped;
            _skippedBytes += skipped;
            ConsumeInPlace(ref bytes, skipped);
        }

        header = ParsedHeader.Parse(bytes, _messages);
        if (header.Kind != HeaderKind.KnownMessage || header.Length > bytes.Length || header.HasUnknownFlags)
            return false;
        hasBadChecksum = !ChecksumMatches(header, bytes);
        return !hasBadChecksum;
    }

    // While nothing is held back, the empty buffer is the position in the stream.
    private void ConsumeInPlace(ref ReadOnlySpan<byte> bytes, int count)
    {
        bytes = bytes.Slice(count);
        _bufferOffset += count;
    }

    private void Fill(ref ReadOnlySpan<byte> bytes)
    {
        if (_start == _end || _end == BufferLength)
            MoveToFront();

        // No more than is needed: what is not held back can be read in place.
        int held = _end - _start;
        int wanted = held < _needed ? _needed - held : WireFormat.MaxFrameLength;
        int count = Math.Min(Math.Min(bytes.Length, wanted), BufferLength - _end);
        Append(bytes.Slice(0, count));
        bytes = bytes.Slice(count);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Append(ReadOnlySpan<byte> bytes)
    {
        if (bytes.Length == 1)
            _buffer[_end] = bytes[0];
        else
            bytes.CopyTo(_buffer.AsSpan(_end));
        _end += bytes.Length;
    }

    private void MoveToFront()
    {
        if (_start != _end)
            Buffer.BlockCopy(_buffer, _start, _buffer, 0, _end - _start);
        _bufferOffset += _start;
        _scanned -= _start;
        _end -= _start;
        _start = 0;
    }

    private void Take(in ParsedHeader header, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        Deliver(header, _buffer.AsSpan(_start), out frame, out info);
        Advance(header.Length);
        _boundary = _bufferOffset + _start;
    }

    private void Deliver(
        in ParsedHeader header, ReadOnlySpan<byte> bytes, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        bool isChecked = header.Kind == HeaderKind.KnownMessage;
        if (isChecked)
            _frames++;
        else
            _unknownFrames++;
        MavlinkFrame.FromWire(bytes.Slice(0, header.Length), out frame);
        info = new MavlinkFrameInfo(_bufferOffset + _start, isChecked, _messages.At(header.MessageIndex));
    }
}
