using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>A lane that one vehicle leaves out at the operator's command is flown by none of the group.</summary>
public sealed class GroupSkipTests
{
    // 5 lanes of 360 m to the east, 60 m apart: what is beside one is not seen from the next.
    private const string Field = "[[60,-180],[60,180],[360,180],[360,-180]]";

    // Who turns at the end of the lane beside it, or is on its way, is over it for a moment.
    private const double MaxAlongMetres = 60;

    [Theory]
    [InlineData(0)]
    [InlineData(0.4)]
    public void SkipLane_OfOneThatThenReturns_IsNotFlownByTheOthers(double loss)
    {
        using GroupRig rig = Open(3);
        rig.Loss = loss;
        double lane = SkipWithin(rig, 0);
        rig.Run(2);
        rig.Rigs[0].Manager.ReturnToLaunch("test", "battery");
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.All(Enumerable.Range(1, 2), i => Assert.True(Along(rig, i, lane, 0) < MaxAlongMetres, rig.Story));
        Assert.InRange(rig.Rigs[1].Status.Coverage, 0.75, 0.97);
        Assert.Contains("the operator commanded another vehicle so", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void SkipLane_BalanceGivesLanesAway_IsNotFlownByAnother()
    {
        using GroupRig rig = Open(2);
        double lane = SkipWithin(rig, 1);
        rig.Rigs[1].Vehicle.MaxSpeed = 1;
        Assert.True(rig.RunToEnd(4000), rig.Story);
        Assert.True(Along(rig, 0, lane, 0) < MaxAlongMetres, rig.Story);
        Assert.True(Along(rig, 0, lane + 60, 0) + Along(rig, 0, lane - 60, 0) > 300, rig.Story);
    }

    [Fact]
    public void SkipLane_InAPartition_IsLeftOutByAllOnceItHeals()
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.LanesFlown >= 1, 300), rig.Story);
        rig.Reaches = (from, to) => (from == 0) == (to == 0);
        rig.Run(6);
        double lane = SkipWithin(rig, 0);
        rig.Run(1);
        rig.Reaches = (_, _) => true;
        rig.Run(2);
        rig.Rigs[0].Manager.ReturnToLaunch("test", "battery");
        double[] before = [.. rig.Rigs.Select((_, i) => Along(rig, i, lane, 0))];
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.All(
            Enumerable.Range(0, 3),
            i => Assert.True(Along(rig, i, lane, 0) - before[i] < MaxAlongMetres, rig.Story));
        Assert.Equal(1, rig.Rigs.Sum(r => r.Status.LanesSkipped));
    }

    [Fact]
    public void SkipLane_AnotherVehicleComesLater_LearnsOfIt()
    {
        using GroupRig rig = Open(2);
        rig.SwitchedOn = 1;
        double lane = SkipWithin(rig, 0);
        rig.SwitchedOn = 2;
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.True(rig.Rigs[1].Status.LanesFlown > 0, rig.Story);
        Assert.True(Along(rig, 1, lane, 0) < MaxAlongMetres, rig.Story);
    }

    // What is received late, or was awarded before it was known.
    [Fact]
    public void SkippedLane_IsBeingFlown_IsLeftAtOnceAndTheNextOneBegins()
    {
        using GroupRig rig = Open(1);
        Assert.True(rig.RunUntil(() => IsOnLane(rig, 0), 300), rig.Story);
        double lane = LaneOf(rig, 0);
        int number = (int)Math.Round((lane - 90) / 60);
        var skipped = new ushort[5];
        skipped[number] = ushort.MaxValue;
        int from = rig.Rigs[0].Vehicle.Path.Count;
        rig.Inject(0, 9, new LaneCoverage
        {
            LanesKey = MissionFingerprint.OfLanes(Mission()),
            Parts = [.. new ushort[5]],
            Skipped = [.. skipped],
        });
        rig.Run(8);
        Assert.True(Along(rig, 0, lane, from) < MaxAlongMetres, rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.InRange(rig.Rigs[0].Status.Coverage, 0.75, 0.95);
        Assert.True(Along(rig, 0, lane, from) < MaxAlongMetres, rig.Story);
    }

    // The vehicle leaves a lane out in the middle of it.
    private static double SkipWithin(GroupRig rig, int vehicle)
    {
        Assert.True(rig.RunUntil(() => IsOnLane(rig, vehicle), 300), rig.Story);
        double lane = LaneOf(rig, vehicle);
        OperatorRequest skip = rig.Rigs[vehicle].Manager.SkipLane("test", "a crane");
        Assert.True(rig.RunUntil(() => skip.Outcome == OperatorOutcome.Accepted, 3), rig.Story);
        return lane;
    }

    private static bool IsOnLane(GroupRig rig, int vehicle)
    {
        StandInVehicle at = rig.Rigs[vehicle].Vehicle;
        return rig.Rigs[vehicle].Status.Phase == MissionPhase.Searching && Math.Abs(at.North - LaneOf(rig, vehicle)) < 2
            && Math.Abs(at.East + (20 * vehicle)) < 60;
    }

    private static double LaneOf(GroupRig rig, int vehicle)
        => 90 + (60 * Math.Round((rig.Rigs[vehicle].Vehicle.North - 90) / 60));

    // How far a vehicle has flown along a lane.
    private static double Along(GroupRig rig, int vehicle, double lane, int from)
    {
        List<(double North, double East)> path = rig.Rigs[vehicle].Vehicle.Path.Skip(from)
            .Select(p => (p.North, p.East)).ToList();
        return path.Zip(path.Skip(1), (a, b) => (a, b))
            .Where(s => Math.Abs(s.a.North - lane) < 4 && Math.Abs(s.b.North - lane) < 4)
            .Sum(s => Math.Abs(s.b.East - s.a.East));
    }

    private static GroupRig Open(int vehicles) => new(
        vehicles, Mission(),
        change: (number, o) => o.Group = new GroupOptions { HeightLayer = number, LayerSpacingMetres = 19 });

    private static MissionPlan Mission() => MissionPlan.Parse(
        MissionRig.Text(", \"requiredCoverage\": 0.7", Field).Replace("\"heightMetres\":40", "\"heightMetres\":50")
            .Replace("\"laneSpacingMetres\":30", "\"laneSpacingMetres\":60"),
        "test");
}
