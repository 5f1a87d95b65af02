using System;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>Commands, as ArduPilot's Copter takes them, and what becomes of acknowledgements.</summary>
public class CommandTests
{
    private const double DegreesPerRadian = 1 / Angle.RadiansPerDegree;

    [Fact]
    public void Arm_Copter_TakesGuidedAndArms()
    {
        using var copter = new ScriptedAutopilot();
        copter.Run(1.5);
        VehicleCommandResult answer = copter.GiveAndRun(VehicleCommandKind.Arm);

        Assert.Equal((VehicleCommandOutcome.Accepted, null), (answer.Outcome, answer.Text));
        Assert.Equal([MavCmd.DoSetMode, MavCmd.ComponentArmDisarm], copter.Commands);
        CommandLong mode = OutgoingSink.Decode<CommandLong>(copter.Received[0].Frame);
        Assert.Equal(
            (1f, 4f, 1, 1, 0), (mode.Param1, mode.Param2, mode.TargetSystem, mode.TargetComponent, mode.Confirmation));
        Assert.Equal(1f, copter.Last<CommandLong>().Param1);
        Assert.Equal((1, 191), (copter.Received[0].Frame.SystemId, copter.Received[0].Frame.ComponentId));
        Assert.Equal((CommandAuthorityState.Ours, null), (copter.Authority, copter.Rig.Authority.TakenBy));
    }

