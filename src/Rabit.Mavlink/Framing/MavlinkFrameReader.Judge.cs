using System;

namespace Rabit.Mavlink;

// How a candidate is judged. The verdict depends on the bytes alone, never on how they were cut into chunks.
public sealed partial class MavlinkFrameReader
{
    private enum Verdict
    {
        Wait,
        Accept,
        Reject,
    }

    // No checked frame begins in [_start, _probed); one begins at _probed where _frameProbed says so. Thanks to these two
    // no place is put through the checksum twice, whatever a hostile stream looks like.
    private int _probed;
    private bool _frameProbed;

    private Verdict Judge(in FrameCandidate candidate, ReadOnlySpan<byte> rest, bool isLast) => candidate.Kind switch
    {
        CandidateKind.HeaderIncomplete => WaitUnless(isLast),
        CandidateKind.Checkable => candidate.Length > rest.Length ? WaitUnless(isLast) : JudgeChecksum(candidate, rest),
        CandidateKind.Uncheckable => JudgeUncheckable(candidate.Length, isLast),
        _ => Verdict.Reject,
    };

    private bool Checks(in FrameCandidate candidate, ReadOnlySpan<byte> bytes)
    {
        _checksumBytes += candidate.Length;
        return candidate.ChecksumMatches(bytes);
    }

    private static Verdict WaitUnless(bool isLast) => isLast ? Verdict.Reject : Verdict.Wait;

    private Verdict JudgeChecksum(in FrameCandidate candidate, ReadOnlySpan<byte> rest)
    {
        if (_start == _probed && (_frameProbed || Checks(candidate, rest)))
            return Verdict.Accept;
        _badChecksums++;
        return Verdict.Reject;
    }

    // A frame of an unknown id proves nothing by itself. It gives way to any frame that is proved by its checksum and
    // begins inside it, and it has to stand beside another frame: right behind the last one, or right before the next.
    private Verdict JudgeUncheckable(int length, bool isLast)
    {
        Verdict verdict = JudgeClaim(length, isLast);
        if (verdict == Verdict.Reject)
            _rejectedUnknown++;
        return verdict;
    }

    private Verdict JudgeClaim(int length, bool isLast)
    {
        int next = _start + length;
        if (_resync == MavlinkResync.NextByte)
        {
            if (!TryProbeTo(next, isLast))
                return Verdict.Wait;
            if (_frameProbed && _probed < next)
                return Verdict.Reject;
        }

        if (next > _end)
            return WaitUnless(isLast);
        if (_bufferOffset + _start == _boundary)
            return Verdict.Accept;
        if (next == _end)
            return isLast ? Verdict.Accept : Verdict.Wait;
        return _buffer[next] is WireFormat.MagicV2 or WireFormat.MagicV1 ? Verdict.Accept : Verdict.Reject;
    }

    // Looks for the first checked frame that begins behind _start and before 'limit'. False: more bytes are needed to tell.
    private bool TryProbeTo(int limit, bool isLast)
    {
        if (_probed == _start)
            _probed++;
        limit = Math.Min(limit, _end);
        while (!_frameProbed && _probed < limit)
        {
            int step = _buffer.AsSpan(_probed, limit - _probed).IndexOfAny(WireFormat.MagicV2, WireFormat.MagicV1);
            if (step < 0)
            {
                _probed = limit;
                return true;
            }

            _probed += step;
            ReadOnlySpan<byte> rest = _buffer.AsSpan(_probed, _end - _probed);
            FrameCandidate candidate = FrameCandidate.At(rest, _messages);
            if (candidate.Kind == CandidateKind.Checkable && candidate.Length <= rest.Length)
                _frameProbed = Checks(candidate, rest);
            else if (!isLast && candidate.Kind is CandidateKind.Checkable or CandidateKind.HeaderIncomplete)
                return false;
            if (!_frameProbed)
                _probed++;
        }
        return true;
    }
}
