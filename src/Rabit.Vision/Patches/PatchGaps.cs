using System;
using System.Numerics;

namespace Rabit.Vision;

/// <summary>What lies between two pixels of a patch: the windows of a car.</summary>
internal static class PatchGaps
{
    private const double MaxGap = 0.25;

    /// <summary>
    /// What lies between two pixels of the patch, not further apart than a quarter of its side, belongs to it. False
    /// where it is so small that nothing does.
    /// </summary>
    /// <param name="own">The pixels of the patch.</param>
    /// <param name="closed">Takes what lies between.</param>
    /// <param name="columns">Of both.</param>
    /// <param name="margin">Columns and rows at each side without a pixel of the patch.</param>
    public static bool TryClose(BitGrid own, BitGrid closed, int columns, int margin)
    {
        int gap = (int)(MaxGap * Math.Sqrt(Count(own)));
        if (gap < 2)
            return false;
        for (int row = margin; row < own.Rows - margin; row++)
        {
            CloseRow(own, closed, row, columns, gap);
            for (int word = 0; word < own.Words; word++)
                CloseUpwards(own, closed, row, word, Math.Min(gap, row - margin));
        }

        return true;
    }

    private static int Count(BitGrid own)
    {
        int count = 0;
        for (int row = 0; row < own.Rows; row++)
        {
            for (int word = 0; word < own.Words; word++)
                count += BitOperations.PopCount(own[row, word]);
        }

        return count;
    }

    private static void CloseRow(BitGrid own, BitGrid closed, int row, int columns, int gap)
    {
        int last = NextOf(own, row, 0, columns, isOwn: true);
        while (last < columns)
        {
            int end = NextOf(own, row, last, columns, isOwn: false);
            last = NextOf(own, row, end, columns, isOwn: true);
            if (last < columns && last - end <= gap)
                closed.Set(row, end, last - 1);
        }
    }

    // The next column with, or without, a pixel of the patch; the number of columns if there is none.
    private static int NextOf(BitGrid own, int row, int from, int columns, bool isOwn)
    {
        for (int word = from >> 6; word < own.Words; word++)
        {
            ulong bits = isOwn ? own[row, word] : ~own[row, word];
            if (word == from >> 6)
                bits &= ulong.MaxValue << (from & 63);
            if (bits != 0)
                return (64 * word) + BitOperations.TrailingZeroCount(bits);
        }

        return columns;
    }

    // Where a run of pixels in a column begins, up to the end of the one above it; 64 columns at a time.
    private static void CloseUpwards(BitGrid own, BitGrid closed, int row, int word, int gap)
    {
        ulong open = own[row, word] & ~own[row - 1, word];
        for (int up = 2; open != 0 && up <= gap + 1; up++)
        {
            ulong met = open & own[row - up, word];
            open &= ~met;
            for (int between = 1; met != 0 && between < up; between++)
                closed[row - between, word] |= met;
        }
    }
}
