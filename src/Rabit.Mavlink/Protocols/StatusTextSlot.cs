using System;
using Rabit.Mavlink.Definitions;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Protocols;

/// <summary>The chunks of one text, as they arrive.</summary>
internal sealed class StatusTextSlot
{
    public const int MaxChunks = 32;

    private const int ChunkBytes = MavlinkStatusTextSplitter.ChunkBytes;

    private readonly byte[] _bytes = new byte[MaxChunks * ChunkBytes];
    private uint _received;
    private int _last;

    /// <summary>Whether chunks are awaited.</summary>
    public bool IsOpen { get; private set; }

    /// <summary>Whether it holds a text, which may be over: further copies of its chunks are known by it.</summary>
    public bool IsUsed { get; private set; }

    public MavlinkAddress Source { get; private set; }

    public ushort Id { get; private set; }

    public MavSeverity Severity { get; private set; }

    public TimeSpan UpdatedAt { get; private set; }

    /// <summary>Whether the last chunk has come, and all before it.</summary>
    public bool IsComplete => _last >= 0 && _received == AllUpTo(_last);

    public void Begin(MavlinkAddress source, in Statustext chunk)
    {
        (IsOpen, IsUsed, Source, Id, Severity) = (true, true, source, chunk.Id, chunk.Severity);
        (_received, _last) = (0, -1);
        Array.Clear(_bytes, 0, _bytes.Length);
    }

    public void Close() => IsOpen = false;

    public bool Has(int chunk) => (_received & (1u << chunk)) != 0;

    /// <summary>Whether a chunk is the same as the one of its number that is here.</summary>
    public bool HasSame(in Statustext chunk)
    {
        Span<byte> bytes = stackalloc byte[ChunkBytes];
        chunk.Text.CopyTo(bytes);
        return bytes.SequenceEqual(_bytes.AsSpan(chunk.ChunkSeq * ChunkBytes, ChunkBytes));
    }

    /// <summary>Whether it can be: nothing comes behind the last chunk.</summary>
    public bool Fits(in Statustext chunk)
        => _last < 0 ? !IsShort(chunk) || _received >> chunk.ChunkSeq == 0 : chunk.ChunkSeq < _last && !IsShort(chunk);

    public void Put(in Statustext chunk, TimeSpan now)
    {
        chunk.Text.CopyTo(_bytes.AsSpan(chunk.ChunkSeq * ChunkBytes, ChunkBytes));
        _received |= 1u << chunk.ChunkSeq;
        if (IsShort(chunk))
            _last = chunk.ChunkSeq;
        UpdatedAt = now;
    }

    /// <summary>The text, with "…" for what is missing.</summary>
    /// <param name="characters">Room for all bytes, and one more for each chunk and at the end.</param>
    public string Read(Span<char> characters)
    {
        int count = 0;
        int end = _last >= 0 ? _last + 1 : MaxReceived() + 1;
        for (int chunk = 0; chunk < end; chunk++)
        {
            if (!Has(chunk))
            {
                if (chunk == 0 || Has(chunk - 1))
                    characters[count++] = '…';
                continue;
            }

            int first = chunk;
            while (chunk + 1 < end && Has(chunk + 1))
                chunk++;
            ReadOnlySpan<byte> whole = Whole(
                _bytes.AsSpan(first * ChunkBytes, (chunk + 1 - first) * ChunkBytes),
                hasGapBefore: first > 0, hasGapAfter: chunk + 1 < end || _last < 0);
            count += Utf8Text.Read(whole, characters.Slice(count));
        }

        if (_last < 0)
            characters[count++] = '…';
        return characters.Slice(0, count).ToString();
    }

    // Up to its zero; without the characters that a gap has cut.
    private static ReadOnlySpan<byte> Whole(ReadOnlySpan<byte> bytes, bool hasGapBefore, bool hasGapAfter)
    {
        int zero = bytes.IndexOf((byte)0);
        if (zero >= 0)
            bytes = bytes.Slice(0, zero);
        int start = 0;
        while (hasGapBefore && start < bytes.Length && start < Utf8Text.MaxBytesOfCharacter - 1
            && Utf8Text.IsContinuation(bytes[start]))
            start++;
        bytes = bytes.Slice(start);
        for (int back = 1; hasGapAfter && back < Utf8Text.MaxBytesOfCharacter && back <= bytes.Length; back++)
        {
            byte first = bytes[bytes.Length - back];
            if (Utf8Text.IsContinuation(first))
                continue;
            return Utf8Text.LengthOf(first) > back ? bytes.Slice(0, bytes.Length - back) : bytes;
        }

        return bytes;
    }

    private int MaxReceived()
    {
        int highest = MaxChunks - 1;
        while (highest > 0 && !Has(highest))
            highest--;
        return highest;
    }

    private static bool IsShort(in Statustext chunk) => chunk.Text.Length < ChunkBytes;

    private static uint AllUpTo(int chunk) => uint.MaxValue >> (MaxChunks - 1 - chunk);
}
