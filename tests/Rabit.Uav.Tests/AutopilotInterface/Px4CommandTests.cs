using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink;
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

    // PX4 denies it to any other than the one that the gimbal was given to.
    [Fact]
    public void PointCamera_Gimbal_IsTakenFirst()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        int before = px4.Received.Count;
        VehicleCommandResult answer = px4.GiveAndRun(
            VehicleCommandKind.PointCamera, with: c => c with { CameraPitch = Angle.FromDegrees(-60) });
        Assert.Equal(VehicleCommandOutcome.Accepted, answer.Outcome);
        Assert.Equal([MavCmd.DoGimbalManagerConfigure, MavCmd.DoGimbalManagerPitchyaw], px4.Commands.Skip(before));
        CommandLong given = OutgoingSink.Decode<CommandLong>(px4.Received[before].Frame);
        MavlinkFrame frame = px4.Received[before].Frame;
        Assert.Equal((frame.SystemId, frame.ComponentId), ((byte)given.Param1, (byte)given.Param2));
        Assert.Equal(-60f, px4.Last<CommandLong>().Param1);
    }

    [Fact]
    public void TakeOff_IsAboveTheSeaAndItsModesAreOurs()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        VehicleCommandResult answer = px4.GiveAndRun(
            VehicleCommandKind.TakeOff, with: c => c with { HeightAboveHomeMetres = 30 });
        Assert.Equal(VehicleCommandOutcome.Accepted, answer.Outcome);
        CommandLong takeOff = px4.Last<CommandLong>();
        Assert.Equal((MavCmd.NavTakeoff, 130f), (takeOff.Command, takeOff.Param7));
        Assert.True(float.IsNaN(takeOff.Param4) && float.IsNaN(takeOff.Param5) && float.IsNaN(takeOff.Param6));

        Assert.Equal("AUTO.TAKEOFF", px4.Rig.Vehicle.Mode);
        px4.Mode = 0x0304_0000;   // it is up
        px4.Run(3);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
        px4.Mode = 0x0003_0000;
        px4.Run(3);
        Assert.Equal("mode POSCTL", px4.Rig.Authority.TakenBy);
    }

    [Theory]
    [InlineData(27, 0.5)]    // far below: a Hold of the pilot
    [InlineData(28.4, 3)]    // it may be the end of the take-off, but does not go on to its height
    public void TakeOff_LoiterBelowItsHeight_IsThePilotsAndNothingIsSentMeanwhile(double height, double within)
    {
        using ScriptedAutopilot px4 = TakingOff(height);
        int sent = px4.Received.Count;
        px4.Give(VehicleCommandKind.Return);
        px4.Run(within);
        Assert.Equal("mode AUTO.LOITER", px4.Rig.Authority.TakenBy);
        Assert.Equal(sent, px4.Received.Count);
    }

    [Fact]
    public void TakeOff_LoiterReportedBeforeTheHeight_IsOursOnceTheHeightIsReported()
    {
        using ScriptedAutopilot px4 = TakingOff(28.4);
        px4.Run(1);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
        px4.HeightMetres = 29.3;
        px4.Run(5);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(VehicleCommandKind.Return).Outcome);
    }

    [Theory]
    [InlineData(VehicleCommandKind.Return, 0x0504_0000u)]
    [InlineData(VehicleCommandKind.Land, 0x0604_0000u)]
    public void ReturnAndLand_AreModesAndWhatFollowsIsOurs(VehicleCommandKind kind, uint mode)
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(kind).Outcome);
        Assert.Equal(mode, px4.Mode);
        px4.Say(new ExtendedSysState { LandedState = MavLandedState.OnGround });
        px4.Run(0.1);
        px4.Mode = 0x0304_0000;
        px4.Run(3);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
        px4.IsArmed = false;
        px4.Mode = 0x0006_0000;   // PX4 reports the mode before, once it has disarmed
        px4.Run(3);
        Assert.Equal(CommandAuthorityState.Free, px4.Authority);
    }

    [Theory]
    [InlineData(VehicleCommandKind.Return, 0x0304_0000u)]
    [InlineData(VehicleCommandKind.Return, 0x0604_0000u)]
    [InlineData(VehicleCommandKind.Land, 0x0304_0000u)]
    public void ReturnAndLand_AnotherModeInTheAir_IsThePilots(VehicleCommandKind kind, uint mode)
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        px4.Say(new ExtendedSysState { LandedState = MavLandedState.InAir });
        px4.GiveAndRun(kind);
        px4.Mode = mode;
        px4.Run(3);
        Assert.Equal(CommandAuthorityState.TakenAway, px4.Authority);
    }

    [Fact]
    public void Hold_IsLoiter()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        px4.GiveAndRun(VehicleCommandKind.Return);
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(VehicleCommandKind.Hold).Outcome);
        Assert.Equal(0x0304_0000u, px4.Mode);
        Assert.DoesNotContain(MavCmd.DoReposition, px4.Commands);
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

    // To 30 m, and in AUTO.LOITER at a height.
    private static ScriptedAutopilot TakingOff(double height)
    {
        ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4) { HeightMetres = 0 }.Armed();
        px4.GiveAndRun(VehicleCommandKind.TakeOff, with: c => c with { HeightAboveHomeMetres = 30 });
        px4.HeightMetres = height;
        px4.Run(0.5);
        px4.Mode = 0x0304_0000;
        px4.Beat();
        px4.Run(0.1);
        return px4;
    }
}
