using System;

namespace Rabit.Vision;

/// <summary>The map of a patch: for each pixel of the box around it how far it is from the patch.</summary>
internal static class PatchDistances
{
    /// <summary>Of what is no part of it and not near it, before the distances are known.</summary>
    public const byte Far = 100;

    /// <summary>Of what is closed.</summary>
    public const byte Closed = 255;

    private const double MaxGap = 0.25;

    /// <summary>
    /// What lies between two pixels of the patch, not further apart than a quarter of its side, belongs to it: the
    /// windows of a car.
    /// </summary>
    public static void Close(byte[] map, int columns, int rows, int margin)
    {
        int own = 0;
        for (int at = 0; at < columns * rows; at++)
            own += map[at] == 0 ? 1 : 0;
        int gap = (int)(MaxGap * Math.Sqrt(own));
        if (gap < 2)
            return;
        for (int row = margin; row < rows - margin; row++)
            CloseLine(map, row * columns, 1, columns, gap);
        for (int column = margin; column < columns - margin; column++)
            CloseLine(map, column, columns, rows, gap);
    }

    /// <summary>The distance to the patch, a diagonal step as one: forth and back over the map.</summary>
    public static void Grow(byte[] map, int columns, int rows)
    {
        for (int row = 0; row < rows; row++)
        {
            for (int column = 0; column < columns; column++)
            {
                int at = (row * columns) + column;
                if (column > 0)
                    Step(map, at, at - 1);
                if (row == 0)
                    continue;
                Step(map, at, at - columns);
                if (column > 0)
                    Step(map, at, at - columns - 1);
                if (column < columns - 1)
                    Step(map, at, at - columns + 1);
            }
        }

        for (int row = rows - 1; row >= 0; row--)
        {
            for (int column = columns - 1; column >= 0; column--)
            {
                int at = (row * columns) + column;
                if (column < columns - 1)
                    Step(map, at, at + 1);
                if (row == rows - 1)
                    continue;
                Step(map, at, at + columns);
                if (column > 0)
                    Step(map, at, at + columns - 1);
                if (column < columns - 1)
                    Step(map, at, at + columns + 1);
            }
        }
    }

    private static void CloseLine(byte[] map, int start, int step, int count, int gap)
    {
        int last = int.MinValue / 2;
        for (int i = 0; i < count; i++)
        {
            if (map[start + (i * step)] != 0)
                continue;
            for (int between = last + 1; i - last - 1 <= gap && between < i; between++)
                map[start + (between * step)] = Closed;
            last = i;
        }
    }

    private static void Step(byte[] map, int at, int from)
    {
        int distance = map[from] == Closed ? 0 : map[from];
        if (map[at] != Closed && distance + 1 < map[at])
            map[at] = (byte)(distance + 1);
    }
}
