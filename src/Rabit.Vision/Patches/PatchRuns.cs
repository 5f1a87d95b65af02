using System;

namespace Rabit.Vision;

/// <summary>The runs of a picture, joined to patches while they are found: rows from the top, union and find.</summary>
internal sealed class PatchRuns
{
    private readonly PatchRun[] _runs = new PatchRun[PatchFinder.MaxRuns];
    private readonly ushort[] _redIndex = new ushort[256];
    private readonly ushort[] _greenIndex = new ushort[256];
    private readonly ushort[] _blueIndex = new ushort[256];
    private int[] _rowStarts = [];

    public int Count { get; private set; }

    public ref PatchRun this[int index] => ref _runs[index];

    /// <summary>False if there are more than fit in.</summary>
    public bool TryFind(byte[] pixels, int width, int height, PatchTable table, PictureLight light)
    {
        SetGains(light);
        if (_rowStarts.Length <= height)
            _rowStarts = new int[height + 1];
        Count = 0;
        for (int row = 0; row < height; row++)
        {
            _rowStarts[row] = Count;
            if (!TryAddRow(pixels, row, width, height, table, light))
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

    private bool TryAddRow(byte[] pixels, int row, int width, int height, PatchTable table, PictureLight light)
    {
        int down = row * PictureLight.Tiles / height;
        for (int across = 0; across < PictureLight.Tiles; across++)
        {
            var limits = new NeutralLimits(light.LevelOfTile(across, down), light.Whitest, table);
            int from = across * width / PictureLight.Tiles;
            int to = (across + 1) * width / PictureLight.Tiles;
            if (!TryAddRuns(pixels, row, row * width, from, to, table, limits))
                return false;
        }

        return true;
    }

    // The loop over all pixels.
    private unsafe bool TryAddRuns(
        byte[] pixels, int row, int rowStart, int from, int to, PatchTable table, in NeutralLimits limits)
    {
        (int weakWhite, int weakBlack) = (limits.WeakWhite, limits.WeakBlack);
        fixed (byte* begin = &pixels[rowStart * 3])
        fixed (byte* entries = table.Entries)
        fixed (ushort* reds = _redIndex, greens = _greenIndex, blues = _blueIndex)
        {
            byte* end = begin + (3 * to);
            byte* p = begin + (3 * from);
            byte current = 0;
            for (; p < end; p += 3)
            {
                byte entry = entries[reds[p[0]] | greens[p[1]] | blues[p[2]]];
                if (entry == 0)
                {
                    if (p[1] >= weakWhite)
                        entry = limits.WhiteEntry(p, table.White);
                    else if (p[1] <= weakBlack)
                        entry = limits.BlackEntry(p, table.Black);
                    if (entry == 0)
                    {
                        current = 0;
                        continue;
                    }
                }

                int column = (int)(p - begin) / 3;
                if (entry == current)
                {
                    _runs[Count - 1].Right = column;
                    continue;
                }

                if (Count == _runs.Length)
                    return false;
                current = entry;
                _runs[Count] = new PatchRun
                {
                    Row = row,
                    Left = column,
                    Right = column,
                    Weak = Count,
                    Strong = Count,
                    Entry = entry,
                };
                Count++;
            }
        }

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
