using System;
using System.Linq;

namespace Rabit.Tool.Running;

/// <summary>Texts of other programs on a terminal: what would control it becomes a dot.</summary>
internal static class PlainText
{
    public static string Of(string text)
        => text.Any(char.IsControl) ? string.Concat(text.Select(c => char.IsControl(c) ? '.' : c)) : text;

    public static string OfLines(string text) => string.Join('\n', text.Split('\n').Select(Of));
}
