using System;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>The stop of the program in each phase.</summary>
public class MissionStopTests
{
    [Theory]
    [MemberData(nameof(MissionPhases.InTheAir), MemberType = typeof(MissionPhases))]
    public void Stop_InTheAir_HoldsFirst(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Run(1);
        TimeSpan took = rig.Stop();

        Assert.Equal(VehicleCommandKind.Hold, rig.Vehicle.Commands.Last().Command.Kind);
        Assert.Equal(MissionStopResult.Held, rig.Status.StopResult);
        Assert.InRange(took, TimeSpan.Zero, TimeSpan.FromSeconds(1.5));
    }

    [Fact]
    public void Stop_OptionReturn_ReturnsFirst()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching, o => o.OnStop = OnStop.Return);
        rig.Stop();
        Assert.Equal(VehicleCommandKind.Return, rig.Vehicle.Commands.Last().Command.Kind);
        Assert.Equal(MissionStopResult.Returning, rig.Status.StopResult);
    }

    [Fact]
    public void Stop_InAHold_SendsNothingMore()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Manager.Hold("test", "test");
        rig.Run(5);
        rig.Stop();
        Assert.Equal(1, rig.Vehicle.Count(VehicleCommandKind.Hold));
        Assert.Equal(MissionStopResult.Held, rig.Status.StopResult);
    }

    [Theory]
    [InlineData(MissionPhase.WaitingForVehicle)]
    [InlineData(MissionPhase.Arming)]
    [InlineData(MissionPhase.Returning)]
    [InlineData(MissionPhase.Landing)]
    public void Stop_OnTheGroundOrOnTheWayHome_SendsNothing(MissionPhase phase)
    {
        using MissionRig rig = MissionRig.In(phase);
        rig.Run(1);
        int commands = rig.Vehicle.Commands.Count;
        TimeSpan took = rig.Stop();
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
        Assert.Equal(MissionStopResult.None, rig.Status.StopResult);
        Assert.InRange(took, TimeSpan.Zero, TimeSpan.FromSeconds(0.2));
    }

    [Theory]
    [InlineData(TakeoverCause.Mode)]
    [InlineData(TakeoverCause.Failsafe)]
    public void Stop_AfterATakeover_SendsNothing(TakeoverCause cause)
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.TakeOver("mode RTL", cause);
        rig.Run(1);
        int commands = rig.Vehicle.Commands.Count;
        rig.Stop();
        Assert.Equal(commands, rig.Vehicle.Commands.Count);
        Assert.Equal(MissionStopResult.None, rig.Status.StopResult);
    }

    [Fact]
    public void Stop_HoldIsRefused_Returns()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.Hold ? VehicleCommandOutcome.Refused : null;
        rig.Stop();
        Assert.Equal(MissionStopResult.Returning, rig.Status.StopResult);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Stop_AutopilotDoesNotAnswer_EndsAfterThreeSecondsAndSaysSo(bool isConnected)
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.IsConnected = isConnected;
        rig.Vehicle.Refuses = static c => c.Kind is VehicleCommandKind.Hold or VehicleCommandKind.Return
            ? VehicleCommandOutcome.TimedOut
            : null;
        rig.Run(isConnected ? 1 : 5);
        TimeSpan took = rig.Stop();
        Assert.Equal(MissionStopResult.NotVerified, rig.Status.StopResult);
        Assert.InRange(took, TimeSpan.FromSeconds(2.9), TimeSpan.FromSeconds(3.5));
    }

    [Fact]
    public void Stop_PilotTakesOverMeanwhile_EndsAtOnce()
    {
        using MissionRig rig = MissionRig.In(MissionPhase.Searching);
        rig.Vehicle.Refuses = c => c.Kind == VehicleCommandKind.Hold ? VehicleCommandOutcome.TimedOut : null;
        rig.Vehicle.TakeOver("mode LOITER");
        TimeSpan took = rig.Stop();
        Assert.Equal(MissionStopResult.None, rig.Status.StopResult);
        Assert.InRange(took, TimeSpan.Zero, TimeSpan.FromSeconds(1));
    }

    [Fact]
    public void Stop_InTheTakeOffBeforeItLiftsOff_StopsTheMotors()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff));
        TimeSpan took = rig.Stop();
        Assert.Equal(0, rig.Vehicle.Count(VehicleCommandKind.Hold));
        Assert.Equal(VehicleCommandKind.Disarm, rig.Vehicle.Commands.Last().Command.Kind);
        Assert.Equal(MissionStopResult.None, rig.Status.StopResult);
        Assert.InRange(took, TimeSpan.Zero, TimeSpan.FromSeconds(1.5));
    }

    [Fact]
    public void Stop_BeforeItLiftsOffAndTheMotorsGoOn_SaysSo()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Refuses = static c => c.Kind is VehicleCommandKind.Disarm or VehicleCommandKind.TakeOff
            ? VehicleCommandOutcome.TimedOut
            : null;
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff));
        rig.Stop();
        Assert.Equal(MissionStopResult.NotVerified, rig.Status.StopResult);
    }

    [Fact]
    public void Stop_ItLiftsOffMeanwhile_Holds()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.Vehicle.Refuses = static c => c.Kind == VehicleCommandKind.Disarm ? VehicleCommandOutcome.Refused : null;
        Assert.Equal(MissionPhase.TakingOff, rig.RunUntil(MissionPhase.TakingOff));
        rig.Run(0.5);
        rig.Stop();
        Assert.Equal(VehicleCommandKind.Hold, rig.Vehicle.Commands.Last().Command.Kind);
        Assert.Equal(MissionStopResult.Held, rig.Status.StopResult);
    }
}
