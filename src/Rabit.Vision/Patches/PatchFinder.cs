using System;

namespace Rabit.Vision;

/// <summary>
/// Finds patches of the colours of a table, twice: of the pixels whose colour is clear, and of all of which it is
/// possible, so that a target on ground of a like colour is a patch of its own, and a small pale one is a patch too.
/// Fixed memory; for one thread.
/// </summary>
public sealed class PatchFinder
{
    /// <summary>Maximum of runs of a picture. One with more is noise, and not ground with targets on it.</summary>
    public const int MaxRuns = 131_072;

    /// <summary>Maximum of patches of a picture, each of at least <see cref="MinPixels"/>.</summary>
    public const int MaxPatches = 16_384;

    /// <summary>Smaller ones are left out.</summary>
    public const int MinPixels = 3;

    // White is brighter than the ground by so much, by the curve of sRGB; black darker.
    private const double WeakWhite = 1.32;
    private const double StrongWhite = 1.6;
    private const double WeakBlack = 0.5;
    private const double StrongBlack = 0.36;

    // White has nearly no colour: the difference of its channels is less than that part of the strongest, of 256.
    private const int MaxWhiteChroma = 60;

    private readonly Run[] _runs = new Run[MaxRuns];
    private readonly Patch[] _patches = new Patch[MaxPatches];
    private readonly ushort[] _redIndex = new ushort[256];
    private readonly ushort[] _greenIndex = new ushort[256];
    private readonly ushort[] _blueIndex = new ushort[256];
    private int[] _rowStarts = [];
    private int _runCount;

    /// <summary>How many patches the last picture had.</summary>
    public int Count { get; private set; }

    /// <summary>The patches of the last picture.</summary>
    public ReadOnlySpan<Patch> Patches => new(_patches, 0, Count);

    /// <summary>
    /// Finds all patches; false if there are more than fit in, so that the picture was not searched. Allocates nothing
    /// after the first picture of a height.
    /// </summary>
    /// <param name="pixels">Red, green, blue, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="table">The colours.</param>
    /// <param name="light">Of this picture.</param>
    /// <exception cref="ArgumentException">The buffer is too small for the size.</exception>
    public bool TryFind(byte[] pixels, int width, int height, PatchTable table, PictureLight light)
    {
        PixelBuffer.Check(pixels, width, height);
        if (table is null)
            throw new ArgumentNullException(nameof(table));
        if (light is null)
            throw new ArgumentNullException(nameof(light));
        SetGains(light);
        if (_rowStarts.Length <= height)
            _rowStarts = new int[height + 1];
        (Count, _runCount) = (0, 0);
        for (int row = 0; row < height; row++)
        {
            _rowStarts[row] = _runCount;
            if (!TryAddRow(pixels, row, width, height, table, light))
                return false;
            Join(row == 0 ? 0 : _rowStarts[row - 1], _rowStarts[row]);
        }

        _rowStarts[height] = _runCount;
        return TryCollect();
    }

    /// <summary>Writes a mark for each pixel of a patch into a map.</summary>
    internal void Draw(in Patch patch, byte[] map, int left, int top, int stride, byte mark)
    {
        for (int row = patch.Top; row <= patch.Bottom; row++)
        {
            for (int i = FirstRun(row, patch.Left); i < _rowStarts[row + 1] && _runs[i].Left <= patch.Right; i++)
            {
                if (!IsOf(i, patch))
                    continue;
                ref Run run = ref _runs[i];
                int at = ((row - top) * stride) - left;
                for (int column = run.Left; column <= run.Right; column++)
                    map[at + column] = mark;
            }
        }
    }

    // The first of a row that ends at a column or after it; they are in order.
    private int FirstRun(int row, int column)
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

