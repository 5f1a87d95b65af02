using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>What vehicles of a group do where one is not in its layer.</summary>
public sealed class GroupGiveWayTests
{
    private const string Field = "[[60,-180],[60,180],[360,180],[360,-180]]";
    private const double HomesApartMetres = 20;
    private const double SeparationMetres = 30;

    [Fact]
    public void Land_AnotherOnePassesBelow_WaitsUntilItHasPassed()
    {
        using GroupRig rig = Open();
        Place(rig, ahead: 0, height: null);
        rig.Run(0.5);   // its position is reported
        StandInVehicle above = rig.Rigs[1].Vehicle;
        int before = above.Count(VehicleCommandKind.Hold);
        rig.Rigs[1].Manager.Land("test", "weather");

        Assert.True(rig.RunUntil(() => above.Count(VehicleCommandKind.Land) > 0, 12), rig.Story);

        Assert.Equal(before + 1, above.Count(VehicleCommandKind.Hold));
        Assert.True(Apart(rig) >= SeparationMetres, $"{Apart(rig):0} m: {rig.Story}");
    }

    [Fact]
    public void Land_AnotherOneStaysBelow_DoesNotWaitForLong()
    {
        using GroupRig rig = Open();
        rig.Rigs[0].Manager.Hold("test", "look");
        rig.Run(5);
        Place(rig, ahead: 0, height: null);
        double from = rig.Seconds;
        rig.Rigs[1].Manager.Land("test", "weather");

        Assert.True(rig.RunUntil(() => rig.Rigs[1].Vehicle.Count(VehicleCommandKind.Land) > 0, 12), rig.Story);

        Assert.InRange(rig.Seconds - from, 9, 12);
    }

    // One that flies another mission is in the same air.
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Way_AnotherOneIsHeldInIt_IsLeftAndFlownInTheEnd(bool hasAnotherMission)
    {
        using GroupRig rig = Open(hasAnotherMission);
        rig.Rigs[1].Manager.Hold("test", "look");
        Place(rig, ahead: 90, height: rig.Rigs[0].Vehicle.Height);

        double nearest = double.PositiveInfinity;
        bool hasLeft = rig.RunUntil(
            () =>
            {
                nearest = Math.Min(nearest, Apart(rig));
                return Says(rig, 0, "is left: vehicle 2 stays in the way");
            },
            120);
        Assert.True(hasLeft, rig.Story);
        Assert.True(nearest >= SeparationMetres, $"{nearest:0} m: {rig.Story}");

        rig.Rigs[1].Manager.ContinueMission("test", "go on");
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.All(rig.Rigs, r => Assert.Equal(MissionOutcome.Accomplished, r.Status.Result.Outcome));
    }

    [Fact]
    public void Way_TheOtherOneGoesOn_IsFlownOn()
    {
        using GroupRig rig = Open();
        rig.Rigs[1].Manager.Hold("test", "look");
        Place(rig, ahead: 90, height: rig.Rigs[0].Vehicle.Height);
        Assert.True(rig.RunUntil(() => Says(rig, 0, "gives way to vehicle 2"), 20), rig.Story);
        rig.Rigs[1].Manager.ContinueMission("test", "go on");

        Assert.True(rig.RunUntil(() => Says(rig, 0, "vehicle 2 is out of the way"), 25), rig.Story);
        Assert.DoesNotContain(rig.Rigs[0].Decisions, d => d.Contains("stays in the way"));
        Assert.True(rig.RunToEnd(), rig.Story);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void TakeOff_AnotherOneIsHeldOverThePlace_WaitsUntilItIsGone(bool hasAnotherMission)
    {
        using GroupRig rig = Create(hasAnotherMission);
        rig.SwitchedOn = 1;
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.Phase == MissionPhase.Searching, 100), rig.Story);
        rig.Rigs[0].Manager.Hold("test", "look");
        rig.Run(5);
        StandInVehicle held = rig.Rigs[0].Vehicle;
        (held.North, held.East) = (0, HomesApartMetres + 5);
        rig.SwitchedOn = 2;
        rig.Run(30);
        Assert.Equal(MissionPhase.WaitingForVehicle, rig.Rigs[1].Status.Phase);
        Assert.Contains("vehicle 1 flies over this place, in the way of the climb", rig.Rigs[1].Status.Text);

        rig.Rigs[0].Manager.ContinueMission("test", "go on");
        Assert.True(rig.RunUntil(() => rig.Rigs[1].Status.Phase == MissionPhase.Searching, 100), rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
    }

    private static GroupRig Create(bool hasAnotherMission) => new(
        2, MissionRig.Mission(area: Field),
        missionOfTheLast: hasAnotherMission ? MissionRig.Mission(",\"laneHeadingDegrees\":0", Field) : null);

    // Both search, the first one on a lane for some time yet.
    private static GroupRig Open(bool hasAnotherMission = false)
    {
        GroupRig rig = Create(hasAnotherMission);
        bool isReady = rig.RunUntil(
            () => rig.Rigs.All(r => r.Status.Phase == MissionPhase.Searching)
                && Math.Abs(rig.Rigs[0].Vehicle.East) < 60 && SpeedOf(rig) > 4,
            200);
        Assert.True(isReady, rig.Story);
        return rig;
    }

    // The second one is in front of the first one, or above it.
    private static void Place(GroupRig rig, double ahead, double? height)
    {
        (StandInVehicle first, StandInVehicle second) = (rig.Rigs[0].Vehicle, rig.Rigs[1].Vehicle);
        List<(double North, double East, double Height)> path = first.Path;
        double sign = Math.Sign(path[path.Count - 1].East - path[path.Count - 10].East);
        second.North = first.North;
        second.East = first.East - HomesApartMetres + (sign * ahead);
        second.Height = height ?? second.Height;
    }

    private static double SpeedOf(GroupRig rig)
    {
        List<(double North, double East, double Height)> path = rig.Rigs[0].Vehicle.Path;
        return path.Count < 21 ? 0 : Math.Abs(path[path.Count - 1].East - path[path.Count - 21].East);
    }

    private static double Apart(GroupRig rig)
    {
        (StandInVehicle first, StandInVehicle second) = (rig.Rigs[0].Vehicle, rig.Rigs[1].Vehicle);
        double east = first.East - second.East - HomesApartMetres;
        return new PlanePoint(first.North - second.North, east).Length;
    }

    private static bool Says(GroupRig rig, int vehicle, string text)
        => rig.Rigs[vehicle].Decisions.Any(d => d.Contains(text));
}
