using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>Finds the word that was probably meant.</summary>
internal static class Spelling
{
    /// <summary>
    /// The known word that is nearest to a misspelt one: at most two letters off, and by less than half of its own
    /// length, so that <c>id</c> is not found in every word of two letters. Null where none is near.
    /// </summary>
    public static string? Nearest(string misspelt, IEnumerable<string> known)
    {
        string? nearest = null;
        int nearestDistance = 3;
        foreach (string word in known)
        {
            int distance = Distance(misspelt.ToUpperInvariant(), word.ToUpperInvariant());
            if (distance < nearestDistance && 2 * distance < word.Length)
            {
                nearest = word;
                nearestDistance = distance;
            }
        }

        return nearest;
    }

    /// <summary>Letters to insert, remove or replace (V. I. Levenshtein, 1966).</summary>
    private static int Distance(string from, string to)
    {
        int[] row = Enumerable.Range(0, to.Length + 1).ToArray();
        for (int i = 1; i <= from.Length; i++)
        {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= to.Length; j++)
            {
                int replaced = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.Min(replaced, Math.Min(row[j], row[j - 1]) + 1);
            }
        }

        return row[to.Length];
    }
}
