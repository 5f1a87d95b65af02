using System.Collections.Generic;
using System.Linq;
using System.Text;
using Spectre.Console;

namespace UavConsole;

/// <summary>The lines of a map with their colours.</summary>
internal static class MapMarkup
{
    public static IReadOnlyList<string> Lines(MapPicture map)
        => [.. Enumerable.Range(0, map.Lines.Count).Select(row => Line(map, row))];

    private static string Line(MapPicture map, int row)
    {
        string line = map.Lines[row];
        var text = new StringBuilder();
        for (int first = 0; first < line.Length;)
        {
            int end = first + 1;
            while (end < line.Length && map.InkAt(end, row) == map.InkAt(first, row))
                end++;
            text.Append('[').Append(ScreenInk.Style(map.InkAt(first, row))).Append(']')
                .Append(Markup.Escape(line.Substring(first, end - first))).Append("[/]");
            first = end;
        }

        return text.ToString();
    }
}