    [Fact]
    public void TakeOff_Copter_SendsTheHeightAboveHome()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.TakeOff).Outcome);
        CommandLong takeOff = copter.Last<CommandLong>();
        Assert.Equal((MavCmd.NavTakeoff, 40f), (takeOff.Command, takeOff.Param7));
    }

    [Fact]
    public void GoTo_Copter_IsARepositionWithoutTheFlagThatChangesTheMode()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
        CommandInt place = copter.Last<CommandInt>();
        Assert.Equal(
            (MavCmd.DoReposition, MavFrame.GlobalRelativeAltInt, -1f, 0f),
            (place.Command, place.Frame, place.Param1, place.Param2));
        Assert.Equal((401_070_457, 57_295_780, 40f), (place.X, place.Y, place.Z));
        Assert.Single(copter.Commands, c => c == MavCmd.DoReposition);
        Assert.DoesNotContain(MavCmd.DoChangeSpeed, copter.Commands);
    }

    [Fact]
    public void GoTo_SpeedAndHeading_FollowThePlaceAndSpeedIsSentOnlyWhenItChanges()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        VehicleCommand At(VehicleCommand c, double speed)
            => c with { SpeedMetresPerSecond = speed, Yaw = Angle.FromDegrees(-90) };
        Assert.Equal(
            VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.GoTo, with: c => At(c, 6)).Outcome);
        Assert.Equal([MavCmd.DoReposition, MavCmd.DoChangeSpeed, MavCmd.ConditionYaw], copter.Commands.Skip(2));
        CommandLong speed = OutgoingSink.Decode<CommandLong>(copter.Received[3].Frame);
        Assert.Equal((1f, 6f, -1f), (speed.Param1, speed.Param2, speed.Param3));
        Assert.Equal(270f, copter.Last<CommandLong>().Param1);

        copter.GiveAndRun(VehicleCommandKind.GoTo, with: c => At(c, 6));
        Assert.Single(copter.Commands, c => c == MavCmd.DoChangeSpeed);
        copter.GiveAndRun(VehicleCommandKind.GoTo, with: c => At(c, 3));
        copter.GiveAndRun(VehicleCommandKind.Hold);
        copter.GiveAndRun(VehicleCommandKind.GoTo, with: c => At(c, 3));
        Assert.Equal(3, copter.Commands.Count(c => c == MavCmd.DoChangeSpeed));
    }

    [Fact]
    public void Hold_Copter_IsTheStoppingPointInGuided()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.VelocityNed = new NedVector(5, 0, 0);
        copter.Run(1);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Hold).Outcome);
        CommandInt place = copter.Last<CommandInt>();
        Assert.Equal((MavCmd.DoReposition, 30f), (place.Command, place.Z));
        double metresNorth = (place.X - 401_000_000) * 1e-7 * 111_035;
        Assert.InRange(metresNorth, 4.9, 5.1);   // 5 m/s at 2.5 m/s2
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
    }

    [Theory]
    [InlineData(VehicleCommandKind.Return, CopterMode.Rtl)]
    [InlineData(VehicleCommandKind.Land, CopterMode.Land)]
    public void ReturnAndLand_Copter_AreModesThatStayOursUntilItHasLanded(VehicleCommandKind kind, CopterMode mode)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(kind).Outcome);
        Assert.Equal((uint)mode, copter.Mode);
        copter.Run(3);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        copter.IsArmed = false;   // landed
        copter.Run(5);
        Assert.Equal(CommandAuthorityState.Free, copter.Authority);   // the flight is over: no mode is ours

        // And again: the mode in which it takes places comes first.
        int before = copter.Commands.Count();
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
        Assert.Equal([MavCmd.DoSetMode, MavCmd.DoReposition], copter.Commands.Skip(before));
    }

    [Fact]
    public void SetMode_ByName_IsFoundInAnyCaseOrRefused()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        Assert.Equal(
            VehicleCommandOutcome.Accepted,
            copter.GiveAndRun(VehicleCommandKind.SetMode, with: c => c with { Mode = "brake" }).Outcome);
        Assert.Equal((uint)CopterMode.Brake, copter.Mode);
        int received = copter.Received.Count;
        VehicleCommandResult answer = copter.GiveAndRun(
            VehicleCommandKind.SetMode, with: c => c with { Mode = "FBWA" });
        Assert.Equal(VehicleCommandOutcome.Refused, answer.Outcome);
        Assert.Contains("'FBWA'", answer.Text, StringComparison.Ordinal);
        Assert.Equal(received, copter.Received.Count);
    }

    [Theory]
    [InlineData(GimbalFrame.Body, 0)]
    [InlineData(GimbalFrame.Heading, 4 + 8 + 32)]
    [InlineData(GimbalFrame.North, 4 + 8 + 16 + 64)]
    public void PointCamera_AnglesGoOutInDegreesAndTheirFrameAsFlags(GimbalFrame frame, float flags)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        VehicleCommandResult answer = copter.GiveAndRun(
            VehicleCommandKind.PointCamera,
            with: c => c with
            {
                CameraPitch = Angle.FromDegrees(-90),
                CameraYaw = Angle.FromRadians(30 / DegreesPerRadian),
                GimbalFrame = frame,
            });
        Assert.Equal(VehicleCommandOutcome.Accepted, answer.Outcome);
        CommandLong gimbal = copter.Last<CommandLong>();
        Assert.Equal((MavCmd.DoGimbalManagerPitchyaw, -90f, 30f), (gimbal.Command, gimbal.Param1, gimbal.Param2));
        Assert.True(float.IsNaN(gimbal.Param3) && float.IsNaN(gimbal.Param4));
        Assert.Equal(flags, gimbal.Param5);
    }

    [Fact]
    public void Disarm_IsAskedForAndTheRefusalReported()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (_, _) => MavResult.Failed;
        VehicleCommandResult answer = copter.GiveAndRun(VehicleCommandKind.Disarm);
        Assert.Equal((VehicleCommandOutcome.Refused, "COMPONENT_ARM_DISARM: FAILED"), (answer.Outcome, answer.Text));
        Assert.Equal(0f, copter.Last<CommandLong>().Param1);
    }

    [Fact]
    public void Command_NewerOne_ReplacesTheOlder()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Latency = 0.2;
        long first = copter.Give(VehicleCommandKind.TakeOff);
        copter.Run(0.05);
        long second = copter.Give(VehicleCommandKind.GoTo);
        long third = copter.Give(VehicleCommandKind.Return);
        copter.Run(4);
        Assert.Equal(
            [(first, VehicleCommandOutcome.Replaced), (second, VehicleCommandOutcome.Replaced),
                (third, VehicleCommandOutcome.Accepted)],
            copter.Answers.Skip(1).Select(a => (a.Id, a.Outcome)));
        Assert.DoesNotContain(MavCmd.DoReposition, copter.Commands);
    }

    [Fact]
    public void Command_SameKindWhileTheOldAnswerIsOnItsWay_TakesItsOwnAnswer()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Latency = 0.15;
        int tries = 0;
        copter.Script = (_, _) => tries++ == 0 ? MavResult.Accepted : MavResult.Denied;
        copter.Give(VehicleCommandKind.GoTo);
        copter.Run(0.1);
        long second = copter.Give(VehicleCommandKind.GoTo);
        copter.Run(4);
        Assert.Equal(VehicleCommandOutcome.Refused, copter.Answers.Single(a => a.Id == second).Outcome);
        Assert.Equal(2, tries);
    }

    [Fact]
    public void Command_NoAutopilotYet_WaitsThenTimesOut()
    {
        using var copter = new ScriptedAutopilot { Beats = false };
        VehicleCommandResult answer = copter.GiveAndRun(VehicleCommandKind.Arm);
        Assert.Equal((VehicleCommandOutcome.TimedOut, "no autopilot is connected"), (answer.Outcome, answer.Text));
        Assert.Empty(copter.Received);

        copter.Give(VehicleCommandKind.Arm);
        copter.Run(1);
        copter.Beats = true;
        copter.Run(4);
        Assert.Equal(VehicleCommandOutcome.Accepted, copter.Answers[1].Outcome);
    }

    [Fact]
    public void Command_AutopilotLost_TimesOutAndNothingIsSent()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Beats = false;
        copter.Script = (_, _) => null;
        copter.Run(7);
        Assert.False(copter.Rig.Vehicle.IsConnected);
        Assert.Equal(VehicleCommandOutcome.TimedOut, copter.GiveAndRun(VehicleCommandKind.Return).Outcome);
        Assert.Equal(2, copter.Received.Count);   // without a report of the mode no mode is commanded
    }

    [Theory]
    [InlineData(MavAutopilot.Generic, MavType.Quadrotor, "Generic")]
    [InlineData(MavAutopilot.Ardupilotmega, MavType.FixedWing, "AutopilotOptions.MayCommandFixedWing")]
    [InlineData(MavAutopilot.Px4, MavType.FixedWing, "--fixed-wing")]
    [InlineData(MavAutopilot.Px4, MavType.VtolFixedrotor, "VtolFixedrotor")]
    public void Command_VehicleThatIsNotCommanded_IsRefusedAndNothingSent(
        MavAutopilot make, MavType type, string expected)
    {
        using var copter = new ScriptedAutopilot(make) { Type = type };
        copter.Run(1.5);
        VehicleCommandResult answer = copter.GiveAndRun(VehicleCommandKind.Arm);
        Assert.Equal(VehicleCommandOutcome.Refused, answer.Outcome);
        Assert.Contains(expected, answer.Text, StringComparison.Ordinal);
        Assert.Empty(copter.Received);
        Assert.Equal(CommandAuthorityState.Free, copter.Authority);
    }

    [Fact]
    public void Command_InvalidFigures_IsRefusedByNameAndNothingSent()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        int received = copter.Received.Count;
        void Refuses(VehicleCommandKind kind, string name, Func<VehicleCommand, VehicleCommand> with)
        {
            VehicleCommandResult answer = copter.GiveAndRun(kind, 0.2, with);
            Assert.Equal(VehicleCommandOutcome.Refused, answer.Outcome);
            Assert.Contains(name, answer.Text, StringComparison.Ordinal);
        }

        foreach (double bad in new[] { double.NaN, double.PositiveInfinity, double.NegativeInfinity, 1e9 })
        {
            Refuses(VehicleCommandKind.GoTo, "Latitude", c => c with { Latitude = Angle.FromRadians(bad) });
            Refuses(VehicleCommandKind.GoTo, "Longitude", c => c with { Longitude = Angle.FromRadians(bad) });
            Refuses(VehicleCommandKind.GoTo, "HeightAboveHomeMetres", c => c with { HeightAboveHomeMetres = bad });
            Refuses(VehicleCommandKind.TakeOff, "HeightAboveHomeMetres", c => c with { HeightAboveHomeMetres = bad });
            Refuses(VehicleCommandKind.Velocity, "VelocityNed", c => c with { VelocityNed = new NedVector(0, bad, 0) });
            Refuses(
                VehicleCommandKind.PointCamera, "CameraPitch", c => c with { CameraPitch = Angle.FromRadians(bad) });
            Refuses(VehicleCommandKind.PointCamera, "CameraYaw", c => c with { CameraYaw = Angle.FromRadians(bad) });
        }

        Refuses(VehicleCommandKind.GoTo, "Latitude", c => c with { Latitude = Angle.Zero, Longitude = Angle.Zero });
        Refuses(VehicleCommandKind.GoTo, "HeightAboveHomeMetres", c => c with { HeightAboveHomeMetres = 0 });
        Refuses(VehicleCommandKind.TakeOff, "HeightAboveHomeMetres", c => c with { HeightAboveHomeMetres = -1 });
        Refuses(VehicleCommandKind.GoTo, "SpeedMetresPerSecond", c => c with { SpeedMetresPerSecond = 0 });
        Refuses(VehicleCommandKind.GoTo, "Yaw", c => c with { Yaw = Angle.FromRadians(100) });
        Refuses(VehicleCommandKind.SetMode, "Mode", c => c with { Mode = null });
        Refuses(VehicleCommandKind.None, "Kind", c => c);
        Refuses((VehicleCommandKind)99, "Kind", c => c);
        Assert.Equal(received, copter.Received.Count);
    }
}
