using System;

namespace Rabit.Mavlink;

/// <summary>
/// Finds the frames in a byte stream, however it is cut into chunks, and loses none that is intact: a place that only looked
/// like a frame costs one byte, not the frames behind it. Fixed memory, nothing allocated per frame, bounded work per byte
/// (docs/decisions/0003-frame-reader.md says how). One reader per link; one thread at a time.
/// </summary>
/// <example>
/// <code>
/// ReadOnlySpan&lt;byte&gt; bytes = received;
/// while (reader.TryRead(ref bytes, out MavlinkFrame frame, out MavlinkFrameInfo info))
///     if (info.IsChecked &amp;&amp; frame.TryDecode(out Heartbeat heartbeat)) ...
/// </code>
/// </example>
public sealed partial class MavlinkFrameReader
{
    // A frame that cannot be checked waits for all that could begin inside it: two longest frames are the most ever held
    // back. The rest of the buffer is there so that what is held back is moved to its front seldom.
    private const int BufferLength = 4096;

    private readonly MessageTable _messages;
    private readonly MavlinkResync _resync;
    private readonly byte[] _buffer = new byte[BufferLength];

    // The bytes held: [_start, _end). _bufferOffset is the stream offset of _buffer[0].
    private int _start;
    private int _end;
    private long _bufferOffset;

    // Stream offset right behind the last frame: what begins here needs no other sign that it is one.
    private long _boundary;

    // With fewer bytes held there is nothing to judge: the frame that seems to begin here has not arrived. Zero: have a look.
    private int _needed;

    private long _skippedBytes;
    private long _frames;
    private long _unknownFrames;
    private long _incompatibleFrames;
    private long _badChecksums;
    private long _rejectedUnknown;
    private long _checksumBytes;

    /// <summary>Makes a reader.</summary>
    /// <param name="dialect">The messages it can check. Ids outside it are delivered unchecked.</param>
    /// <param name="resync">Where it goes on after bytes that only looked like a frame.</param>
    /// <exception cref="ArgumentNullException">No dialect.</exception>
    public MavlinkFrameReader(MavlinkDialect dialect, MavlinkResync resync = MavlinkResync.NextByte)
    {
        _messages = (dialect ?? throw new ArgumentNullException(nameof(dialect))).Table;
        _resync = resync;
    }

    /// <summary>What it has seen so far.</summary>
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

    /// <summary>How many bytes wait for more before they can be judged; at most 560.</summary>
    public int PendingBytes => _end - _start;

    /// <summary>Takes the next frame out of the stream. Call it until it returns false: then all bytes given have been taken in.</summary>
    /// <param name="bytes">The next bytes of the stream; moved on behind those that were taken in.</param>
    /// <param name="frame">The frame; <c>default</c> where there is none.</param>
    /// <param name="info">Where it began, and whether it was checked.</param>
    /// <returns>Whether there was a frame.</returns>
    public bool TryRead(ref ReadOnlySpan<byte> bytes, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        while (true)
        {
            bool isFalse = false;
            FrameCandidate candidate;
            if (_start == _end)
            {
                if (TryFindInPlace(ref bytes, out candidate, out isFalse))
                {
                    Deliver(candidate, bytes, out frame, out info);
                    PassInPlace(ref bytes, candidate.Length);
                    _boundary = _bufferOffset + _start;
                    return true;
                }

                _needed = NeededToJudge(candidate);
            }

            if (_end - _start >= _needed && TryFind(isLast: false, out candidate))
            {
                Take(candidate, out frame, out info);
                return true;
            }

            if (bytes.IsEmpty)
                break;
            Fill(ref bytes);
            if (isFalse)
                _probed = _start + 1;
        }

        frame = default;
        info = default;
        return false;
    }

    /// <summary>
    /// Judges what still waits as if the stream ended here, and takes the next frame out of it. Call it until it returns false:
    /// then nothing waits any more. For the end of a file or datagram, or a link that was closed or fell silent; without it, what
    /// looks like the start of a long frame holds back what is behind it until enough bytes have come.
    /// </summary>
    /// <param name="frame">The frame; <c>default</c> where there is none.</param>
    /// <param name="info">Where it began, and whether it was checked.</param>
    /// <returns>Whether there was a frame.</returns>
    public bool TryFlush(out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        if (TryFind(isLast: true, out FrameCandidate candidate))
        {
            Take(candidate, out frame, out info);
            return true;
        }

        _boundary = _bufferOffset + _start;
        frame = default;
        info = default;
        return false;
    }

