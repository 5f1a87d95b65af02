using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Tool.Running.Top;

/// <summary>What woke a manager, the most frequent cause first.</summary>
internal static class WakeUpText
{
    private const int MaxCauses = 2;

    /// <param name="manager">The manager now.</param>
    /// <param name="before">
    /// Its wake-ups in the sample before; null in the first, where it is all since the start.
    /// </param>
    public static string Of(ManagerFigures manager, WakeUpFigures? before)
    {
        (string Cause, long Count)[] causes =
        [
            .. CausesOf(manager.WakeUps).Zip(CausesOf(before ?? new WakeUpFigures()))
                .Select(c => (c.First.Cause, Count: c.First.Count - c.Second.Count))
                .Where(c => c.Count > 0).OrderByDescending(c => c.Count).Take(MaxCauses),
        ];
        return string.Join(' ', causes.Select(c => before is null || manager.RunsPerSecond is not { } rate
            ? c.Cause
            : $"{c.Cause} {TopText.Rate(RateOf(c.Count, manager, before, rate))}"));
    }

    // The rate of the runs is over the same time.
    private static double RateOf(long count, ManagerFigures manager, WakeUpFigures before, double runsPerSecond)
    {
        long all = CausesOf(manager.WakeUps).Sum(c => c.Count) - CausesOf(before).Sum(c => c.Count);
        return runsPerSecond * count / Math.Max(all, 1);
    }

    private static IEnumerable<(string Cause, long Count)> CausesOf(WakeUpFigures figures) =>
    [
        ("timer", figures.Timer), ("post", figures.Post), ("push", figures.Push), ("pop", figures.Pop),
        ("request", figures.Request), ("device", figures.Device),
    ];
}
