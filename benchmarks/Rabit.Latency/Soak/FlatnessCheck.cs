using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Latency.Soak;

/// <summary>
/// Whether what a process holds stays as it is: the last third of the states against the second; the first is for
/// warming up.
/// </summary>
internal static class FlatnessCheck
{
    // Threads and handles of the runtime's own (tiered compilation, the pool) come and go.
    private const int Few = 2;
    private const long HeapBytes = 256 * 1024;
    private const long ResidentBytes = 8 * 1024 * 1024;   // the compiler's, which goes on for a while

    /// <returns>What grew, in words; empty when nothing did.</returns>
    public static IReadOnlyList<string> Grown(IReadOnlyList<ProcessState> states)
    {
        int third = states.Count / 3;
        if (third < 2)
            throw new InvalidOperationException("The soak was too short to compare anything.");
        ProcessState[] before = [.. states.Skip(third).Take(third)];
        ProcessState[] after = [.. states.Skip(states.Count - third)];
        var grown = new List<string>();
        Compare(grown, "threads", before, after, s => s.Threads, Few);
        Compare(grown, "handles", before, after, s => s.Handles, Few);
        Compare(grown, "heap bytes", before, after, s => s.HeapBytes, HeapBytes);
        Compare(grown, "resident bytes", before, after, s => s.ResidentBytes, ResidentBytes);
        return grown;
    }

    private static void Compare(
        List<string> grown, string what, ProcessState[] before, ProcessState[] after, Func<ProcessState, long> value,
        long allowed)
    {
        // The lowest: threads of a run that has ended go on to exit for a moment (decision 0066); what is left behind
        // is in each state.
        long first = before.Min(value);
        long last = after.Min(value);
        if (last - first > allowed)
            grown.Add($"{what}: {first}, later {last}");
    }
}
