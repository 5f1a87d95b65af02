using System;
#if NET
using System.Numerics;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
#endif

namespace Rabit.Vision;

/// <summary>
/// The regions of a picture that are darker than what is around them: runs of dark pixels in a row, joined where they
/// touch (also at a corner) by union-find. Memory of the picture with most of them; for one thread.
/// </summary>
internal sealed class DarkRegions
{
    // As many as a picture of natural ground has; with more it grows.
    private const int FirstRuns = 1 << 14;

    private Run[] _runs = new Run[FirstRuns];
    private byte[] _levels = [];
    private int _count;

    /// <summary>Runs, in the order of rows and columns.</summary>
    public ReadOnlySpan<Run> Runs => new(_runs, 0, _count);

    /// <summary>Finds the regions of a picture.</summary>
    public void Find(ReadOnlySpan<byte> grey, int width, int height, LocalThreshold threshold)
    {
        int padded = threshold.Columns * LocalThreshold.TileSide;
        if (_levels.Length < padded)
            _levels = new byte[padded];
        _count = 0;
        int above = 0;
        for (int row = 0; row < height; row++)
        {
            if (row % LocalThreshold.TileSide == 0)
                Expand(threshold.Levels.AsSpan(row / LocalThreshold.TileSide * threshold.Columns, threshold.Columns));
            int first = _count;
            if (_runs.Length - _count < (width / 2) + 1)
                Array.Resize(ref _runs, Math.Max(2 * _runs.Length, _count + width));
            AddRuns(grey.Slice(row * width, width), row);
            Join(above, first);
            above = first;
        }
    }

    /// <summary>The run that stands for the region of a run: the first of the region.</summary>
    public int RootOf(int run)
    {
        Run[] runs = _runs;
        while (runs[run].Parent != run)
        {
            runs[run].Parent = runs[runs[run].Parent].Parent;
            run = runs[run].Parent;
        }

        return run;
    }

    private void Expand(ReadOnlySpan<byte> levels)
    {
        byte[] to = _levels;
        for (int i = 0; i < levels.Length; i++)
        {
            byte level = levels[i];
            int at = i * 4;
            to[at] = level;
            to[at + 1] = level;
            to[at + 2] = level;
            to[at + 3] = level;
        }
    }

    private void AddRuns(ReadOnlySpan<byte> grey, int row)
    {
        int left = -1;
        int column = 0;
#if NET
        if (Vector128.IsHardwareAccelerated)
        {
            ref byte pixels = ref MemoryMarshal.GetReference(grey);
            ref byte levels = ref MemoryMarshal.GetArrayDataReference(_levels);
            for (; column <= grey.Length - Vector128<byte>.Count; column += Vector128<byte>.Count)
            {
                uint dark = Vector128.LessThan(
                    Vector128.LoadUnsafe(ref pixels, (nuint)column),
                    Vector128.LoadUnsafe(ref levels, (nuint)column)).ExtractMostSignificantBits();

                // A bit wherever dark begins or ends.
                uint changes = (dark ^ ((dark << 1) | (left >= 0 ? 1u : 0))) & 0xFFFF;
                for (; changes != 0; changes &= changes - 1)
                    Change(column + BitOperations.TrailingZeroCount(changes), row, ref left);
            }
        }
#endif
        byte[] limits = _levels;
        for (; column < grey.Length; column++)
        {
            if (grey[column] < limits[column] != left >= 0)
                Change(column, row, ref left);
        }

        if (left >= 0)
            Change(grey.Length, row, ref left);
    }

    private void Change(int column, int row, ref int left)
    {
        if (left < 0)
        {
            left = column;
            return;
        }

        ref Run run = ref _runs[_count];
        (run.Row, run.Left, run.Right, run.Parent) = (row, left, column - 1, _count);
        run.Box = new RegionBox(left, row, column - 1, row);
        run.Pixels = column - left;
        _count++;
        left = -1;
    }

    // Both rows from left to right, as in a merge.
    private void Join(int above, int first)
    {
        Run[] runs = _runs;
        int a = above;
        for (int b = first; b < _count; b++)
        {
            int left = runs[b].Left - 1;
            int right = runs[b].Right + 1;
            while (a < first && runs[a].Right < left)
                a++;
            for (int c = a; c < first && runs[c].Left <= right; c++)
                Unite(b, c);
        }
    }

    private void Unite(int a, int b)
    {
        a = RootOf(a);
        b = RootOf(b);
        if (a == b)
            return;
        if (a > b)
            (a, b) = (b, a);
        _runs[b].Parent = a;
        _runs[a].Box = _runs[a].Box.With(_runs[b].Box);
        _runs[a].Pixels += _runs[b].Pixels;
    }

    /// <summary>
    /// Dark pixels side by side; box and number of pixels are those of the region, and true of its root.
    /// </summary>
    public struct Run
    {
        public int Row;
        public int Left;
        public int Right;
        public int Parent;
        public int Pixels;
        public RegionBox Box;
    }
}
