using System;
using System.IO;
using OrderBugSearch;
using Rabit.Core.Tests.Reactors;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Samples;

/// <summary>
/// The planted order bug of samples/OrderBugSearch is found by a seed, replayed by it, and gone when it is fixed.
/// </summary>
public sealed class OrderBugSearchTests(ITestOutputHelper output)
{
    private const int Seeds = 1000;

    [Fact, Trait("Clause", "5.2")]
    public void Search_PlantedBug_IsFoundAndReplayedByItsSeed()
    {
        FailingSeed? found = SeedSearch.Find(1, Seeds, time => PumpHouse.Run(time, isFixed: false));

        Assert.NotNull(found);
        output.WriteLine(found.ToString());
        Assert.IsType<PumpHouseException>(found.Failure);
        string log = Replay(found.Seed);
        Assert.Equal(log, Replay(found.Seed));
        Assert.Equal([], EventLogCheck.FindFaults(log));
        Assert.Equal(3, log.Split(["valve: missed 1 of what the button did"], StringSplitOptions.None).Length - 1);
    }

    /// <summary>All three presses are missed in one run of 64; the bound is three standard deviations.</summary>
    [Fact, Trait("Clause", "5.2")]
    public void Search_PlantedBug_IsAsRareAsChanceHasIt()
    {
        int failed = 0;
        for (int seed = 1; seed <= Seeds; seed++)
        {
            if (SeedSearch.Find(seed, 1, time => PumpHouse.Run(time, isFixed: false)) is not null)
                failed++;
        }

        output.WriteLine($"{failed} of {Seeds} seeds fail");
        Assert.InRange(failed, 4, 28);
    }

    [Fact, Trait("Clause", "5.2")]
    public void Search_AfterTheFix_FindsNothing()
        => Assert.Null(SeedSearch.Find(1, Seeds, time => PumpHouse.Run(time, isFixed: true)));

    private static string Replay(long seed)
    {
        using var log = new StringWriter();
        Assert.Throws<PumpHouseException>(
            () => PumpHouse.Run(new VirtualTime(seed) { EventLog = log }, isFixed: false));
        return log.ToString();
    }
}
