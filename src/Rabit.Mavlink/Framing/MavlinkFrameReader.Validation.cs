using System;
using Rabit.Mavlink.Framing;

namespace Rabit.Mavlink;

// Whether a header begins a frame. The result depends on the bytes alone, never on how they were divided into chunks.
public sealed partial class MavlinkFrameReader
{
    private enum ValidationResult
    {
        NeedsMoreBytes,
        Valid,
        Invalid,
    }

    // No checked frame begins in [_start, _scanned); one begins at _scanned where _frameFound is true. Thanks to these
    // two no position is put through the checksum more than once, whatever a hostile stream contains.
    private int _scanned;
    private bool _frameFound;

    private ValidationResult Validate(in ParsedHeader header, ReadOnlySpan<byte> rest, bool isLast)
        => header.Kind switch
        {
            HeaderKind.Incomplete => NeedsMoreUnless(isLast),
            HeaderKind.KnownMessage =>
                header.Length > rest.Length ? NeedsMoreUnless(isLast) : ValidateChecksum(header, rest),
            HeaderKind.UnknownMessage => ValidateUnknown(header.Length, isLast),
            _ => ValidationResult.Invalid,
        };

    private bool ChecksumMatches(in ParsedHeader header, ReadOnlySpan<byte> bytes)
    {
        _checksumBytes += header.Length;
        return header.ChecksumMatches(bytes);
    }

    private static ValidationResult NeedsMoreUnless(bool isLast)
        => isLast ? ValidationResult.Invalid : ValidationResult.NeedsMoreBytes;

    private ValidationResult ValidateChecksum(in ParsedHeader header, ReadOnlySpan<byte> rest)
    {
        if (_start == _scanned && (_frameFound || ChecksumMatches(header, rest)))
            return ValidationResult.Valid;
        _badChecksums++;
        return ValidationResult.Invalid;
    }

    // A frame of an unknown id proves nothing by itself. It gives way to any frame that is proved by its checksum and
    // begins inside it, and it has to be next to another frame: right behind the last one, or right before the next.
    private ValidationResult ValidateUnknown(int length, bool isLast)
    {
        ValidationResult result = ValidateNeighbours(length, isLast);
        if (result == ValidationResult.Invalid)
            _rejectedUnknown++;
        return result;
    }

    private ValidationResult ValidateNeighbours(int length, bool isLast)
    {
        int next = _start + length;
        if (_policy == MavlinkInvalidFramePolicy.NextByte)
        {
            if (!TryScanTo(next, isLast))
                return ValidationResult.NeedsMoreBytes;
            if (_frameFound && _scanned < next)
                return ValidationResult.Invalid;
        }

        if (next > _end)
            return NeedsMoreUnless(isLast);
        if (_bufferOffset + _start == _boundary)
            return ValidationResult.Valid;
        if (next == _end)
            return isLast ? ValidationResult.Valid : ValidationResult.NeedsMoreBytes;
        return _buffer[next] is WireFormat.MagicV2 or WireFormat.MagicV1
            ? ValidationResult.Valid
            : ValidationResult.Invalid;
    }

    // Scans for the first checked frame that begins behind _start and before 'limit'. False: more bytes are needed.
    private bool TryScanTo(int limit, bool isLast)
    {
        if (_scanned == _start)
            _scanned++;
        limit = Math.Min(limit, _end);
        while (!_frameFound && _scanned < limit)
        {
            int step = _buffer.AsSpan(_scanned, limit - _scanned).IndexOfAny(WireFormat.MagicV2, WireFormat.MagicV1);
            if (step < 0)
            {
                _scanned = limit;
                return true;
            }

            _scanned += step;
            ReadOnlySpan<byte> rest = _buffer.AsSpan(_scanned, _end - _scanned);
            ParsedHeader header = ParsedHeader.Parse(rest, _messages);
            if (header.Kind == HeaderKind.KnownMessage && header.Length <= rest.Length)
                _frameFound = ChecksumMatches(header, rest);
            else if (!isLast && header.Kind is HeaderKind.KnownMessage or HeaderKind.Incomplete)
                return false;
            if (!_frameFound)
                _scanned++;
        }

        return true;
    }
}
