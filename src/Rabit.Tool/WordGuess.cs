using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Tool;

/// <summary>What a mistyped word was meant to be.</summary>
internal static class WordGuess
{
    /// <returns>"; did you mean 'x'?" or "." where nothing comes close.</returns>
    public static string End(string word, IEnumerable<string> known)
    {
        (string? best, int mistakes) = known
            .Select(k => (Word: (string?)k, Mistakes: Mistakes(word, k)))
            .OrderBy(k => k.Mistakes).ThenBy(k => k.Word, StringComparer.Ordinal)
            .FirstOrDefault();
        return best is not null && mistakes <= 1 + (best.TrimStart('-').Length / 4) && mistakes < word.Length
            ? $"; did you mean '{best}'?"
            : ".";
    }

    // Characters to insert, delete, replace or swap with their neighbour (optimal string alignment).
    private static int Mistakes(string a, string b)
    {
        int[,] cost = new int[a.Length + 1, b.Length + 1];
        for (int i = 0; i <= a.Length; i++)
        {
            for (int j = 0; j <= b.Length; j++)
            {
                if (i == 0 || j == 0)
                {
                    cost[i, j] = i + j;
                    continue;
                }

                int differs = a[i - 1] == b[j - 1] ? 0 : 1;
                int least = Math.Min(Math.Min(cost[i - 1, j], cost[i, j - 1]) + 1, cost[i - 1, j - 1] + differs);
                if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                    least = Math.Min(least, cost[i - 2, j - 2] + 1);
                cost[i, j] = least;
            }
        }

        return cost[a.Length, b.Length];
    }
}
