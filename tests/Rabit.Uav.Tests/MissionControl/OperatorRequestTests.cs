using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>What each request of the operator does, and its answer.</summary>
public class OperatorRequestTests
{
    [Fact]
    public void Request_CarriedOut_IsAcceptedAndLoggedWithItsNameAndReason()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        OperatorRequest hold = rig.Manager.Hold("console", "a walker");
        Assert.Equal((OperatorOutcome.InProgress, ""), (hold.Outcome, hold.Answer));
        rig.Run(1);
        Assert.Equal(OperatorOutcome.Accepted, hold.Outcome);
        Assert.Contains("operator console: hold, a walker", rig.Story, StringComparison.Ordinal);
        Assert.Contains("operator console's hold accepted", rig.Story, StringComparison.Ordinal);
    }

    [Fact]
    public void Requests_SeveralAtOnce_AreCarriedOutInTheirOrderAndEachAnswered()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        OperatorRequest[] requests =
        [
            rig.Manager.ReturnToLaunch("a", "1"), rig.Manager.ContinueMission("b", "2"), rig.Manager.Hold("a", "3"),
            rig.Manager.ContinueMission("b", "4"),
        ];
        rig.Run(1);
        Assert.Equal(
            [OperatorOutcome.Accepted, OperatorOutcome.Refused, OperatorOutcome.Accepted, OperatorOutcome.Accepted],
            requests.Select(r => r.Outcome));
        Assert.Equal("it returns: a hold comes first", requests[1].Answer);
        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching, 60));
    }

    // It was asked for before the takeover, and must not take the command back from who took it.
    [Fact]
    public void Requests_WaitingAtATakeover_AreRefused()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.IsConnected = false;
        rig.Run(5);
        OperatorRequest[] requests = [rig.Manager.Hold("test", "1"), rig.Manager.ReturnToLaunch("test", "2")];
        rig.Run(1);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Vehicle.IsConnected = true;
        rig.Run(5);
        Assert.All(requests, r => Assert.Equal("the command was taken away", r.Answer));
        Assert.Equal(MissionPhase.HandedOver, rig.Status.Phase);
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.TakeControl));
    }

    [Fact]
    public void Requests_TooManyInALinkLoss_AreRefusedAndTheReturnWaits()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.IsConnected = false;
        rig.Run(5);
        OperatorRequest goHome = rig.Manager.ReturnToLaunch("test", "home");
        OperatorRequest[] others = [.. Enumerable.Range(0, 40).Select(i => rig.Manager.Hold("test", "more " + i))];
        rig.Run(1);
        Assert.Equal(9, others.Count(o => o.Outcome == OperatorOutcome.Refused));
        rig.Run(15);
        Assert.All(others, o => Assert.Equal(OperatorOutcome.Refused, o.Outcome));
        Assert.Equal(OperatorOutcome.InProgress, goHome.Outcome);
        rig.Vehicle.IsConnected = true;
        rig.Run(3);
        Assert.Equal((OperatorOutcome.Accepted, MissionPhase.Returning), (goHome.Outcome, rig.Status.Phase));
    }

    [Fact]
    public void Request_WithoutAMissionOrAfterTheEnd_IsRefused()
    {
        using (var rig = new MissionRig(null))
            Assert.Equal("there is no mission", rig.Manager.Land("test", "test").Answer);
        MissionRig ended = MissionRig.In(MissionPhase.WaitingForVehicle);
        ended.Dispose();
        Assert.Equal("the program ends", ended.Manager.Hold("test", "test").Answer);
    }

    [Theory]
    [InlineData(MissionPhase.TakingOff)]
    [InlineData(MissionPhase.InTransit)]
    [InlineData(MissionPhase.Searching)]
    [InlineData(MissionPhase.Revisiting)]
    [InlineData(MissionPhase.Returning)]
    public void Land_InTheAir_LandsWhereItIs(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Run(2);
        OperatorRequest land = rig.Manager.Land("test", "a storm");
        rig.Run(1);
        Assert.Equal((OperatorOutcome.Accepted, MissionPhase.Landing), (land.Outcome, rig.Status.Phase));
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Land));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal("a storm", rig.Status.Aborted);
    }

    [Fact]
    public void SkipLane_InALane_LeavesItOutForGood()
    {
        using MissionRig rig = new(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(10);
        OperatorRequest skip = rig.Manager.SkipLane("test", "a crane");
        rig.Run(1);
        Assert.Equal((OperatorOutcome.Accepted, MissionPhase.InTransit), (skip.Outcome, rig.Status.Phase));
        Assert.Equal((1, 1), (rig.Status.LanesSkipped, rig.Status.LanesFlown));
        int from = rig.Vehicle.Commands.Count;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.InRange(rig.Status.Coverage, 0.4, 0.95);
        Assert.Equal(MissionFailures.AreaNotSeen, rig.Status.Result.Failures);

        // Neither the rest of the lane, at N 75, nor gaps of it are flown.
        double edge = Place(90, 0).Latitude.Degrees;
        Assert.All(
            rig.Vehicle.Commands.Skip(from).Where(c => c.Command.Kind == VehicleCommandKind.GoTo),
            c => Assert.True(c.Command.Latitude.Degrees > edge));
    }

    [Fact]
    public void SkipLane_Held_LeavesOutTheNextLane()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.InTransit);
        rig.Manager.Hold("test", "wait");
        rig.Run(2);
        OperatorRequest skip = rig.Manager.SkipLane("test", "a crane");
        rig.Run(1);
        Assert.Equal((OperatorOutcome.Accepted, MissionPhase.Holding, 1),
            (skip.Outcome, rig.Status.Phase, rig.Status.LanesSkipped));
        for (int i = 0; i < 5; i++)
            skip = rig.Manager.SkipLane("test", "all of them");
        rig.Run(1);
        Assert.Equal("no lane is left", skip.Answer);
    }

    [Fact]
    public void Revisit_ATargetThatWasRevisited_FliesThereAgainAndGoesOn()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Revisiting);
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(8);
        OperatorRequest revisit = rig.Manager.Revisit(1, "test", "is it a tent?");
        rig.Run(1);
        Assert.Equal((OperatorOutcome.Accepted, MissionPhase.Revisiting), (revisit.Outcome, rig.Status.Phase));
        int from = rig.Vehicle.Path.Count;
        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching, 120));
        Assert.Contains(
            rig.Vehicle.Path.Skip(from), p => Math.Abs(p.North - 80) < 3 && Math.Abs(p.East + 30) < 3);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal((MissionOutcome.Accomplished, 1), (rig.Status.Result.Outcome, rig.Status.Revisits));
    }

    [Fact]
    public void RevisitPlace_InTheFence_IsFlownOver()
    {
        using MissionRig rig = new(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(5);
        OperatorRequest revisit = rig.Manager.RevisitPlace(Place(100, 20), "test", "smoke");
        rig.Run(1);
        Assert.Equal((OperatorOutcome.Accepted, MissionPhase.Revisiting), (revisit.Outcome, rig.Status.Phase));
        int from = rig.Vehicle.Path.Count;
        Assert.Equal(MissionPhase.Searching, rig.RunUntil(MissionPhase.Searching, 120));
        Assert.Contains(
            rig.Vehicle.Path.Skip(from), p => Math.Abs(p.North - 100) < 3 && Math.Abs(p.East - 20) < 3);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal((0, 0), (rig.Status.Revisits, rig.Status.RevisitsFailed));
    }

    [Fact]
    public void Revisit_WhatCannotBe_IsRefusedByName()
    {
        using MissionRig rig = new(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        OperatorRequest[] requests =
        [
            rig.Manager.RevisitPlace(Place(2000, 0), "test", "far"), rig.Manager.Revisit(9, "test", "none"),
            rig.Manager.Confirm(9, "test", "none"), rig.Manager.ChangeSpeed(21, "test", "fast"),
            rig.Manager.ChangeSpeed(double.NaN, "test", "fast"),
        ];
        rig.Run(1);
        Assert.Equal(
            ["it is at the fence or outside", "there is no track 9", "there is no track 9",
                "speedMetresPerSecond is 21; it must be 0.5 to 20", "speedMetresPerSecond is NaN; it must be 0.5 to 20"],
            requests.Select(r => r.Answer));
    }

    [Fact]
    public void Reject_TheTargetThatIsRevisited_EndsTheRevisit()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Revisiting);
        OperatorRequest reject = rig.Manager.Reject(1, "test", "a car");
        rig.Run(2);
        Assert.Equal((OperatorOutcome.Accepted, MissionPhase.Searching), (reject.Outcome, rig.Status.Phase));
        Assert.Equal((0, 1), (rig.Status.TracksConfirmed, rig.Status.TracksRejected));
        OperatorRequest revisit = rig.Manager.Revisit(1, "test", "again");
        rig.Run(1);
        Assert.Equal("track 1 was rejected", revisit.Answer);
        OperatorRequest confirm = rig.Manager.Confirm(1, "test", "it is one");
        rig.Run(1);
        Assert.Equal((OperatorOutcome.Accepted, 1), (confirm.Outcome, rig.Status.TracksConfirmed));
    }

    [Fact]
    public void Reject_SensorFusionSilent_IsRefused()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Revisiting);
        rig.Vehicle.IgnoresDecisions = true;
        OperatorRequest reject = rig.Manager.Reject(1, "test", "a car");
        rig.Run(1);
        Assert.Equal(OperatorOutcome.InProgress, reject.Outcome);
        rig.Run(5);
        Assert.Equal("Sensor Fusion does not answer", reject.Answer);
    }

    [Theory]
    [InlineData(3)]
    [InlineData(0.5)]
    [InlineData(12)]
    public void ChangeSpeed_InALane_IsFlownAtOnceAndToTheEnd(double speed)
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Run(6);
        OperatorRequest change = rig.Manager.ChangeSpeed(speed, "test", "to see more");
        rig.Run(6);
        Assert.Equal(OperatorOutcome.Accepted, change.Outcome);
        Assert.Equal(speed, rig.Vehicle.Commands[rig.Vehicle.Commands.Count - 1].Command.SpeedMetresPerSecond);
        Assert.Equal(MissionPhase.Done, rig.RunToEnd(6000));
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
    }

    [Fact]
    public void Land_AfterATakeover_IsRefusedAndNothingIsCommanded()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode LOITER");
        rig.Run(2);
        int commands = rig.Vehicle.Commands.Count;
        OperatorRequest[] requests =
        [
            rig.Manager.Land("test", "1"), rig.Manager.SkipLane("test", "2"), rig.Manager.Revisit(1, "test", "3"),
            rig.Manager.ChangeSpeed(5, "test", "4"),
        ];
        rig.Run(5);
        Assert.All(requests, r => Assert.Equal(
            "the command is not ours: hold, return or continue takes it", r.Answer));
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
    }

    [Fact]
    public void Continue_HeldWithoutAPlan_IsRefused()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        (rig.Vehicle.IsArmed, rig.Vehicle.Height, rig.Vehicle.North) = (true, 30, 80);
        rig.Run(5);
        rig.Manager.Hold("test", "after a restart");
        rig.Run(3);
        Assert.Equal(MissionPhase.Holding, rig.Status.Phase);
        OperatorRequest request = rig.Manager.ContinueMission("test", "on");
        rig.Run(3);
        Assert.Equal(MissionPhase.Holding, rig.Status.Phase);
        Assert.Equal("where home is, is not known without the progress of the flight", request.Answer);
    }

    private static GeodeticPosition Place(double north, double east)
        => LocalNedFrame.IgnoringGeoid(MissionRig.Home).ToGeodetic(new NedPosition(north, east, 0));
}
