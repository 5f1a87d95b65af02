using System;

namespace Rabit.Vision;

/// <summary>
/// A Huffman table of a JPEG (ITU-T T.81, annex C), made for looking up: short codes give the coefficient with them.
/// </summary>
internal sealed class HuffmanTable
{
    /// <summary>Bits that are looked up at once.</summary>
    public const int LookUpBits = 10;

    /// <summary>No symbol has such a code.</summary>
    public const int BadCode = -1;

    private const int MaxBits = 16;

    // An entry: bits 0 to 4 are to be taken from the stream, 5 to 8 zero coefficients go before, 9 to 12 are the size
    // of a number that follows; without one its value is in the upper half. 0 means that the code is longer.
    private readonly int[] _entries = new int[1 << LookUpBits];
    private readonly int[] _limit = new int[MaxBits + 1];    // first code of 16 bits that is longer than this
    private readonly int[] _offset = new int[MaxBits + 1];
    private readonly byte[] _symbols = new byte[256];

    public int[] Entries => _entries;

    /// <summary>Whether there is a table to be used.</summary>
    public bool IsSet { get; private set; }

    public static int LengthOf(int entry) => entry & 31;

    public static int RunOf(int entry) => (entry >> 5) & 15;

    public static int SizeOf(int entry) => (entry >> 9) & 15;

    public static int ValueOf(int entry) => entry >> 16;

    public void Clear() => IsSet = false;

    /// <summary>Takes over 16 counts of codes by their lengths, and the symbols; false if they are no table.</summary>
    public bool TrySet(ReadOnlySpan<byte> counts, ReadOnlySpan<byte> symbols, bool isAc)
    {
        IsSet = false;
        Array.Clear(_entries, 0, _entries.Length);
        symbols.CopyTo(_symbols);
        int code = 0;
        int next = 0;
        for (int length = 1; length <= MaxBits; length++)
        {
            _offset[length] = next - code;
            for (int count = counts[length - 1]; count > 0; count--, code++, next++)
            {
                if (code >= 1 << length || (!isAc && _symbols[next] > 15))
                    return false;
                if (length <= LookUpBits)
                    FillEntries(code, length, _symbols[next]);
            }

            _limit[length] = code << (MaxBits - length);
            code <<= 1;
        }

        IsSet = true;
        return true;
    }

    /// <summary>The entry of a code that is longer than those looked up; its first 16 bits are given.</summary>
    public int FindLong(int bits)
    {
        for (int length = LookUpBits + 1; length <= MaxBits; length++)
        {
            if (bits < _limit[length])
                return EntryOf(_symbols[(bits >> (MaxBits - length)) + _offset[length]], length);
        }

        return BadCode;
    }

    /// <summary>The number of so many bits, which is negative if its first bit is 0 (T.81, F.2.2.1).</summary>
    public static int Extend(int bits, int size) => bits < 1 << (size - 1) ? bits - (1 << size) + 1 : bits;

    private static int EntryOf(int symbol, int length) => length | ((symbol >> 4) << 5) | ((symbol & 15) << 9);

    private void FillEntries(int code, int length, int symbol)
    {
        int free = LookUpBits - length;
        int size = symbol & 15;
        for (int rest = 0; rest < 1 << free; rest++)
        {
            int entry = EntryOf(symbol, length);
            if (size > 0 && size <= free)
            {
                int value = Extend(rest >> (free - size), size);
                entry = (length + size) | ((symbol >> 4) << 5) | (value << 16);
            }

            _entries[(code << free) | rest] = entry;
        }
    }
}
