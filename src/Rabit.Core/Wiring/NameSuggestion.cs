using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.Wiring;

/// <summary>Ends the text about a name that is not there: with the one that was meant, perhaps.</summary>
internal static class NameSuggestion
{
    // Two mistyped characters, and no more than one in three.
    private const int MaxEdits = 2;
    private const int CharactersPerEdit = 3;

    /// <param name="name">The name that is not there.</param>
    /// <param name="names">Those that are there.</param>
    /// <param name="others">The names of the other kind: of queues where a message is missing.</param>
    /// <param name="otherKind">What those name.</param>
    /// <returns>A sentence with a space before it, or nothing.</returns>
    public static string For(string name, IEnumerable<string> names, IEnumerable<string> others, string otherKind)
    {
        if (others.Contains(name, StringComparer.Ordinal))
            return $" There is a {otherKind} '{name}'.";
        return Nearest(name, names) is { } nearest ? $" Did you mean '{nearest}'?" : string.Empty;
    }

    /// <summary>What to throw where a manager is named that has not started.</summary>
    /// <param name="name">The name that no manager has.</param>
    /// <param name="managers">Those that have started.</param>
    /// <param name="parameterName">The parameter that names it.</param>
    public static ArgumentException NotStarted(string name, IEnumerable<string> managers, string parameterName)
        => new($"No manager '{name}' has started." + For(name, managers, [], string.Empty), parameterName);

    private static string? Nearest(string name, IEnumerable<string> names)
    {
        int fewest = Math.Min(MaxEdits, name.Length / CharactersPerEdit) + 1;
        string? nearest = null;
        foreach (string other in names)
        {
            if (string.Equals(other, name, StringComparison.Ordinal))
                continue;
            int edits = string.Equals(other, name, StringComparison.OrdinalIgnoreCase) ? 0 : EditsBetween(name, other);
            if (edits >= fewest)
                continue;
            fewest = edits;
            nearest = other;
        }

        return nearest;
    }

    /// <summary>The edit distance of Levenshtein, with a swap of two neighbours as one edit.</summary>
    private static int EditsBetween(string a, string b)
    {
        int[,] edits = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++)
        {
            for (int j = 0; j <= b.Length; j++)
            {
                if (i == 0 || j == 0)
                {
                    edits[i, j] = i + j;
                    continue;
                }

                int replaced = edits[i - 1, j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
                int fewest = Math.Min(replaced, Math.Min(edits[i - 1, j], edits[i, j - 1]) + 1);
                bool isSwapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
                edits[i, j] = isSwapped ? Math.Min(fewest, edits[i - 2, j - 2] + 1) : fewest;
            }
        }

        return edits[a.Length, b.Length];
    }
}
