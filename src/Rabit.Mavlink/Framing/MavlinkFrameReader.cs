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

    private readonly MavlinkDialect _dialect;
    private readonly byte[] _buffer = new byte[BufferLength];

    // The bytes held: [_start, _end). _bufferOffset is the stream offset of _buffer[0].
    private int _start;
    private int _end;
    private long _bufferOffset;

    // Stream offset right behind the last frame: what begins here needs no other sign that it is one.
    private long _boundary;

    private long _skippedBytes;
    private long _frames;
    private long _unknownFrames;
    private long _incompatibleFrames;
    private long _badChecksums;

    /// <summary>Makes a reader.</summary>
    /// <param name="dialect">The messages it can check. Ids outside it are delivered unchecked.</param>
    /// <exception cref="ArgumentNullException">No dialect.</exception>
    public MavlinkFrameReader(MavlinkDialect dialect) => _dialect = dialect ?? throw new ArgumentNullException(nameof(dialect));

    /// <summary>What it has seen so far.</summary>
    public MavlinkReaderCounters Counters =>
        new(_bufferOffset + _end, _skippedBytes, _frames, _unknownFrames, _incompatibleFrames, _badChecksums);

    /// <summary>How many bytes wait for more before they can be judged; at most 560.</summary>
    public int PendingBytes => _end - _start;

    /// <summary>Takes the next frame out of the stream. Call it until it returns false: then all bytes given have been taken in.</summary>
    /// <param name="bytes">The next bytes of the stream; moved on behind those that were taken in.</param>
    /// <param name="frame">The frame; <c>default</c> where there is none.</param>
    /// <param name="info">Where it began, and whether it was checked.</param>
    /// <returns>Whether there was a frame.</returns>
    public bool TryRead(ref ReadOnlySpan<byte> bytes, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        while (!TryTake(isLast: false, out frame, out info))
        {
            if (bytes.IsEmpty)
                return false;
            Fill(ref bytes);
        }
        return true;
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
        if (TryTake(isLast: true, out frame, out info))
            return true;
        _boundary = _bufferOffset + _start;
        return false;
    }

    private void Fill(ref ReadOnlySpan<byte> bytes)
    {
        if (_start == _end || _end == BufferLength)
            MoveToFront();
        int count = Math.Min(bytes.Length, BufferLength - _end);
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

    private bool TryTake(bool isLast, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        while (SkipToMagic())
        {
            ReadOnlySpan<byte> rest = _buffer.AsSpan(_start, _end - _start);
            FrameCandidate candidate = FrameCandidate.At(rest, _dialect);
            Verdict verdict = Judge(candidate, rest, isLast);
            if (verdict == Verdict.Wait)
                break;
            if (verdict == Verdict.Reject)
            {
                _skippedBytes++;
                Advance(1);
            }
            else if (Accept(candidate))
            {
                Deliver(candidate, rest, out frame, out info);
                return true;
            }
        }
        frame = default;
        info = default;
        return false;
    }

    // A frame with an incompatibility flag that is not known may mean anything: it is dropped whole.
    private bool Accept(in FrameCandidate candidate)
    {
        if (!candidate.HasUnknownFlags)
            return true;
        _incompatibleFrames++;
        Advance(candidate.Length);
        _boundary = _bufferOffset + _start;
        return false;
    }

    private void Deliver(in FrameCandidate candidate, ReadOnlySpan<byte> rest, out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        bool isChecked = candidate.Kind == CandidateKind.Checkable;
        if (isChecked)
            _frames++;
        else
            _unknownFrames++;
        MavlinkFrame.FromWire(rest.Slice(0, candidate.Length), out frame);
        info = new MavlinkFrameInfo(_bufferOffset + _start, isChecked, candidate.Message);
        Advance(candidate.Length);
        _boundary = _bufferOffset + _start;
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
        if (_probed >= _start)
            return;
        _probed = _start;
        _frameProbed = false;
    }
}
