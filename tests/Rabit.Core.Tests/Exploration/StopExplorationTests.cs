using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Reactors;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>
/// Contract 1.9 in every interleaving of the code that flies: requests to stop that race with managers that set
/// <see cref="RabitManager.DelaysStop"/> to true and to false, with the barrier and with the limit.
/// </summary>
public sealed class StopExplorationTests(ITestOutputHelper output)
{
    private static ExploredSyncPoints P => default;

    [Theory, Trait("Clause", "1.9")]
    [InlineData("Waits", 1, true, true)]
    [InlineData("Waits", 2, false, true)]
    [InlineData("EndsDelay", 2, true, true)]
    [InlineData("EndsDelay, EndsDelay", 1, true, true)]
    [InlineData("Waits, Waits, EndsDelay", 1, true, true)]
    [InlineData("Waits, EndsDelay", 2, true, false)]
    public void Requests_RacingWithDelays_StopOnceAndWaitForWhoWasInTime(
        string requests, int managers, bool hasLimit, bool isWeak)
        => AssertNoFault(requests, managers, hasLimit, isWeak);

    [Theory, Trait("Category", "Long"), Trait("Clause", "1.9")]
    [InlineData("Waits", 3, true, false)]
    [InlineData("Waits", 3, true, true)]
    [InlineData("EndsDelay, AtOnce", 2, false, true)]
    [InlineData("Waits, EndsDelay", 2, true, true)]
    public void Requests_RacingWithDelaysOfMoreManagers_StopOnceAndWaitForWhoWasInTime(
        string requests, int managers, bool hasLimit, bool isWeak)
        => AssertNoFault(requests, managers, hasLimit, isWeak);

    /// <summary>
    /// That it can fail: with a flag for each, both written before the other is read, each may miss the other.
    /// </summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Request_WithTwoFlagsInsteadOfOneWord_MissesADelay(bool areInterlocked)
    {
        int[] requested = new int[1];
        int[] delays = new int[1];
        var outcomes = new HashSet<string>(StringComparer.Ordinal);

        void Set(int[] flag)
        {
            if (areInterlocked)
                P.Exchange(ref flag[0], 1);
            else
                P.VolatileWrite(ref flag[0], 1);
        }

        ExplorationResult result = Explorer.Explore(
            new SmallModel(
                2,
                s => outcomes.Add($"{s.Note(0)} {s.Note(1)}"),
                () => { Set(delays); Record(0, P.VolatileRead(ref requested[0])); },
                () => { Set(requested); Record(1, P.VolatileRead(ref delays[0])); }),
            MemoryModel.StoreBuffers);

        // "0 0": the manager found no request and relies on it, the request found no delay and stops the run.
        Assert.Null(result.Fault);
        Assert.Equal(!areInterlocked, outcomes.Contains("0 0"));
    }

    private void AssertNoFault(string requests, int managers, bool hasLimit, bool isWeak)
    {
        StopUrgency[] urgencies = requests.Split(',')
            .Select(text => text.Trim() switch
            {
                "Waits" => StopUrgency.Waits,
                "EndsDelay" => StopUrgency.EndsDelay,
                _ => StopUrgency.AtOnce,
            })
            .ToArray();
        ExplorationResult result = Explorer.Explore(
            new StopModel(managers, urgencies, hasLimit), isWeak ? MemoryModel.Weak : MemoryModel.StoreBuffers);
        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    private static void Record(int note, int value)
        => ExploredSyncPoints.Note((note, value), s => s.Note(note) = value);
}
