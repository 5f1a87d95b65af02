using System;
#if NET
using System.Numerics;
#endif
using System.Runtime.CompilerServices;

namespace Rabit.Vision;

/// <summary>The runs of a picture, joined to patches while they are found: rows from the top, union and find.</summary>
internal sealed class PatchRuns
{
    private readonly PatchRun[] _runs = new PatchRun[PatchFinder.MaxRuns];
    private readonly ushort[] _redIndex = new ushort[256];
    private readonly ushort[] _greenIndex = new ushort[256];
    private readonly ushort[] _blueIndex = new ushort[256];
    private readonly NeutralLimits[] _limits = new NeutralLimits[PictureLight.Tiles];
    private readonly int[] _edges = new int[PictureLight.Tiles + 1];   // columns where tiles begin
#if NET
    private readonly CandidatePixels _candidates = new();
    private ushort[] _columns = [];   // of the candidates of a row that have an entry
    private byte[] _entries = [];
    private bool _looksFirst;
#endif
    private int[] _rowStarts = [];

    public int Count { get; private set; }

    public ref PatchRun this[int index] => ref _runs[index];

    /// <summary>False if there are more than fit in.</summary>
    public bool TryFind(byte[] pixels, int width, int height, PatchTable table, PictureLight light)
    {
        SetGains(light);
#if NET
        _looksFirst = width <= ushort.MaxValue && _candidates.TrySet(light, table, width);
        if (_entries.Length < width)
            (_columns, _entries) = (new ushort[width], new byte[width]);
#endif
        for (int across = 0; across <= PictureLight.Tiles; across++)
            _edges[across] = across * width / PictureLight.Tiles;
        if (_rowStarts.Length <= height)
            _rowStarts = new int[height + 1];
        Count = 0;
        for (int row = 0; row < height; row++)
        {
            _rowStarts[row] = Count;
            if (row == 0 || row * PictureLight.Tiles / height != (row - 1) * PictureLight.Tiles / height)
                SetLimits(row * PictureLight.Tiles / height, table, light);
            if (!TryAddRow(pixels, row, width, table))
                return false;
            Join(row == 0 ? 0 : _rowStarts[row - 1], _rowStarts[row]);
        }

        _rowStarts[height] = Count;
        return true;
    }

    /// <summary>The first run of a row; of the row after the last one, how many there are.</summary>
    public int StartOf(int row) => _rowStarts[row];

    /// <summary>The first of a row that ends at a column or after it; they are in order.</summary>
    public int FirstOf(int row, int column)
    {
        (int from, int to) = (_rowStarts[row], _rowStarts[row + 1]);
        while (from < to)
        {
            int middle = (from + to) / 2;
            if (_runs[middle].Right < column)
                from = middle + 1;
            else
                to = middle;
        }

        return from;
    }

    public int WeakRootOf(int run)
    {
        while (_runs[run].Weak != run)
        {
            _runs[run].Weak = _runs[_runs[run].Weak].Weak;
            run = _runs[run].Weak;
        }

        return run;
    }

    public int StrongRootOf(int run)
    {
        while (_runs[run].Strong != run)
        {
            _runs[run].Strong = _runs[_runs[run].Strong].Strong;
            run = _runs[run].Strong;
        }

        return run;
    }

    private void SetGains(PictureLight light)
    {
        const int Shift = 8 - PatchTable.Bits;
        for (int value = 0; value < 256; value++)
        {
            int red = Math.Min(255, (int)(value * light.RedGain));
            int blue = Math.Min(255, (int)(value * light.BlueGain));
            _redIndex[value] = (ushort)((red >> Shift) << (2 * PatchTable.Bits));
            _greenIndex[value] = (ushort)((value >> Shift) << PatchTable.Bits);
            _blueIndex[value] = (ushort)(blue >> Shift);
        }
    }

    private void SetLimits(int down, PatchTable table, PictureLight light)
    {
        for (int across = 0; across < PictureLight.Tiles; across++)
        {
            _limits[across] = new NeutralLimits(light.LevelOfTile(across, down), light.Whitest, table);
#if NET
            if (_looksFirst)
                _candidates.SetLimits(_edges[across], _edges[across + 1], _limits[across]);
#endif
        }
    }

    private bool TryAddRow(byte[] pixels, int row, int width, PatchTable table)
    {
#if NET
        if (_looksFirst)
        {
            _candidates.Look(pixels.AsSpan(3 * row * width, 3 * width), width);
            return TryAddCandidates(pixels, row, row * width, table);
        }
#endif
        for (int across = 0; across < PictureLight.Tiles; across++)
        {
            if (!TryAddAll(pixels, row, row * width, _edges[across], _edges[across + 1], table, _limits[across]))
                return false;
        }

        return true;
    }

#if NET
    private bool TryAddCandidates(byte[] pixels, int row, int rowStart, PatchTable table)
    {
        int count = Classify(pixels, rowStart, table);
        (int across, int first) = (0, Count);
        for (int i = 0; i < count; i++)
        {
            int column = _columns[i];
            for (; column >= _edges[across + 1]; first = Count)
                across++;
            if (!TryAdd(row, column, _entries[i], first))
                return false;
        }

        return true;
    }

