using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>
/// Several vehicles search one area: who flies what, and what becomes of it where vehicles or the radio fail.
/// </summary>
public sealed class GroupSearchTests
{
    // 10 lanes of 360 m.
    private const string Field = "[[60,-180],[60,180],[360,180],[360,-180]]";

    [Fact]
    public void Search_Three_EachFliesAThirdAndTheAreaIsSeen()
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.All(rig.Rigs, r => Assert.True(r.Status.Coverage >= 0.98, rig.Story));
        Assert.All(rig.Rigs, r => Assert.Equal(MissionOutcome.Accomplished, r.Status.Result.Outcome));
        Assert.Equal(10, Enumerable.Range(0, 3).Sum(i => rig.ShareOf(i).Count));
        Assert.All(Enumerable.Range(0, 3), i => Assert.InRange(rig.ShareOf(i).Count, 3, 5));
    }

    [Fact]
    public void Search_Three_TakesLessThanSixTenthsOfTheTimeOfOne()
    {
        using GroupRig one = Open(1);
        Assert.True(one.RunToEnd(), one.Story);
        using GroupRig three = Open(3);
        Assert.True(three.RunToEnd(), three.Story);
        Assert.True(three.Seconds < 0.6 * one.Seconds, $"{three.Seconds} s and {one.Seconds} s" + three.Story);
    }

    // Until then it takes lanes of the slow one; the way back is behind it when the others are done.
    [Fact]
    public void Search_OneIsVerySlow_TheOtherWaitsAtItsLandingPlace()
    {
        using GroupRig rig = Open(2);
        rig.Rigs[0].Vehicle.MaxSpeed = 2.5;
        StandInVehicle waiting = rig.Rigs[1].Vehicle;
        Assert.True(rig.RunUntil(() => IsWaiting(rig.Rigs[1]), 900), rig.Story);
        Assert.True(new PlanePoint(waiting.North, waiting.East).Length > 100, rig.Story);
        Assert.True(rig.RunUntil(() => rig.Rigs[1].Status.Phase == MissionPhase.Returning, 900), rig.Story);
        Assert.InRange(new PlanePoint(waiting.North, waiting.East).Length, 0, 5);
    }

    // Also where the one that waits was not the one that divides.
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void Wait_TheLastThatSearchesIsHeld_TakesOverItsLanes(int slow)
    {
        using GroupRig rig = Open(2);
        rig.Rigs[slow].Vehicle.MaxSpeed = 2.5;
        MissionRig waiting = rig.Rigs[1 - slow];
        Assert.True(rig.RunUntil(() => IsWaiting(waiting), 900), rig.Story);
        rig.Rigs[slow].Manager.Hold("test", "a stop");
        Assert.True(rig.RunUntil(() => rig.ShareOf(1 - slow).Count > 0, 5), rig.Story);
        Assert.True(rig.RunUntil(() => waiting.Status.Phase == MissionPhase.Done, 900), rig.Story);
        Assert.InRange(waiting.Status.Coverage, 0.98, 1);
    }

    [Fact]
    public void Wait_BatteryIsTooLowToTakeAnythingOver_Returns()
    {
        using GroupRig rig = Open(2);
        rig.Rigs[0].Vehicle.MaxSpeed = 2.5;
        MissionRig waiting = rig.Rigs[1];
        Assert.True(rig.RunUntil(() => IsWaiting(waiting), 900), rig.Story);
        rig.Run(10);
        double from = rig.Seconds;
        Assert.True(
            rig.RunUntil(
                () =>
                {
                    waiting.Vehicle.Battery = Math.Max(0.05, 0.45 - ((rig.Seconds - from) * 0.002));
                    return waiting.Status.Phase == MissionPhase.Returning;
                },
                110),
            rig.Story);
        Assert.InRange(rig.Seconds - from, 5, 100);
        Assert.DoesNotContain("the battery is needed", rig.Story, StringComparison.Ordinal);
        Assert.Contains("too little is left to take anything over", rig.Story, StringComparison.Ordinal);
    }

    private static bool IsWaiting(MissionRig rig)
        => rig.Status.Text?.StartsWith("our lanes are flown", StringComparison.Ordinal) == true;

    [Fact]
    public void Search_OneIsSlow_TheOthersTakeSomeOfItsLanes()
    {
        using GroupRig rig = Open(3);
        rig.Rigs[1].Vehicle.MaxSpeed = 3;
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.All(rig.Rigs, r => Assert.True(r.Status.Coverage >= 0.98, rig.Story));
        Assert.True(rig.Rigs[1].Status.LanesFlown < 3, rig.Story);
    }

    [Fact]
    public void Search_WithoutCameraAndOneIsSlow_NoLaneIsFlownTwice()
    {
        using var rig = new GroupRig(
            3, MissionRig.Mission(area: Field), change: (_, options) => options.RequiresCamera = false);
        rig.Rigs.ForEach(r => (r.Vehicle.HasCamera, r.Vehicle.CameraSees) = (false, false));
        rig.Rigs[1].Vehicle.MaxSpeed = 3;
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(10, rig.Rigs.Sum(r => r.Status.LanesFlown));
    }

    [Fact]
    public void Search_Alone_HasAllLanes()
    {
        using GroupRig rig = Open(1);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(new LaneShare(1, 0, 10), rig.ShareOf(0));
        Assert.Equal(MissionOutcome.Accomplished, rig.Rigs[0].Status.Result.Outcome);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    public void Search_OneIsLost_TheOthersTakeItsLanes(int lost)
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunUntil(() => rig.Rigs[lost].Status.LanesFlown >= 1, 300), rig.Story);
        rig.Lost.Add(lost);
        int[] left = Enumerable.Range(0, 3).Where(i => i != lost).ToArray();
        Assert.True(rig.RunUntil(() => left.Sum(i => rig.ShareOf(i).Count) == 10, 5), "within 5 s " + rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.All(left, i => Assert.True(rig.Rigs[i].Status.Coverage >= 0.98, rig.Story));
    }

    [Fact]
    public void Search_OneComesLate_TakesAShare()
    {
        using GroupRig rig = Open(3);
        rig.SwitchedOn = 2;
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.LanesFlown >= 1, 300), rig.Story);
        rig.SwitchedOn = 3;
        Assert.True(rig.RunUntil(() => rig.Rigs[2].Status.Phase == MissionPhase.TakingOff, 60), rig.Story);
        Assert.True(rig.RunUntil(() => rig.ShareOf(2).Count > 0, 5), "within 5 s " + rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.True(rig.Rigs[2].Status.LanesFlown > 0, rig.Story);
        Assert.All(rig.Rigs, r => Assert.True(r.Status.Coverage >= 0.98, rig.Story));
    }

    [Fact]
    public void Search_OneReturns_HandsItsLanesOver()
    {
        using GroupRig rig = Open(2);
        Assert.True(rig.RunUntil(() => rig.Rigs[1].Status.LanesFlown >= 1, 300), rig.Story);
        rig.Rigs[1].Vehicle.Health = new HealthReport
        {
            Level = HealthLevel.Critical,
            Advice = HealthAdvice.ReturnToLaunch,
            AdviceText = "battery",
        };
        Assert.True(rig.RunUntil(() => rig.ShareOf(0).Count == 10, 5), "within 5 s " + rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.True(rig.Rigs[0].Status.Coverage >= 0.98, rig.Story);
    }

    // Wind, or an old battery: what was enough for its lanes is not any more.
    [Fact]
    public void Search_EnergyOfOneGetsTooLittleForItsLanes_HandsSomeOverBeforeItReturns()
    {
        using GroupRig rig = Open(2);
        MissionRig weak = rig.Rigs[1];
        Assert.True(rig.RunUntil(() => weak.Status.LanesFlown >= 1, 300), rig.Story);
        int lanes = rig.ShareOf(1).Count;
        double from = rig.Seconds;
        bool isHandedOver = rig.RunUntil(
            () =>
            {
                weak.Vehicle.Battery = Math.Max(0.05, 0.6 - ((rig.Seconds - from) * 0.002));
                return rig.ShareOf(1).Count < lanes;
            },
            300);
        Assert.True(isHandedOver, rig.Story);
        Assert.Equal(MissionPhase.Searching, weak.Status.Phase);
        Assert.InRange(rig.ShareOf(1).Count, 1, lanes - 1);
        Assert.True(rig.RunUntil(() => rig.ShareOf(0).Count + rig.ShareOf(1).Count == 10, 1), rig.Story);

        // It has flown what it kept, and none of it went to and fro.
        from = rig.Seconds;
        double battery = weak.Vehicle.Battery;
        (int changes, int share) = (0, rig.ShareOf(1).Count);
        bool isReturning = rig.RunUntil(
            () =>
            {
                weak.Vehicle.Battery = Math.Max(0.05, battery - ((rig.Seconds - from) * 0.002));
                (changes, share) = (changes + (rig.ShareOf(1).Count == share ? 0 : 1), rig.ShareOf(1).Count);
                return weak.Status.Phase == MissionPhase.Returning;
            },
            600);
        Assert.True(isReturning, rig.Story);
        Assert.InRange(changes, 0, 3);
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.Phase == MissionPhase.Done, 900), rig.Story);
        Assert.InRange(rig.Rigs[0].Status.Coverage, 0.98, 1);
    }

    // Two seconds later all are ready to arm.
    [Theory]
    [InlineData(1)]
    [InlineData(2.5)]
    public void Search_OneIsCalledHomeBeforeItTakesOff_TheOthersSearchAll(double seconds)
    {
        using GroupRig rig = Open(3);
        rig.Run(seconds);
        rig.Rigs[1].Manager.ReturnToLaunch("test", "weather");
        Assert.True(rig.RunToEnd(), rig.Story);

        Assert.Equal(
            MissionFailures.NotFlown | MissionFailures.CalledOff,
            rig.Rigs[1].Status.Result.Failures & (MissionFailures.NotFlown | MissionFailures.CalledOff));
        Assert.Contains("given up before take-off", rig.Rigs[1].Status.Text);
        Assert.Equal(0, rig.ShareOf(1).Count);
        foreach (int other in new[] { 0, 2 })
        {
            Assert.Equal(MissionOutcome.Accomplished, rig.Rigs[other].Status.Result.Outcome);
            Assert.True(rig.Rigs[other].Status.Coverage >= 0.98, rig.Story);
        }
    }

    [Fact]
    public void Search_PartitionHeals_EachPartGoesOnAndOneDivisionHoldsAfterIt()
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.LanesFlown >= 1, 300), rig.Story);
        rig.Reaches = (from, to) => (from == 0) == (to == 0);
        rig.Run(20);
        Assert.Equal(1, rig.StatusOf(0).DivisionAuthor);
        Assert.Equal(10, rig.ShareOf(0).Count);
        Assert.Equal(2, rig.StatusOf(1).DivisionAuthor);
        Assert.Equal(10, rig.ShareOf(1).Count + rig.ShareOf(2).Count);
        rig.Reaches = (_, _) => true;
        Assert.True(
            rig.RunUntil(
                () => Enumerable.Range(0, 3).All(
                    i => rig.StatusOf(i).DivisionAuthor == 1 && rig.ShareOf(i).Count < 10),
                5),
            "within 5 s " + rig.Story);
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.All(rig.Rigs, r => Assert.True(r.Status.Coverage >= 0.98, rig.Story));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Search_FortyPercentLost_TheAreaIsSeen(int seed)
    {
        using GroupRig rig = Open(3, seed);
        rig.Loss = 0.4;
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.True(rig.Rigs.Max(r => r.Status.Coverage) >= 0.98, rig.Story);
    }

    // A mission file that is not the same everywhere: each searches alone, and says why.
    [Fact]
    public void Mission_OfTheOtherIsAnother_BothSaySoOnceAndShareNothing()
    {
        using var rig = new GroupRig(
            2, MissionRig.Mission(area: Field),
            missionOfTheLast: MissionRig.Mission(",\"laneHeadingDegrees\":0", Field));
        Assert.True(rig.RunUntil(() => rig.Rigs.All(r => r.Status.LanesFlown >= 1), 300), rig.Story);

        for (int i = 0; i < 2; i++)
        {
            Assert.Single(rig.Rigs[i].Decisions, d => d.Contains(
                $"vehicle {2 - i} is not of our group: the area, keepOuts, lane spacing or heading of its mission are "
                    + "others; nothing is shared with it but the air"));
            Assert.DoesNotContain(rig.Rigs[i].Decisions, d => d.Contains("is in the group"));
            Assert.Empty(rig.StatusOf(i).Members);
            Assert.Equal(rig.StatusOf(i).Lanes, rig.ShareOf(i).Count);
        }
    }

    [Theory]
    [InlineData(8, false)]
    [InlineData(12, true)]
    public void Wait_LandingPlaces_AreTenMetresApartOrNoneTakesOff(double metresApart, bool takesOff)
    {
        using var rig = new GroupRig(2, MissionRig.Mission(area: Field), homesApartMetres: metresApart);
        rig.Run(30);

        foreach (int i in Enumerable.Range(0, 2))
        {
            Assert.Equal(takesOff, rig.Rigs[i].Status.Phase != MissionPhase.WaitingForVehicle);
            if (!takesOff)
                Assert.Contains(
                    $"vehicle {2 - i} lands 8.0 m from here; at least 10.0 m are needed", rig.Rigs[i].Status.Text);
        }
    }

    [Fact]
    public void Wait_SameHeight_OnlyTheFirstTakesOff()
    {
        using GroupRig rig = OpenSameHeight();
        rig.Run(60);
        Assert.Equal(MissionPhase.Searching, rig.Rigs[0].Status.Phase);
        Assert.Equal(MissionPhase.WaitingForVehicle, rig.Rigs[1].Status.Phase);
        Assert.Contains(
            "vehicle 1 searches 0.0 m above or below our height", rig.Rigs[1].Status.Text,
            StringComparison.Ordinal);
    }

    // The second one waits for the height of the first, which has seen all by then.
    [Fact]
    public void Wait_SameHeightAndTheFirstSearchesAll_TheSecondStaysOnTheGround()
    {
        using GroupRig rig = OpenSameHeight();
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(MissionOutcome.Accomplished, rig.Rigs[0].Status.Result.Outcome);
        Assert.Equal(MissionPhase.Failed, rig.Rigs[1].Status.Phase);
        Assert.Contains("the others have searched the area", rig.Rigs[1].Status.Text, StringComparison.Ordinal);
        Assert.Equal(0, rig.Rigs[1].Vehicle.Count(VehicleCommandKind.Arm));
    }

    [Fact]
    public void Wait_SameHeightAndTheFirstReturns_TheSecondFliesTheRest()
    {
        using GroupRig rig = OpenSameHeight();
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.Coverage > 0.5, 600), rig.Story);
        rig.Rigs[0].Manager.ReturnToLaunch("test", "weather");
        Assert.True(rig.RunToEnd(), rig.Story);
        Assert.Equal(MissionOutcome.Accomplished, rig.Rigs[1].Status.Result.Outcome);
        Assert.True(rig.Rigs[1].Status.Coverage >= 0.98, rig.Story);
        Assert.InRange(rig.Rigs[1].Status.LanesFlown, 1, 6);
    }

    [Fact]
    public void Wait_SameHeightAndOneHoldsInTheAir_TheOtherDoesNotTakeOff()
    {
        using GroupRig rig = OpenSameHeight();
        (rig.Rigs[0].Vehicle.Battery, rig.Loss) = (0.1, 1);
        Assert.True(rig.RunUntil(() => rig.Rigs[1].Status.Phase == MissionPhase.Searching, 60), rig.Story);
        rig.Rigs[1].Manager.Hold("test", "look");
        rig.Run(5);
        Assert.Equal(MissionPhase.Holding, rig.Rigs[1].Status.Phase);
        rig.Loss = 0;
        rig.Run(5);
        rig.Rigs[0].Vehicle.Battery = 0.9;
        rig.Run(20);
        Assert.Equal(MissionPhase.WaitingForVehicle, rig.Rigs[0].Status.Phase);
        Assert.Contains("vehicle 2 searches 0.0 m", rig.Rigs[0].Status.Text, StringComparison.Ordinal);
    }

    // Below its layer are the others.
    [Fact]
    public void Continue_LowAndAllLanesAreFlown_ClimbsInPlaceFirst()
    {
        using GroupRig rig = Open(1);
        StandInVehicle vehicle = rig.Rigs[0].Vehicle;
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.Coverage > 0.5, 900), rig.Story);
        rig.Rigs[0].Manager.Land("test", "look");
        Assert.True(rig.RunUntil(() => vehicle.Height < 20, 60), rig.Story);
        rig.Rigs[0].Manager.Hold("test", "look");
        rig.Run(3);
        while (rig.Rigs[0].Manager.SkipLane("test", "none left") is { } skip)
        {
            Assert.True(rig.RunUntil(() => skip.Outcome != OperatorOutcome.InProgress, 3), rig.Story);
            if (skip.Outcome != OperatorOutcome.Accepted)
                break;
        }

        (double north, double east) = (vehicle.North, vehicle.East);
        rig.Rigs[0].Manager.ContinueMission("test", "on");
        Assert.True(rig.RunUntil(() => vehicle.Height > 38, 60), rig.Story);
        Assert.InRange(Math.Sqrt(Math.Pow(vehicle.North - north, 2) + Math.Pow(vehicle.East - east, 2)), 0, 5);
    }

    [Fact]
    public void Autopilot_OfOneIsLost_ItsLanesAreForTheOthers()
    {
        using GroupRig rig = Open(3);
        Assert.True(rig.RunUntil(() => rig.Rigs[0].Status.LanesFlown >= 1, 300), rig.Story);
        rig.Rigs[2].Vehicle.IsConnected = false;
        Assert.True(
            rig.RunUntil(() => Member(rig, 0, 3) is { State: GroupMemberState.Leaving, Lanes: 0 }, 12), rig.Story);
        rig.Rigs[2].Vehicle.IsConnected = true;
        Assert.True(
            rig.RunUntil(() => Member(rig, 0, 3) is { State: GroupMemberState.Available, Lanes: > 0 }, 12), rig.Story);
    }

    private static GroupMember Member(GroupRig rig, int asKnownBy, byte systemId)
        => rig.StatusOf(asKnownBy).Members.Single(m => m.SystemId == systemId);

    private static GroupRig OpenSameHeight() => new(
        2, MissionRig.Mission(area: Field),
        change: (_, options) =>
        {
            options.Group = new GroupOptions { HeightLayer = 0 };
            options.ReadyTimeout = TimeSpan.FromMinutes(30);
        });

    private static GroupRig Open(int vehicles, int seed = 1)
        => new(vehicles, MissionRig.Mission(area: Field), seed);
}
