using System;
using System.Buffers.Binary;

namespace Rabit.Vision;

/// <summary>
/// The bits of a scan: reads over the zeros that are stuffed after FF, stops at a marker, and gives zeros from there.
/// </summary>
internal struct JpegBits(byte[] data, int at, int end)
{
    /// <summary>Bits that are there after <see cref="Fill"/>, at least.</summary>
    public const int Filled = 56;

    // From the top; below the valid ones there may be bits of the byte that comes next, which do no harm.
    private ulong _bits;
    private int _count;
    private int _padding;

    /// <summary>Where the next byte is; not past a marker.</summary>
    public int At { get; private set; } = at;

    public readonly int Count => _count;

    public readonly ulong Bits => _bits;

    /// <summary>Whether more bits have been taken than there are.</summary>
    public readonly bool IsOverdrawn => _count < _padding;

    public void Skip(int count)
    {
        _bits <<= count;
        _count -= count;
    }

    public void Fill()
    {
        if (end - At >= 8)
        {
            ulong next = BinaryPrimitives.ReadUInt64BigEndian(new ReadOnlySpan<byte>(data, At, 8));
            bool hasFF = ((~next - 0x0101010101010101) & next & 0x8080808080808080) != 0;
            if (!hasFF)
            {
                _bits |= next >> _count;
                At += (63 - _count) >> 3;
                _count |= Filled;
                return;
            }
        }

        FillByBytes();
    }

    /// <summary>Drops what is left of a byte, and passes a marker that must come next; false if it does not.</summary>
    public bool TryPassMarker(int wanted)
    {
        (_bits, _count, _padding) = (0, 0, 0);
        int marker = FindMarker();
        if (marker != wanted)
            return false;
        At += 2;
        return true;
    }

    /// <summary>Goes to the next marker, and says which; 0 if there is none.</summary>
    public int FindMarker()
    {
        for (; At < end - 1; At++)
        {
            if (data[At] == 0xFF && data[At + 1] is not (0 or 0xFF))
                return data[At + 1];
        }

        return 0;
    }

    private void FillByBytes()
    {
        // What is known of the next byte would be added twice.
        _bits = _count == 0 ? 0 : _bits >> (64 - _count) << (64 - _count);
        while (_count <= Filled)
        {
            int next = At < end ? data[At] : 0xFF;
            if (next == 0xFF)
            {
                if (At >= end - 1 || data[At + 1] != 0)
                {
                    _padding += 64 - _count;
                    _count = 64;
                    return;
                }

                At++;
            }

            At++;
            _bits |= (ulong)next << (Filled - _count);
            _count += 8;
        }
    }
}
