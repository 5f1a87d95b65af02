using System;
using System.Collections.Generic;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>How much way revisits take where lanes are long.</summary>
public class RevisitWayTests(ITestOutputHelper output)
{
    // A strip of 2 km, two lanes wide.
    private const string Strip = "[[40,-30],[40,30],[2040,30],[2040,-30]]";
    private const int Targets = 5;
    private const double MaxRatio = 1.2;

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Mission_StripOf2Km_RevisitsInPassing(int seed) => FlyStrip(seed);

    [Fact, Trait("Category", "Long")]
    public void Mission_StripOf2KmManySeeds_RevisitsInPassing()
    {
        for (int seed = 3; seed <= 20; seed++)
            FlyStrip(seed);
    }

    // The ideal is the way over the two lanes and home, without a revisit.
    private void FlyStrip(int seed)
    {
        var random = new SeededNumbers(1000 * seed); // neighbouring seeds give the same numbers, shifted
        using var rig = new MissionRig(MissionRig.Mission(area: Strip));
        for (int i = 0; i < Targets; i++)
            rig.Vehicle.Targets.Add((random.Uniform(45, 2035), random.Uniform(-29, 29), DefaultTargetClasses.Red));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd(3000));
        double flown = 0;
        for (int i = 1; i < rig.Vehicle.Path.Count; i++)
        {
            (double n, double e, _) = rig.Vehicle.Path[i - 1];
            flown += Math.Sqrt(
                Math.Pow(rig.Vehicle.Path[i].North - n, 2) + Math.Pow(rig.Vehicle.Path[i].East - e, 2));
        }

        IReadOnlyList<LaneSegment> lanes = rig.Manager.Flight!.Plan!.Lanes;
        double ideal = FlightPlan.WayAlong(lanes, default) + lanes[lanes.Count - 1].End.Length;
        output.WriteLine(rig.Story);
        output.WriteLine(FormattableString.Invariant(
            $"seed {seed}: {flown:0} m, {flown / ideal:0.000} of the ideal {ideal:0} m"));
        Assert.Equal(2, lanes.Count);
        Assert.Equal(Targets, rig.Status.Revisits);
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
        Assert.InRange(flown / ideal, 1, MaxRatio);
    }
}
