using System;

namespace Rabit.Core.Diagnostics;

/// <summary>
/// Makes one line of a text that a user or an exception gave: logs and results are read line by line.
/// </summary>
internal static class OneLine
{
    /// <summary>The text with spaces for its breaks.</summary>
    public static string Of(string text) => text.AsSpan().IndexOfAny('\r', '\n') < 0
        ? text
        : text.Replace("\r\n", " ").Replace('\r', ' ').Replace('\n', ' ');
}
