using System;

namespace Rabit.Vision;

/// <summary>A bit for each cell of a grid, 64 of a row in a word. Memory of the largest one; for one thread.</summary>
internal sealed class BitGrid
{
    private ulong[] _words = [];

    public int Rows { get; private set; }

    /// <summary>Words of a row: bits beyond the last column are 0.</summary>
    public int Words { get; private set; }

    /// <summary>Bits of the cells from 64 times the word on, the first one the lowest.</summary>
    public ref ulong this[int row, int word] => ref _words[(row * Words) + word];

    /// <summary>Makes it a grid of that size without a bit.</summary>
    public void Clear(int columns, int rows)
    {
        (Rows, Words) = (rows, (columns + 63) / 64);
        if (_words.Length < Rows * Words)
            _words = new ulong[Rows * Words];
        Array.Clear(_words, 0, Rows * Words);
    }

    /// <summary>Sets the bits of a row from one column to another one, inclusive.</summary>
    public void Set(int row, int left, int right)
    {
        (int first, int last) = (left >> 6, right >> 6);
        for (int word = first; word <= last; word++)
        {
            ulong bits = ulong.MaxValue;
            if (word == first)
                bits &= ulong.MaxValue << (left & 63);
            if (word == last)
                bits &= ulong.MaxValue >> (63 - (right & 63));
            this[row, word] |= bits;
        }
    }

    /// <summary>The bits of the cells so many columns to the right, or to the left where it is negative.</summary>
    public ulong Beside(int row, int word, int columns)
    {
        int at = (row * Words) + word;
        if (columns > 0)
        {
            ulong next = word + 1 < Words ? _words[at + 1] << (64 - columns) : 0;
            return (_words[at] >> columns) | next;
        }

        ulong before = word > 0 ? _words[at - 1] >> (64 + columns) : 0;
        return (_words[at] << -columns) | before;
    }

    /// <summary>Takes away what is outside of the columns and rows from the first ones up to the last ones.</summary>
    public void KeepWithin(int left, int top, int right, int bottom)
    {
        for (int row = 0; row < Rows; row++)
        {
            bool isOutside = row < top || row > bottom;
            for (int word = 0; word < Words; word++)
                this[row, word] &= isOutside ? 0 : Columns(word, left) & ~Columns(word, right + 1);
        }
    }

    // The bits of a word from a column on.
    private static ulong Columns(int word, int from)
    {
        int bit = from - (64 * word);
        return bit <= 0 ? ulong.MaxValue : bit > 63 ? 0 : ulong.MaxValue << bit;
    }
}
