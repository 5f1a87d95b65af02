using System;
using System.Linq;
using Rabit.Uav.Messages;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>
/// A target that goes out of sight where it should be seen keeps its track; no second one is reported meanwhile. In the
/// manager, with two pictures a second.
/// </summary>
public sealed class OcclusionTests(ITestOutputHelper output)
{
    private const int Seeds = 20;

    private static readonly TargetClassName Person = new("person");
    private static readonly TargetClassName Car = new("car");

    [Theory]
    [InlineData("person", 1.4, 5, 19)]
    [InlineData("person", 1.4, 10, 19)]
    [InlineData("person", 1.4, 20, 19)]
    [InlineData("person", 1.4, 35, 19)]
    [InlineData("car", 8, 10, 19)]
    [InlineData("car", 8, 30, 19)]
    [InlineData("car", 8, 60, 19)]
    [InlineData("car", 8, 90, 18)]
    public void Target_HiddenOnItsWay_KeepsItsTrack(string name, double speed, double hiddenMetres, int least)
    {
        OcclusionRun[] runs = Enumerable.Range(1, Seeds).Select(seed => Go(seed, name, speed, hiddenMetres)).ToArray();
        int kept = runs.Count(r => r.IsKept);
        output.WriteLine(FormattableString.Invariant(
            $"{name}, {speed} m/s, hidden for {hiddenMetres} m ({runs.Average(r => r.HiddenSeconds):0.0} s), ")
            + FormattableString.Invariant($"seeds 1 to {Seeds}: kept in {kept} of {Seeds}, ")
            + FormattableString.Invariant($"pictures with two tracks {runs.Sum(r => r.Doubled)}, ")
            + FormattableString.Invariant($"found again {runs.Sum(r => r.Counters.TracksFoundAgain)}, ")
            + "not kept: " + string.Join(" ", runs.Select((r, i) => r.IsKept ? "" : $"{i + 1}").Where(s => s != "")));
        Assert.All(runs, r => Assert.True(r.IdBefore > 0));
        Assert.InRange(kept, least, Seeds);
        Assert.Equal(0, runs.Sum(r => r.Doubled));
    }

    private static OcclusionRun Go(int seed, string name, double speed, double hiddenMetres)
    {
        using var rig = new FusionRig(o => o.TargetMotions = o.TargetMotions
            .Add(Person, TargetMotion.Walking).Add(Car, TargetMotion.Vehicle));
        return new OcclusionRun(seed, rig, new TargetClassName(name), speed, hiddenMetres);
    }
}
