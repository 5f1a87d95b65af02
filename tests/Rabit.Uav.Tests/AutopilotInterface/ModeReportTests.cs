using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>A command that changes the mode goes out on the arrival of a report that shows ours.</summary>
public class ModeReportTests
{
    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega)]
    [InlineData(MavAutopilot.Px4)]
    public void ModeCommand_IsSentOnTheArrivalOfAReportAskedForRightBefore(MavAutopilot make)
    {
        using ScriptedAutopilot vehicle = new ScriptedAutopilot(make) { Latency = 0.05 }.Armed();
        vehicle.Run(0.03);
        int requests = vehicle.ReportRequests;
        double given = vehicle.Rig.Reactor.Now.TotalSeconds;
        vehicle.Give(VehicleCommandKind.Return);
        vehicle.Run(1);
        TimeSpan sent = vehicle.Received[vehicle.Received.Count - 1].Time;
        Assert.True(vehicle.ReportRequests > requests);
        Assert.InRange(sent.TotalSeconds - given, 0.085, 0.4);   // a round trip at least
    }

    [Theory]
    [InlineData(VehicleCommandKind.Return)]
    [InlineData(VehicleCommandKind.Land)]
    [InlineData(VehicleCommandKind.Hold)]
    [InlineData(VehicleCommandKind.Arm)]
    public void ModeCommand_PilotTookOverAMomentBefore_IsNotSent(VehicleCommandKind kind)
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        int sent = px4.Received.Count;
        px4.Mode = 0x0003_0000;   // no heartbeat has shown it yet
        VehicleCommandResult answer = px4.GiveAndRun(kind);
        Assert.Equal(VehicleCommandOutcome.NotInCommand, answer.Outcome);
        Assert.Equal(sent, px4.Received.Count);
        Assert.Equal("mode POSCTL", px4.Rig.Authority.TakenBy);
    }

    [Theory]
    [InlineData(null)]
    [InlineData(MavResult.Denied)]
    public void ModeCommand_RequestsAreNotAnswered_NextHeartbeatServes(MavResult? answer)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.ReportAnswer = answer;
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Return, seconds: 3).Outcome);
        if (answer is null)
            return;
        int requests = copter.ReportRequests;
        copter.Run(8);
        Assert.InRange(copter.ReportRequests - requests, 0, 1);   // denied: not asked again for a while
    }

    [Fact]
    public void ModeCommand_AcknowledgementsLost_IsRepeatedOnReportsOfOurModeOnly()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        int sent = copter.Received.Count;
        copter.Script = (_, _) => null;
        copter.Give(VehicleCommandKind.Return);
        copter.Run(1.2);
        Assert.Equal(2, copter.Received.Count - sent);
        copter.Mode = (uint)CopterMode.Loiter;
        copter.Run(5);
        Assert.Equal(2, copter.Received.Count - sent);
    }

    [Fact]
    public void Commanding_ReportsAreAskedForFiveTimesASecond()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        int requests = copter.ReportRequests;
        copter.Run(10);
        Assert.InRange(copter.ReportRequests - requests, 40, 55);
    }

    [Fact]
    public void Observing_NoReportIsAskedFor()
    {
        using var copter = new ScriptedAutopilot(mayCommand: false);
        copter.Run(5);
        Assert.Equal(0, copter.ReportRequests);
    }

    [Theory]
    [InlineData("Battery Failsafe")]
    [InlineData("GCS Failsafe")]
    public void Takeover_TextOfAFailsafeAroundIt_IsTheCause(string text)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Mode = (uint)CopterMode.Rtl;
        copter.Run(0.5);
        Assert.Equal(TakeoverCause.Mode, copter.Rig.Authority.Cause);
        copter.SayText(text);
        copter.Run(1);
        Assert.Equal(TakeoverCause.Failsafe, copter.Rig.Authority.Cause);
        Assert.Contains(text, copter.Rig.Authority.TakenBy, StringComparison.Ordinal);
    }

    [Fact]
    public void Takeover_EventOfAFailsafeOrBreachedFence_IsTheCause()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        px4.Say(new Event { Id = 31382480 });
        px4.Mode = 0x0504_0000;
        px4.Run(1);
        Assert.Equal(TakeoverCause.Failsafe, px4.Rig.Authority.Cause);

        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Say(new FenceStatus { BreachStatus = 1 });
        copter.Run(0.1);
        copter.Mode = (uint)CopterMode.Brake;
        copter.Run(1);
        Assert.Equal(TakeoverCause.Failsafe, copter.Rig.Authority.Cause);
    }

    [Fact]
    public void Failsafe_ThatOnlyWarns_LeavesTheCommandOurs()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Status = MavState.Critical;
        copter.SayText("Battery Failsafe");
        copter.Run(3);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Return).Outcome);
    }

    [Fact]
    public void TakeControl_AfterATakeover_TheModeReportedThenIsOurs()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Mode = (uint)CopterMode.Loiter;
        copter.Run(5);
        Assert.Equal(CommandAuthorityState.TakenAway, copter.Authority);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.TakeControl).Outcome);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
        Assert.Equal((uint)CopterMode.Guided, copter.Mode);
    }
}
