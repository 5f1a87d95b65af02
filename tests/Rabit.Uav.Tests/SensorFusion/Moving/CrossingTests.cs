using System;
using System.Linq;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>
/// Two targets of one class that cross within 3 m every minute, for ten minutes, keep their tracks: at most one is
/// exchanged. In the manager, with two pictures a second.
/// </summary>
public sealed class CrossingTests(ITestOutputHelper output)
{
    private const int Minutes = 10;
    private const int MaxSwitches = 1;

    private static readonly TargetClassName Person = new("person");
    private static readonly TargetClassName Car = new("car");

    // Walkers at 0.8 to 1.2 m/s.
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(8)]
    [InlineData(19)]
    [InlineData(31)]
    public void Walkers_CrossStraightOn_KeepTheirTracks(int seed)
    {
        CrossingRun run = Fly(seed, Person, farMetres: 35, sigma: 0.7, clutter: 0.1, maxTurn: 0.1);
        Assert.InRange(run.MinMetres, 0, 3);
        Assert.InRange(run.Metrics.IdSwitches, 0, MaxSwitches);
        Assert.InRange(run.Metrics.Mota, 0.98, 1);
    }

    [Fact]
    public void Walkers_PairedWrongAtFirst_AreExchangedAndThatIsCounted()
    {
        CrossingRun run = Fly(2, Person, farMetres: 35, sigma: 0.7, clutter: 0.1, maxTurn: 0.1);
        Assert.InRange(run.Counters.TracksExchanged, 1, 2 * Minutes);
        Assert.Equal(0, run.Counters.MeetingsWithoutRoom);
    }

    // How many of 40 runs have more; where both turn by up to 23 degrees just where they meet, or brake, it shows less
    // who came from where.
    [Theory]
    [Trait("Category", "Long")]
    [InlineData("person", 35, 0.7, 0.1, 0.1, 0)]
    [InlineData("person", 35, 1, 0.5, 0.1, 0)]
    [InlineData("person", 35, 0.7, 0.1, 0.4, 2)]
    [InlineData("person", 35, 1, 0.5, 0.4, 2)]
    [InlineData("car", 120, 0.7, 0.1, 0.1, 1)]
    [InlineData("car", 120, 0.7, 0.1, 0.4, 0)]
    public void Targets_CrossInFortyRuns_KeepTheirTracks(
        string name, double farMetres, double sigma, double clutter, double maxTurn, int maxFailed)
    {
        CrossingRun[] runs = Enumerable.Range(1, 40)
            .Select(seed => Fly(seed, new TargetClassName(name), farMetres, sigma, clutter, maxTurn)).ToArray();
        CrossingRun[] failed = runs.Where(r => r.Metrics.IdSwitches > MaxSwitches).ToArray();
        output.WriteLine(FormattableString.Invariant(
            $"{name}, {farMetres} m, sigma {sigma} m, clutter {clutter}, turn {maxTurn}: {failed.Length} runs, ")
            + FormattableString.Invariant(
                $"switches {runs.Sum(r => r.Metrics.IdSwitches)}, MOTA {runs.Average(r => r.Metrics.Mota):0.000}; ")
            + string.Join(" ", failed.Select(r => FormattableString.Invariant($"{r.Seed}: {r.Metrics.IdSwitches}"))));
        Assert.True(failed.Length <= maxFailed, $"{failed.Length} runs");
    }

    private static CrossingRun Fly(
        int seed, TargetClassName name, double farMetres, double sigma, double clutter, double maxTurn)
    {
        using var rig = new FusionRig(o => o.TargetMotions = o.TargetMotions
            .Add(Person, TargetMotion.Walking).Add(Car, TargetMotion.Vehicle));
        var run = new CrossingRun(seed, Minutes, farMetres, nearestMetres: 3, maxTurn)
        {
            Sigma = sigma,
            Clutter = clutter,
        };
        run.Fly(rig, name);
        return run;
    }
}