    private bool IsOf(int run, in Patch patch)
        => patch.IsStrong
            ? _runs[run].IsStrong && StrongRootOf(run) == patch.Root
            : WeakRootOf(run) == patch.Root;

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
            int level = light.LevelOfTile(across, down);
            var limits = new NeutralLimits
            {
                WeakWhite = table.White > 0 ? Math.Min(236, (int)(level * WeakWhite)) : 256,
                StrongWhite = table.White > 0 ? Math.Min(244, (int)(level * StrongWhite)) : 256,
                WeakBlack = table.Black > 0 ? (int)(level * WeakBlack) : -1,
                StrongBlack = table.Black > 0 ? (int)(level * StrongBlack) : -1,
            };
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
                        entry = WhiteEntry(p, limits, table.White);
                    else if (p[1] <= weakBlack)
                        entry = BlackEntry(p, limits, table.Black);
                    if (entry == 0)
                    {
                        current = 0;
                        continue;
                    }
                }

                int column = (int)(p - begin) / 3;
                if (entry == current)
                {
                    _runs[_runCount - 1].Right = column;
                    continue;
                }

                if (_runCount == MaxRuns)
                    return false;
                current = entry;
                _runs[_runCount] = new Run
                {
                    Row = row,
                    Left = column,
                    Right = column,
                    Weak = _runCount,
                    Strong = _runCount,
                    Entry = entry,
                };
                _runCount++;
            }
        }

        return true;
    }

    private static unsafe byte WhiteEntry(byte* p, in NeutralLimits limits, byte white)
    {
        int least = Math.Min(p[0], Math.Min(p[1], p[2]));
        int most = Math.Max(p[0], Math.Max(p[1], p[2]));
        if (least < limits.WeakWhite || (most - least) * 256 > MaxWhiteChroma * most)
            return 0;
        return least >= limits.StrongWhite ? (byte)(white | PatchTable.Strong) : white;
    }

    private static unsafe byte BlackEntry(byte* p, in NeutralLimits limits, byte black)
    {
        int most = Math.Max(p[0], Math.Max(p[1], p[2]));
        if (most > limits.WeakBlack)
            return 0;
        return most <= limits.StrongBlack ? (byte)(black | PatchTable.Strong) : black;
    }

    // Both rows from left to right, as in a merge; and with the run before in the same row.
    private void Join(int above, int first)
    {
        int a = above;
        for (int b = first; b < _runCount; b++)
        {
            ref Run run = ref _runs[b];
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

    private int WeakRootOf(int run)
    {
        while (_runs[run].Weak != run)
        {
            _runs[run].Weak = _runs[_runs[run].Weak].Weak;
            run = _runs[run].Weak;
        }

        return run;
    }

    private int StrongRootOf(int run)
    {
        while (_runs[run].Strong != run)
        {
            _runs[run].Strong = _runs[_runs[run].Strong].Strong;
            run = _runs[run].Strong;
        }

        return run;
    }

    // First how large each is, at its root; then those that are large enough.
    private bool TryCollect()
    {
        for (int i = 0; i < _runCount; i++)
        {
            _runs[WeakRootOf(i)].WeakPixels += _runs[i].Length;
            if (_runs[i].IsStrong)
                _runs[StrongRootOf(i)].StrongPixels += _runs[i].Length;
        }

        for (int i = 0; i < _runCount; i++)
        {
            int weak = WeakRootOf(i);
            if (_runs[weak].WeakPixels >= MinPixels && !TryAdd(i, weak, isStrong: false))
                return false;
            if (!_runs[i].IsStrong)
                continue;
            int strong = StrongRootOf(i);
            if (_runs[strong].StrongPixels >= MinPixels && _runs[strong].StrongPixels != _runs[weak].WeakPixels
                && !TryAdd(i, strong, isStrong: true))
                return false;
        }

        return true;
    }

    private bool TryAdd(int i, int root, bool isStrong)
    {
        ref Run run = ref _runs[i];
        if (root == i)
        {
            if (Count == MaxPatches)
                return false;
            if (isStrong)
                run.StrongPatch = Count;
            else
                run.WeakPatch = Count;
            _patches[Count++] = new Patch
            {
                Colour = run.Colour - 1,
                IsStrong = isStrong,
                Left = run.Left,
                Right = run.Right,
                Top = run.Row,
                Bottom = run.Row,
                Pixels = run.Length,
                Runs = 1,
                Root = i,
            };
            return true;
        }

        ref Patch patch = ref _patches[isStrong ? _runs[root].StrongPatch : _runs[root].WeakPatch];
        patch.Left = Math.Min(patch.Left, run.Left);
        patch.Right = Math.Max(patch.Right, run.Right);
        patch.Bottom = run.Row;
        patch.Pixels += run.Length;
        patch.Runs++;
        return true;
    }

    private struct NeutralLimits
    {
        public int WeakWhite;
        public int StrongWhite;
        public int WeakBlack;
        public int StrongBlack;
    }

    private struct Run
    {
        public int Row;
        public int Left;
        public int Right;
        public int Weak;
        public int Strong;
        public int WeakPixels;
        public int StrongPixels;
        public int WeakPatch;
        public int StrongPatch;
        public byte Entry;

        public readonly int Length => Right - Left + 1;

        public readonly int Colour => Entry & ~PatchTable.Strong;

        public readonly bool IsStrong => (Entry & PatchTable.Strong) != 0;

    }
}
