using System;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>A vehicle that is lost, loses its position or its motors, or lands by itself.</summary>
public class MissionVehicleFaultTests
{
    [Fact]
    public void Vehicle_LostAndBack_GoesOnWithoutAPileOfCommands()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Run(8);
        rig.Vehicle.IsConnected = false;
        rig.Run(4);
        int commands = rig.Vehicle.Commands.Count;
        rig.Run(100);
        Assert.Equal(MissionPhase.Searching, rig.Status.Phase);
        Assert.Equal("autopilot not connected", rig.Status.Text);
        Assert.InRange(rig.Vehicle.Commands.Count - commands, 0, 1);
        rig.Vehicle.IsConnected = true;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Null(rig.Status.Aborted);
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
    }

    [Fact]
    public void Vehicle_PositionMissingForAMomentInTheTakeOff_TakeOffIsNotCommandedAgain()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.TakingOff);
        for (int i = 0; i < 100 && rig.Vehicle.Height < 5; i++)
            rig.Run(0.2);
        rig.Vehicle.HasPosition = false;
        rig.Run(3);
        rig.Vehicle.HasPosition = true;
        rig.Run(2);
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.TakeOff));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
    }

    [Fact]
    public void Vehicle_LostAndBackWithAdvice_FollowsIt()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.IsConnected = false;
        rig.Run(4);
        rig.Vehicle.Health = new HealthReport
        {
            Level = HealthLevel.Critical,
            Text = "autopilot lost",
            Advice = HealthAdvice.ReturnToLaunch
        };
        rig.Run(20);
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.Return));
        rig.Vehicle.IsConnected = true;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Equal("health: autopilot lost", rig.Status.Aborted);
    }

    [Fact]
    public void Vehicle_LandsInOurReturnWhileLostForMinutes_IsDoneOnceItIsBack()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Landing);
        rig.Vehicle.IsConnected = false;
        rig.Run(320);
        (rig.Vehicle.Height, rig.Vehicle.IsArmed) = (0, false);   // reported before it is connected
        rig.Run(1);
        rig.Vehicle.IsConnected = true;
        rig.Run(2);
        Assert.Equal(MissionPhase.Done, rig.Status.Phase);
    }

    [Fact]
    public void Vehicle_LandedWhileLost_WaitsForItsPositionAndSendsNothing()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Landing);
        rig.Vehicle.IsConnected = false;
        rig.Run(20);
        (rig.Vehicle.Height, rig.Vehicle.IsArmed) = (0, false);
        int commands = rig.Vehicle.Commands.Count;
        rig.Run(20);

        // The heartbeat says that it is disarmed before the position comes.
        (rig.Vehicle.IsConnected, rig.Vehicle.HasPosition) = (true, false);
        rig.Run(0.5);
        rig.Vehicle.HasPosition = true;
        rig.Run(3);

        Assert.Equal((MissionPhase.Done, MissionOutcome.Accomplished), (rig.Status.Phase, rig.Status.Result.Outcome));
        Assert.StartsWith("landed ", rig.Status.Text!, StringComparison.Ordinal);
        Assert.EndsWith(" m from home", rig.Status.Text!, StringComparison.Ordinal);
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
    }

    [Fact]
    public void Vehicle_LostBeforeTakeOffForGood_EndsAsFailed()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Arming);
        rig.Vehicle.IsConnected = false;
        Assert.Equal(MissionPhase.Failed, rig.RunToEnd(320));
    }

    [Fact]
    public void Vehicle_LostInTheAirForMinutes_ReturnsOnceItIsBackAndNothingElseIsSent()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Run(5);
        rig.Vehicle.IsConnected = false;
        rig.Run(400);
        Assert.Equal(MissionPhase.Searching, rig.Status.Phase);
        int commands = rig.Vehicle.Commands.Count;
        rig.Vehicle.IsConnected = true;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.StartsWith("the link was lost for 39", rig.Status.Aborted!, StringComparison.Ordinal);
        Assert.Equal(VehicleCommandKind.Return, rig.Vehicle.Commands[commands].Command.Kind);
        Assert.InRange(rig.Vehicle.North, -2, 2);
    }

    [Fact]
    public void Vehicle_LosesItsPosition_LandsAfterAWhile()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.HasPosition = false;
        rig.Run(10);
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.Land));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd(120));
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Land));
    }

    [Theory]
    [MemberData(nameof(MissionPhases.InTheAir), MemberType = typeof(MissionPhases))]
    public void Motors_StopInFlight_IsFailed(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        if (phase == MissionPhase.TakingOff)
            rig.Run(3);
        rig.Vehicle.IsArmed = false;
        int commands = rig.Vehicle.Commands.Count;
        rig.Run(5);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.StartsWith("the motors stopped at a height of", rig.Status.Text!, StringComparison.Ordinal);
        Assert.InRange(rig.Vehicle.Commands.Count - commands, 0, 1);
    }

    [Fact]
    public void Vehicle_LandsUnexpectedly_IsFailedAndDisarmed()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.CanClimb = false;
        rig.Vehicle.Height = 0;
        rig.Run(10);
        Assert.Equal(MissionPhase.Failed, rig.Status.Phase);
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Disarm));
    }

    [Fact]
    public void Vehicle_ReportsNoLandedState_IsFlownAllTheSame()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.ReportsLandedState = false;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        Assert.Null(rig.Status.Aborted);
    }
}