    // The common case, while nothing is held back: a whole sound frame in the caller's bytes, which need no copy to be judged.
    // Everything else is copied and judged by the book; 'isFalse' says that the checksum there is known to be wrong.
    private bool TryFindInPlace(ref ReadOnlySpan<byte> bytes, out FrameCandidate candidate, out bool isFalse)
    {
        isFalse = false;
        if (!bytes.IsEmpty && bytes[0] is not (WireFormat.MagicV2 or WireFormat.MagicV1))
        {
            int skipped = bytes.IndexOfAny(WireFormat.MagicV2, WireFormat.MagicV1);
            skipped = skipped < 0 ? bytes.Length : skipped;
            _skippedBytes += skipped;
            PassInPlace(ref bytes, skipped);
        }

        candidate = FrameCandidate.At(bytes, _messages);
        if (candidate.Kind != CandidateKind.Checkable || candidate.Length > bytes.Length || candidate.HasUnknownFlags)
            return false;
        isFalse = !Checks(candidate, bytes);
        return !isFalse;
    }

    // While nothing is held back, the empty buffer stands for the place in the stream.
    private void PassInPlace(ref ReadOnlySpan<byte> bytes, int count)
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
        bytes.Slice(0, count).CopyTo(_buffer.AsSpan(_end));
        bytes = bytes.Slice(count);
        _end += count;
    }

    private void MoveToFront()
    {
        Buffer.BlockCopy(_buffer, _start, _buffer, 0, _end - _start);
        _bufferOffset += _start;
        _probed -= _start;
        _end -= _start;
        _start = 0;
    }

    // Finds the next frame among the bytes held; it begins at _start then.
    private bool TryFind(bool isLast, out FrameCandidate candidate)
    {
        while (SkipToMagic())
        {
            ReadOnlySpan<byte> rest = _buffer.AsSpan(_start, _end - _start);
            candidate = FrameCandidate.At(rest, _messages);
            Verdict verdict = Judge(candidate, rest, isLast);
            if (verdict == Verdict.Accept && !candidate.HasUnknownFlags)
                return true;
            if (verdict == Verdict.Wait)
            {
                _needed = NeededToJudge(candidate);
                return false;
            }

            if (verdict == Verdict.Accept)
                Drop(candidate);
            else
                Skip(candidate, rest.Length);
        }

        candidate = default;
        return false;
    }

    // A frame of an unknown id gives way to a frame inside it, which may be there long before the whole of it is.
    private static int NeededToJudge(in FrameCandidate candidate) => candidate.Kind == CandidateKind.Uncheckable ? 0 : candidate.Length;

    // A frame with an incompatibility flag that is not known may mean anything: it is dropped whole.
    private void Drop(in FrameCandidate candidate)
    {
        _incompatibleFrames++;
        Advance(candidate.Length);
        _boundary = _bufferOffset + _start;
    }

    private void Skip(in FrameCandidate candidate, int bytesHeld)
    {
        bool isWhole = _resync == MavlinkResync.SkipFrame && candidate.Kind != CandidateKind.NotAFrame;
        int count = isWhole ? Math.Min(candidate.Length, bytesHeld) : 1;
        _skippedBytes += count;
        Advance(count);
    }

    private void Take(in FrameCandidate candidate, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        Deliver(candidate, _buffer.AsSpan(_start), out frame, out info);
        Advance(candidate.Length);
        _boundary = _bufferOffset + _start;
    }

    private void Deliver(in FrameCandidate candidate, ReadOnlySpan<byte> bytes, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        bool isChecked = candidate.Kind == CandidateKind.Checkable;
        if (isChecked)
            _frames++;
        else
            _unknownFrames++;
        MavlinkFrame.FromWire(bytes.Slice(0, candidate.Length), out frame);
        info = new MavlinkFrameInfo(_bufferOffset + _start, isChecked, _messages.At(candidate.MessageIndex));
    }

    private bool SkipToMagic()
    {
        int skipped = _buffer.AsSpan(_start, _end - _start).IndexOfAny(WireFormat.MagicV2, WireFormat.MagicV1);
        if (skipped == 0)
            return true;
        if (skipped < 0)
            skipped = _end - _start;
        _skippedBytes += skipped;
        Advance(skipped);
        return _start < _end;
    }

    private void Advance(int count)
    {
        _start += count;
        _needed = 0;
        if (_probed >= _start)
            return;
        _probed = _start;
        _frameProbed = false;
    }
}
