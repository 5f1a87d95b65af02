using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>
/// What it refuses, as ArduCopter refuses it: the result codes of the recorded flight and of its sources, and its
/// texts.
/// </summary>
public class RefusalTests
{
    [Fact]
    public void Arm_BeforeAPosition_FailsWithText()
    {
        using var ground = new Ground();
        ground.Run(1);
        ground.SetMode(CopterMode.Guided);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.ComponentArmDisarm, 1));
        ground.Run(3);
        Assert.Contains("Arm: Need Position Estimate", ground.Texts);
        Assert.Contains("PreArm: Need Position Estimate", ground.Texts);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.ComponentArmDisarm, 1, 21196));
        ground.Run(4);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.ComponentArmDisarm, 1));
        Assert.True(ground.Truth.IsArmed);
    }

    [Theory]
    [InlineData(CopterMode.Rtl, "Arm: RTL mode not armable")]
    [InlineData(CopterMode.Land, "Arm: LAND mode not armable")]
    [InlineData(CopterMode.Auto, "Arm: AUTO mode not armable")]
    [InlineData(CopterMode.Brake, "Arm: BRAKE mode not armable")]
    public void Arm_InAModeThatIsNotArmable_Fails(CopterMode mode, string text)
    {
        using var ground = new Ground();
        ground.Run(6);
        Assert.Equal(MavResult.Accepted, ground.SetMode(mode));
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.ComponentArmDisarm, 1));
        ground.Run(0.2);
        Assert.Contains(text, ground.Texts);
    }

    [Fact]
    public void Arm_BatteryLow_FailsUnlessForced()
    {
        using var ground = new Ground(new SimulationOptions { BatteryRemaining = 0.02 });
        ground.Run(6);
        ground.SetMode(CopterMode.Guided);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.ComponentArmDisarm, 1));
        ground.Run(0.2);
        Assert.Contains("Arm: Battery 1 low voltage failsafe", ground.Texts);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.ComponentArmDisarm, 1, 2989));
    }

    [Fact]
    public void Disarm_InFlight_FailsUnlessForced()
    {
        using var ground = new Ground();
        ground.TakeOff(10);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.ComponentArmDisarm, 0));
        Assert.True(ground.Truth.IsArmed);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.ComponentArmDisarm, 0, 21196));
        ground.Run(5);
        Assert.True(ground.Truth.HasCrashed, "it falls");
        Assert.InRange(ground.Truth.TouchdownMetresPerSecond, 9, 15);
    }

    [Fact]
    public void TakeOff_NotArmedNotGuidedTooLowOrTwice_Fails()
    {
        using var ground = new Ground();
        ground.Run(6);
        ground.SetMode(CopterMode.Guided);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.NavTakeoff, p7: 10));
        ground.SetMode(CopterMode.Stabilize);
        ground.Command(MavCmd.ComponentArmDisarm, 1);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.NavTakeoff, p7: 10));
        ground.SetMode(CopterMode.Guided);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.NavTakeoff, p7: -1));
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.NavTakeoff, p7: float.NaN));
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.NavTakeoff, p7: 10));
        ground.Run(10);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.NavTakeoff, p7: 20));
    }

    [Fact]
    public void Mode_UnknownOrImpossible_FailsWithText()
    {
        using var ground = new Ground();
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.DoSetMode, 1, 99));
        Assert.Equal(MavResult.Denied, ground.Command(MavCmd.DoSetMode, 0, 4));
        ground.TakeOff(10);
        Assert.Equal(MavResult.Failed, ground.SetMode(CopterMode.Auto));
        ground.Run(0.2);
        Assert.Contains("No such mode 99", ground.Texts);
        Assert.Contains("Mode change to AUTO failed: init failed", ground.Texts);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void Reposition_OutsideGuidedOrWrong_IsDenied()
    {
        using var ground = new Ground();
        ground.TakeOff(10);
        CommandInt reposition = FlightTests.Reposition(ground, 0);
        CommandInt nowhere = reposition;
        (nowhere.X, nowhere.Y) = (910_000_000, 0);
        Assert.Equal(MavResult.Denied, ground.Command(nowhere));
        CommandInt otherFrame = reposition;
        otherFrame.Frame = MavFrame.LocalNed;
        Assert.Equal(MavResult.Denied, ground.Command(otherFrame));
        Assert.Equal(MavResult.Unsupported, ground.Command(MavCmd.DoReposition, -1, 1, p5: -35, p6: 149, p7: 20));

        ground.SetMode(CopterMode.Loiter);
        Assert.Equal(MavResult.Denied, ground.Command(reposition));
        Assert.Equal(MavResult.Accepted, ground.Command(FlightTests.Reposition(ground, 1)));
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void Commands_Unknown_AreUnsupported()
    {
        using var ground = new Ground();
        Assert.Equal(MavResult.Unsupported, ground.Command(MavCmd.DoOrbit, 20, 2));
        Assert.Equal(MavResult.Unsupported, ground.Command(MavCmd.DoSetServo, 9, 1500));
        Assert.Equal(MavResult.Unsupported, ground.Command(MavCmd.ComponentArmDisarm, 0.5f));
    }

    [Fact]
    public void ChangeSpeed_NotPositiveOrNotGuided_IsRefused()
    {
        using var ground = new Ground();
        ground.TakeOff(10);
        Assert.Equal(MavResult.Denied, ground.Command(MavCmd.DoChangeSpeed, 1, 0));
        Assert.Equal(MavResult.Denied, ground.Command(MavCmd.DoChangeSpeed, 1, float.NaN));
        ground.SetMode(CopterMode.Loiter);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.DoChangeSpeed, 1, 5));
    }

    [Fact]
    public void OtherSystems_AreLeftAlone()
    {
        using var ground = new Ground();
        ground.Run(6);
        ground.Send(
            new CommandLong
            {
                TargetSystem = 2,
                TargetComponent = 1,
                Command = MavCmd.DoSetMode,
                Param1 = 1,
                Param2 = 4
            });
        ground.Send(
            new CommandLong
            {
                TargetSystem = 1,
                TargetComponent = 154,
                Command = MavCmd.DoSetMode,
                Param1 = 1,
                Param2 = 4
            });
        ground.Run(2);
        Assert.Equal(0, ground.Count<CommandAck>());
        Assert.Equal(0u, ground.Heartbeat.CustomMode);
        ground.Send(new CommandLong { Command = MavCmd.DoSetMode, Param1 = 1, Param2 = 4 });
        ground.Run(2);
        Assert.Equal(1, ground.Count<CommandAck>());
        Assert.Equal(4u, ground.Heartbeat.CustomMode);
    }

    [Fact]
    public void SetMode_TheOldMessage_IsAcknowledgedByItsId()
    {
        using var ground = new Ground();
        ground.Send(new SetMode { TargetSystem = 1, BaseMode = MavModeFlag.CustomModeEnabled, CustomMode = 4 });
        ground.Run(2);
        CommandAck ack = ground.All<CommandAck>().Single().Message;
        Assert.Equal((11, MavResult.Accepted), ((int)ack.Command, ack.Result));
        Assert.Equal(4u, ground.Heartbeat.CustomMode);
    }
}
