using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Tool.Running.Top;

/// <summary>
/// Which columns of a table have room, and how wide they are. Widths depend on all rows, shown or not.
/// </summary>
internal static class TopFit
{
    public const int Gap = 2;

    public static IReadOnlyList<(int Column, int Width)> Fit(TopTable table, int width)
    {
        var columns = table.Columns.Select((c, i) => (Column: i, Width: WidthOf(table, i))).ToList();
        while (Total(columns) > width && columns.Max(c => table.Columns[c.Column].Rank) is var rank and > 0)
            columns.RemoveAt(columns.FindLastIndex(c => table.Columns[c.Column].Rank == rank));

        // The names are cut off at last.
        int excess = Total(columns) - width;
        if (excess > 0)
            columns[0] = (columns[0].Column, Math.Max(1, columns[0].Width - excess));
        return columns;
    }

    public static string Cut(string text, int width) => text.Length <= width ? text : text[..width];

    private static int WidthOf(TopTable table, int column)
        => Math.Max(
            Math.Max(table.Columns[column].Head.Length, table.Columns[column].MinWidth),
            table.Rows.Select(r => r.Cells[column].Text.Length).DefaultIfEmpty(0).Max());

    private static int Total(IEnumerable<(int Column, int Width)> columns) => columns.Sum(c => c.Width + Gap) - Gap;
}
