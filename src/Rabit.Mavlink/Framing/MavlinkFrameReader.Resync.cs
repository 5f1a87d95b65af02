using System;
using Rabit.Mavlink.Framing;

namespace Rabit.Mavlink;

// Resynchronisation: how the reader finds the next frame among the bytes held, and where it continues after an invalid
// one.
public sealed partial class MavlinkFrameReader
{
    // Stream offset right behind the last frame: a frame that begins here needs no other evidence.
    private long _boundary;

    // Finds the next frame among the bytes held; it begins at _start then.
    private bool TryFind(bool isLast, out ParsedHeader header)
    {
        while (SkipToStartByte())
        {
            ReadOnlySpan<byte> rest = _buffer.AsSpan(_start, _end - _start);
            header = ParsedHeader.Parse(rest, _messages);
            ValidationResult result = Validate(header, rest, isLast);
            if (result == ValidationResult.Valid && !header.HasUnknownFlags)
                return true;
            if (result == ValidationResult.NeedsMoreBytes)
            {
                _needed = BytesNeededFor(header);
                return false;
            }

            if (result == ValidationResult.Valid)
                Drop(header);
            else
                Skip(header, rest.Length);
        }

        header = default;
        return false;
    }

    // A frame of an unknown id gives way to a frame inside it, which may have arrived long before the whole of it has.
    private static int BytesNeededFor(in ParsedHeader header)
        => header.Kind == HeaderKind.UnknownMessage ? 0 : header.Length;

    // A frame with an unknown incompatibility flag may mean anything: it is dropped whole.
    private void Drop(in ParsedHeader header)
    {
        _incompatibleFrames++;
        Advance(header.Length);
        _boundary = _bufferOffset + _start;
    }

    private void Skip(in ParsedHeader header, int bytesHeld)
    {
        bool isWhole = _policy == MavlinkInvalidFramePolicy.SkipFrame && header.Kind != HeaderKind.NotAFrame;
        int count = isWhole ? Math.Min(header.Length, bytesHeld) : 1;
        _skippedBytes += count;
        Advance(count);
    }

    private bool SkipToStartByte()
    {
        if (_start < _end && _buffer[_start] is WireFormat.MagicV2 or WireFormat.MagicV1)
            return true;
        int skipped = _buffer.AsSpan(_start, _end - _start).IndexOfAny(WireFormat.MagicV2, WireFormat.MagicV1);
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
        if (_scanned >= _start)
            return;
        _scanned = _start;
        _frameFound = false;
    }
}
