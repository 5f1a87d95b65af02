using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>Commands, as PX4 takes them. Home lies at 100 m above the sea.</summary>
public class Px4CommandTests
{
    [Fact]
    public void Arm_TakesLoiterByMainAndSubModeAndArms()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        Assert.Equal([MavCmd.DoSetMode, MavCmd.ComponentArmDisarm], px4.Commands);
        CommandLong mode = OutgoingSink.Decode<CommandLong>(px4.Received[0].Frame);
        Assert.Equal((1f, 4f, 3f), (mode.Param1, mode.Param2, mode.Param3));
    }

    [Fact]
    public void TakeOff_IsAboveTheSeaAndItsModesAreOurs()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(VehicleCommandKind.TakeOff).Outcome);
        CommandLong takeOff = px4.Last<CommandLong>();
        Assert.Equal((MavCmd.NavTakeoff, 140f), (takeOff.Command, takeOff.Param7));
        Assert.True(float.IsNaN(takeOff.Param4) && float.IsNaN(takeOff.Param5) && float.IsNaN(takeOff.Param6));

        Assert.Equal("AUTO.TAKEOFF", px4.Rig.Vehicle.Mode);
        px4.Mode = 0x0304_0000;   // it is up
        px4.Run(3);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
        px4.Mode = 0x0003_0000;
        px4.Run(3);
        Assert.Equal("mode POSCTL", px4.Rig.Authority.TakenBy);
    }

    [Fact]
    public void GoTo_IsARepositionAboveTheSeaWithSpeedAndHeading()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        Assert.Equal(
            VehicleCommandOutcome.Accepted,
            px4.GiveAndRun(
                VehicleCommandKind.GoTo,
                with: c => c with { SpeedMetresPerSecond = 5, Yaw = Angle.FromRadians(1) }).Outcome);
        CommandInt place = px4.Last<CommandInt>();
        Assert.Equal(
            (MavCmd.DoReposition, MavFrame.Global, 5f, 1f, 1f),
            (place.Command, place.Frame, place.Param1, place.Param2, place.Param4));
        Assert.Equal((401_070_457, 57_295_780, 140f), (place.X, place.Y, place.Z));
    }

    [Theory]
    [InlineData(VehicleCommandKind.Return, 0x0504_0000u)]
    [InlineData(VehicleCommandKind.Land, 0x0604_0000u)]
    public void ReturnAndLand_AreModesAndWhatFollowsIsOurs(VehicleCommandKind kind, uint mode)
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(kind).Outcome);
        Assert.Equal(mode, px4.Mode);
        px4.Mode = 0x0304_0000;
        px4.IsArmed = false;
        px4.Run(3);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
    }

    [Fact]
    public void Hold_IsLoiterAtTheStoppingPoint()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        px4.GiveAndRun(VehicleCommandKind.Return);
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(VehicleCommandKind.Hold).Outcome);
        Assert.Equal(0x0304_0000u, px4.Mode);
        Assert.Equal((MavCmd.DoReposition, 130f), (px4.Last<CommandInt>().Command, px4.Last<CommandInt>().Z));
    }

    [Fact]
    public void SetMode_ByName_IsItsNumbers()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        VehicleCommandResult answer = px4.GiveAndRun(
            VehicleCommandKind.SetMode, with: c => c with { Mode = "AUTO.MISSION" });
        Assert.Equal((VehicleCommandOutcome.Accepted, 0x0404_0000u), (answer.Outcome, px4.Mode));
        answer = px4.GiveAndRun(VehicleCommandKind.SetMode, with: c => c with { Mode = "GUIDED" });
        Assert.Equal(VehicleCommandOutcome.Refused, answer.Outcome);
    }

    [Fact]
    public void Velocity_IsRefused()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        int received = px4.Received.Count;
        VehicleCommandResult answer = px4.GiveAndRun(VehicleCommandKind.Velocity);
        Assert.Equal(
            (VehicleCommandOutcome.Refused, "velocities are not supported on PX4 yet"), (answer.Outcome, answer.Text));
        Assert.Equal(received, px4.Received.Count);
    }

    [Fact]
    public void EveryModeName_FindsItsNumber()
    {
        for (uint main = 0; main < 16; main++)
        {
            for (uint sub = 0; sub < 32; sub++)
            {
                uint mode = (main << 16) | (sub << 24);
                if (Px4Modes.NameOf(mode) is { } name)
                    Assert.Equal(name, Px4Modes.NameOf(Px4Modes.NumberOf(name)!.Value));
            }
        }

        for (uint mode = 0; mode < 64; mode++)
        {
            if (ArdupilotModes.NameOf(MavType.Quadrotor, mode) is { } name)
                Assert.Equal(mode, ArdupilotModes.NumberOf(MavType.Quadrotor, name));
        }
    }
}
