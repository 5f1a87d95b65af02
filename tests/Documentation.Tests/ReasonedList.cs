using System;
using System.Collections.Generic;

namespace Rabit.Documentation.Tests;

/// <summary>A text file of entries with reasons: "entry: reason" in each line, # for a comment.</summary>
internal static class ReasonedList
{
    /// <returns>The reason of each entry.</returns>
    /// <exception cref="FormatException">A line has no reason.</exception>
    public static Dictionary<string, string> Read(string path)
    {
        var entries = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (string line in SourceFiles.Lines(path))
        {
            if (line.Trim().Length == 0 || line[0] == '#')
                continue;
            int colon = line.IndexOf(": ", StringComparison.Ordinal);
            if (colon <= 0)
                throw new FormatException($"{path}: '{line}' has no reason.");
            entries.Add(line.Substring(0, colon).Trim(), line.Substring(colon + 2).Trim());
        }

        return entries;
    }
}
