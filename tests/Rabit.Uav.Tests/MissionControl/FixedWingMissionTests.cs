using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>
/// A mission of a fixed wing: by its pilot into the air and to the ground, one DO_REPOSITION each leg.
/// </summary>
public class FixedWingMissionTests
{
    public static readonly TheoryData<MavAutopilot> Makes = [MavAutopilot.Ardupilotmega, MavAutopilot.Px4];

    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega, 0, 0)]
    [InlineData(MavAutopilot.Px4, 0, 0)]
    [InlineData(MavAutopilot.Ardupilotmega, 6, 0)]
    [InlineData(MavAutopilot.Px4, 0, -6)]
    public void Mission_GivenOverInTheAir_SearchesAndIsLandedByItsPilot(MavAutopilot make, int north, int east)
    {
        using var rig = new WingRig(make);
        rig.Wing.Wind = (north, east);
        rig.Begun();
        Assert.Equal(MissionPhase.HandedOver, rig.RunUntil(MissionPhase.HandedOver, 1500));
        Assert.Contains("it circles over home until its pilot lands it", rig.Status.Text, StringComparison.Ordinal);
        Assert.InRange(rig.Status.Coverage, 0.98, 1);

        // Two legs for each lane, and each went out once; what else came is the return.
        Assert.True(rig.Status.LanesFlown >= 3, rig.Story);
        Assert.Equal(2 * rig.Status.LanesFlown, rig.Wing.Places.Count);
        Assert.Equal(rig.Legs, rig.Wing.Places.Count);
        Assert.Single(rig.Wing.ModeCommands);
        Assert.Empty(rig.Wing.Others);

        // Circles over home, until the pilot lands it on his runway.
        int sent = rig.Wing.Places.Count;
        rig.Run(60);
        Assert.InRange(Distance(rig), 60, 120);
        Assert.Equal(MissionOutcome.Failed, rig.Status.Result.Outcome);
        Assert.Equal(MissionFailures.NotLanded, rig.Status.Result.Failures);
        rig.Wing.SetMode((uint)PlaneMode.FlyByWireA);
        rig.Wing.Land(120, 30);
        rig.Run(5);
        Assert.Equal((MissionOutcome.Accomplished, true), (rig.Status.Result.Outcome, rig.Status.Result.HasLanded));
        Assert.InRange(rig.Status.Result.DistanceFromHomeMetres, 115, 130);
        Assert.Equal((sent, 1), (rig.Wing.Places.Count, rig.Wing.ModeCommands.Count));
    }

    [Theory]
    [MemberData(nameof(Makes))]
    public void Mission_WithoutTheOption_IsRefusedByNameAndNothingSent(MavAutopilot make)
    {
        using var rig = new WingRig(make, isAllowed: false);
        Assert.Equal(MissionPhase.Failed, rig.RunUntil(MissionPhase.Failed, 20));
        foreach (string text in new[] { "MissionControlOptions.FixedWing", "--fixed-wing", "its pilot takes off", "Hold" })
            Assert.Contains(text, rig.Status.Text, StringComparison.Ordinal);
        rig.Run(20);
        AssertNothingSent(rig);
    }

    [Theory]
    [InlineData("\"heightMetres\":60", "\"heightMetres\":20", "heightMetres is 20.0")]
    [InlineData("\"speedMetresPerSecond\":20", "\"speedMetresPerSecond\":5", "speedMetresPerSecond is 5.0")]
    [InlineData("\"fenceMarginMetres\":300", "\"fenceMarginMetres\":200", "fenceMarginMetres is 200.0; for a fixed wing "
        + "it must be at least 255.0")]
    public void Mission_ThatAFixedWingCannotFly_IsRefusedByName(string good, string bad, string expected)
    {
        using var rig = new WingRig(MavAutopilot.Px4, WingRig.Mission(t => t.Replace(good, bad)));
        Assert.Equal(MissionPhase.Failed, rig.RunUntil(MissionPhase.Failed, 20));
        Assert.Contains(expected, rig.Status.Text, StringComparison.Ordinal);
        AssertNothingSent(rig);
    }

    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega, "FBWA", "GUIDED")]
    [InlineData(MavAutopilot.Px4, "MANUAL", "AUTO.LOITER")]
    public void Begin_WaitsForHeightAndMode_AndSaysSo(MavAutopilot make, string mode, string given)
    {
        using var rig = new WingRig(make);
        rig.Run(6);
        Assert.Equal("waiting: ready: its pilot takes off", rig.Status.Text);
        rig.Wing.TakeOff(40);
        rig.Run(60);
        Assert.Equal($"waiting: in {mode}; its pilot gives it over in {given}", rig.Status.Text);
        rig.Wing.GiveOver();
        rig.Run(20);
        Assert.Equal("waiting: at 40.0 m; its pilot climbs to 50.0 m at least", rig.Status.Text);
        AssertNothingSent(rig);
        Assert.Equal((MissionPhase.WaitingForVehicle, MissionOutcome.InProgress),
            (rig.Status.Phase, rig.Status.Result.Outcome));
        rig.Wing.TakeOff(60);
        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching, 60));
        Assert.Equal(CommandAuthorityState.Free, rig.Authority.State);
        rig.Run(2);
        Assert.Equal(CommandAuthorityState.Ours, rig.Authority.State);
    }

    [Fact]
    public void Begin_ModePassedThrough_GivesNothingOver()
    {
        using var rig = new WingRig(MavAutopilot.Px4);
        rig.Run(5);
        rig.Wing.TakeOff(60);
        rig.Run(40);
        rig.Wing.GiveOver();
        rig.Run(1.2);
        rig.Wing.SetMode(Posctl);
        rig.Run(60);
        Assert.Equal(MissionPhase.WaitingForVehicle, rig.Status.Phase);
        AssertNothingSent(rig);
    }

    // The reported target stands for the answer.
    [Theory]
    [MemberData(nameof(Makes))]
    public void Legs_AnswersLost_EachIsSentOnceAllTheSame(MavAutopilot make)
    {
        using var rig = new WingRig(make);
        rig.Wing.AnswersToLose = int.MaxValue;
        rig.Begun();
        Assert.Equal(MissionPhase.HandedOver, rig.RunUntil(MissionPhase.HandedOver, 1500));
        Assert.Equal(2 * rig.Status.LanesFlown, rig.Wing.Places.Count);
        Assert.Equal(rig.Legs, rig.Wing.Places.Count);
        Assert.InRange(rig.Status.Coverage, 0.98, 1);
    }

    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega, (uint)PlaneMode.Loiter)]
    [InlineData(MavAutopilot.Ardupilotmega, (uint)PlaneMode.FlyByWireA)]
    [InlineData(MavAutopilot.Px4, Posctl)]
    [InlineData(MavAutopilot.Px4, SimulatedWing.Px4Return)]
    public void Takeover_OnALane_IsForThePilotUntilTheOperatorContinues(MavAutopilot make, uint mode)
    {
        using WingRig rig = OnLane(make);
        rig.Wing.SetMode(mode);
        rig.Run(3);
        Assert.Equal((MissionPhase.HandedOver, true), (rig.Status.Phase, rig.Status.TakenOver is not null));
        (int places, int modes) = (rig.Wing.Places.Count, rig.Wing.ModeCommands.Count);
        rig.Run(30);
        rig.Manager.ContinueMission("test", "test");   // not in the pilot's mode
        rig.Run(30);
        Assert.Contains("its pilot gives it over in", rig.Story, StringComparison.Ordinal);
        rig.Wing.GiveOver();
        rig.Run(30);
        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
        Assert.Equal((places, modes), (rig.Wing.Places.Count, rig.Wing.ModeCommands.Count));

        rig.Manager.ContinueMission("test", "test");
        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching, 20));
        Assert.Equal(MissionPhase.HandedOver, rig.RunUntil(MissionPhase.HandedOver, 1500));
        Assert.InRange(rig.Status.Coverage, 0.98, 1);
        Assert.Equal(rig.Legs, rig.Wing.Places.Count);
    }

    // Pause and resume: the hold is a circle of its own, the rest of the lane are two new legs.
    [Theory]
    [MemberData(nameof(Makes))]
    public void Operator_HoldsAndResumes_NoLegIsSentTwice(MavAutopilot make)
    {
        using WingRig rig = OnLane(make);
        int before = rig.Wing.Places.Count;
        (double north, double east) = (rig.Wing.North, rig.Wing.East);
        rig.Manager.Hold("test", "a walker");
        rig.Run(60);
        Assert.Equal((MissionPhase.Holding, before + 1), (rig.Status.Phase, rig.Wing.Places.Count));
        Assert.InRange(Math.Abs(rig.Wing.North - north), 0, 130);
        Assert.InRange(Math.Abs(rig.Wing.East - east), 0, 130);

        rig.Manager.ContinueMission("test", "clear");
        Assert.Equal(MissionPhase.HandedOver, rig.RunUntil(MissionPhase.HandedOver, 1500));
        Assert.Equal(rig.Legs + 1, rig.Wing.Places.Count);
        Assert.InRange(rig.Status.Coverage, 0.98, 1);
        Assert.Single(rig.Wing.ModeCommands);
    }

    [Theory]
    [MemberData(nameof(Makes))]
    public void Return_ByTheOperator_IsOneModeCommand(MavAutopilot make)
    {
        using WingRig rig = OnLane(make);
        int places = rig.Wing.Places.Count;
        rig.Manager.ReturnToLaunch("test", "enough");
        Assert.Equal(MissionPhase.HandedOver, rig.RunUntil(MissionPhase.HandedOver, 200));
        rig.Run(300);
        Assert.Equal((places, 1), (rig.Wing.Places.Count, rig.Wing.ModeCommands.Count));
        Assert.InRange(Distance(rig), 60, 120);
        rig.Wing.Land(100, 0);
        rig.Run(5);
        Assert.True((rig.Status.Result.Failures & MissionFailures.GivenUp) != 0);
    }

    // Its place is shown, but it circles elsewhere: what no mode and no target shows is seen by the missing progress.
    [Theory]
    [MemberData(nameof(Makes))]
    public void Leg_WithoutProgress_HoldsThenReturnsAndIsNotCommandedAgain(MavAutopilot make)
    {
        using WingRig rig = OnLane(make);
        rig.Wing.IgnoresPlaces = true;
        int flown = rig.Status.LanesFlown;
        rig.RunWhile(() => rig.Status.LanesFlown == flown);
        Assert.Equal(MissionPhase.Holding, rig.RunUntil(MissionPhase.Holding, 150));
        int places = rig.Wing.Places.Count;
        Assert.Equal(rig.Legs, places);
        Assert.Equal(MissionPhase.Returning, rig.RunUntil(MissionPhase.Returning, 30));
        Assert.Equal("no progress along the leg", rig.Status.Aborted);
        rig.Run(60);
        Assert.Equal((places + 1, 1), (rig.Wing.Places.Count, rig.Wing.ModeCommands.Count));
    }

    [Theory]
    [MemberData(nameof(Makes))]
    public void Leg_Refused_HoldsAndIsNotCommandedAgain(MavAutopilot make)
    {
        using WingRig rig = OnLane(make);
        int places = rig.Wing.Places.Count;
        rig.Wing.RefusesPlaces = MavResult.Denied;
        int flown = rig.Status.LanesFlown;
        rig.RunWhile(() => rig.Status.LanesFlown == flown);
        rig.Run(1);
        Assert.Equal(MissionPhase.Holding, rig.Status.Phase);
        Assert.Contains(
            "the leg was not accepted: refused: DO_REPOSITION: DENIED", rig.Status.Text, StringComparison.Ordinal);
        rig.Run(60);
        Assert.Equal(rig.Legs, places + 1);
        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
    }

    [Theory]
    [MemberData(nameof(Makes))]
    public void OtherCommander_InTheSameMode_TakesOver(MavAutopilot make)
    {
        using WingRig rig = OnLane(make);
        rig.Wing.SendElsewhere(0, 0);
        rig.Run(3);
        Assert.Equal((MissionPhase.HandedOver, TakeoverCause.OtherCommander), (rig.Status.Phase, rig.Authority.Cause));
        int sent = rig.Wing.Places.Count + rig.Wing.ModeCommands.Count;
        rig.Run(60);
        Assert.Equal(sent, rig.Wing.Places.Count + rig.Wing.ModeCommands.Count);
    }

    // Short: the leg goes on, and nothing is sent again. Longer: it circles at the end of its leg, and is returned.
    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega, 8, false)]
    [InlineData(MavAutopilot.Px4, 8, false)]
    [InlineData(MavAutopilot.Ardupilotmega, 150, true)]
    [InlineData(MavAutopilot.Px4, 150, true)]
    public void LinkLoss_OnALane_SendsNoLegTwice(MavAutopilot make, double seconds, bool returns)
    {
        using WingRig rig = OnLane(make);
        int before = rig.Wing.Places.Count;
        rig.Wing.HasLink = false;
        rig.Run(seconds);
        rig.Wing.HasLink = true;
        rig.Run(4);
        Assert.Equal(before, rig.Wing.Places.Count);
        Assert.Equal(returns ? MissionPhase.Returning : MissionPhase.Searching, rig.Status.Phase);
        Assert.Equal(MissionPhase.HandedOver, rig.RunUntil(MissionPhase.HandedOver, 1500));
        Assert.Equal(rig.Legs, rig.Wing.Places.Count);
        Assert.Single(rig.Wing.ModeCommands);
        Assert.Equal(returns, rig.Status.Coverage < 0.98);
    }

    private const uint Posctl = 0x0003_0000;

    private static WingRig OnLane(MavAutopilot make)
    {
        WingRig rig = new WingRig(make).Begun();

        // Two legs each: the second one of the second lane.
        rig.RunWhile(() => rig.Wing.Places.Count < 4);
        Assert.Equal(1, rig.Status.LanesFlown);
        rig.Run(5);
        return rig;
    }

    private static void AssertNothingSent(WingRig rig)
    {
        Assert.Empty(rig.Wing.Places);
        Assert.Empty(rig.Wing.ModeCommands);
        Assert.Empty(rig.Wing.Others);
    }

    private static double Distance(WingRig rig)
        => Math.Sqrt((rig.Wing.North * rig.Wing.North) + (rig.Wing.East * rig.Wing.East));
}