    // The candidates of a row that have an entry. Whether one has is as good as random: no branch by that.
    private unsafe int Classify(byte[] pixels, int rowStart, PatchTable table)
    {
        (int across, int count) = (0, 0);
        fixed (byte* begin = &pixels[rowStart * 3])
        fixed (byte* known = table.Entries, entries = _entries)
        fixed (ushort* reds = _redIndex, greens = _greenIndex, blues = _blueIndex, columns = _columns)
        {
            for (int word = 0; word < _candidates.Bits.Words; word++)
            {
                ulong neutral = _candidates.Neutral[0, word];
                for (ulong bits = _candidates.Bits[0, word]; bits != 0; bits &= bits - 1)
                {
                    int column = (64 * word) + BitOperations.TrailingZeroCount(bits);
                    byte* p = begin + (3 * column);
                    byte entry = known[reds[p[0]] | greens[p[1]] | blues[p[2]]];
                    if ((neutral & bits & (~bits + 1)) != 0 && entry == 0)
                    {
                        while (column >= _edges[across + 1])
                            across++;
                        entry = NeutralEntry(p, table, _limits[across]);
                    }

                    columns[count] = (ushort)column;
                    entries[count] = entry;
                    count += entry != 0 ? 1 : 0;
                }
            }
        }

        return count;
    }

#endif
    // The loop over all pixels.
    private unsafe bool TryAddAll(
        byte[] pixels, int row, int rowStart, int from, int to, PatchTable table, in NeutralLimits limits)
    {
        (int weakWhite, int weakBlack, int first) = (limits.WeakWhite, limits.WeakBlack, Count);
        fixed (byte* begin = &pixels[rowStart * 3])
        fixed (byte* entries = table.Entries)
        fixed (ushort* reds = _redIndex, greens = _greenIndex, blues = _blueIndex)
        {
            byte* end = begin + (3 * to);
            for (byte* p = begin + (3 * from); p < end; p += 3)
            {
                byte entry = entries[reds[p[0]] | greens[p[1]] | blues[p[2]]];
                if (entry == 0)
                {
                    if (p[1] < weakWhite && p[1] > weakBlack)
                        continue;
                    entry = NeutralEntry(p, table, limits);
                    if (entry == 0)
                        continue;
                }

                if (!TryAdd(row, (int)(p - begin) / 3, entry, first))
                    return false;
            }
        }

        return true;
    }

    private static unsafe byte NeutralEntry(byte* p, PatchTable table, in NeutralLimits limits)
        => p[1] >= limits.WeakWhite ? limits.WhiteEntry(p, table.White)
            : p[1] <= limits.WeakBlack ? limits.BlackEntry(p, table.Black)
            : (byte)0;

    // To the run before, if it is of the same entry and ends right before; from the first run on of this part of a row.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool TryAdd(int row, int column, byte entry, int first)
    {
        if (Count > first)
        {
            ref PatchRun last = ref _runs[Count - 1];
            if (last.Right == column - 1 && last.Entry == entry)
            {
                last.Right = column;
                return true;
            }
        }

        if (Count == _runs.Length)
            return false;
        ref PatchRun run = ref _runs[Count];
        (run.Row, run.Left, run.Right, run.Entry) = (row, column, column, entry);
        (run.Weak, run.Strong, run.WeakPixels, run.StrongPixels) = (Count, Count, 0, 0);
        Count++;
        return true;
    }

    // Both rows from left to right, as in a merge; and with the run before in the same row.
    private void Join(int above, int first)
    {
        int a = above;
        for (int b = first; b < Count; b++)
        {
            ref PatchRun run = ref _runs[b];
            if (b > first && _runs[b - 1].Right == run.Left - 1)
                Unite(b, b - 1);
            while (a < first && _runs[a].Right < run.Left - 1)
                a++;
            for (int c = a; c < first && _runs[c].Left <= run.Right + 1; c++)
                Unite(b, c);
        }
    }

    private void Unite(int a, int b)
    {
        if (_runs[a].Colour != _runs[b].Colour)
            return;
        (int weakA, int weakB) = (WeakRootOf(a), WeakRootOf(b));
        if (weakA < weakB)
            _runs[weakB].Weak = weakA;
        else
            _runs[weakA].Weak = weakB;
        if (!_runs[a].IsStrong || !_runs[b].IsStrong)
            return;
        (int strongA, int strongB) = (StrongRootOf(a), StrongRootOf(b));
        if (strongA < strongB)
            _runs[strongB].Strong = strongA;
        else
            _runs[strongA].Strong = strongB;
    }
}
