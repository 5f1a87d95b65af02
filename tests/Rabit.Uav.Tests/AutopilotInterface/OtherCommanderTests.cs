using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>Targets and set-points of another commander, which change no mode, take the command away.</summary>
public class OtherCommanderTests
{
    // Masks of ArduPilot: a place; a velocity.
    private const int Place = 0xDF8;
    private const int Velocity = 0xC07;

    private const uint Loiter = 0x0304_0000;
    private const uint Offboard = 0x0006_0000;
    private const uint Rtl = 0x0504_0000;

    // What ArduPilot makes of 1e-7 degrees of latitude.
    private const double MetresPerDegE7 = 0.011131884502145034;

    [Theory]
    [InlineData(30, 0, Place)]
    [InlineData(0, -8, Place)]
    [InlineData(0, 0, Velocity)]
    public void Target_ThatWeDidNotCommand_TakesTheCommandAway(float north, float down, int mask)
    {
        using ScriptedAutopilot copter = Flying();
        copter.GiveAndRun(VehicleCommandKind.GoTo, seconds: 1);
        Report(copter, 10, -20, Place);   // shows the origin
        copter.Run(2);
        Report(copter, 10.4f, -20, Place);   // rounding
        copter.Run(2);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        Report(copter, 10 + north, -20 + down, mask);
        AssertTakenAndSilent(copter, "another commander's target");
    }

    [Fact]
    public void Target_OfOurNextCommands_IsOurs()
    {
        using ScriptedAutopilot copter = Flying();
        for (int leg = 0; leg < 5; leg++)
        {
            double latitude = 0.7 + (leg * 5e-6);
            copter.GiveAndRun(
                VehicleCommandKind.GoTo, seconds: 1, with: c => c with { Latitude = Angle.FromRadians(latitude) });
            Report(copter, (float)(leg * 5e-6 / Angle.RadiansPerDegree * 1e7 * MetresPerDegE7), -30, Place);
            copter.Run(1);
        }

        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
    }

    [Fact]
    public void Target_RightAfterOurs_IsComparedWithOursAndNotTakenForIt()
    {
        using ScriptedAutopilot copter = Flying();
        copter.GiveAndRun(VehicleCommandKind.GoTo, seconds: 1);
        Report(copter, 10, -20, Place);
        copter.Run(1);
        copter.Give(VehicleCommandKind.GoTo, with: c => c with { HeightAboveHomeMetres = 45 });
        copter.Run(0.3);
        Report(copter, 60, -30, Place);   // another's, and no report of ours in between
        AssertTakenAndSilent(copter, "another commander's target");
    }

    [Fact]
    public void Target_OfTheLegBefore_MayComeLate()
    {
        using ScriptedAutopilot copter = Flying();
        copter.GiveAndRun(VehicleCommandKind.GoTo, seconds: 1);
        Report(copter, 10, -20, Place);
        copter.Run(1);
        copter.Give(VehicleCommandKind.GoTo, with: c => c with { HeightAboveHomeMetres = 60 });
        copter.Run(0.2);
        Report(copter, 10, -20, Place);
        copter.Run(2);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        Report(copter, 10, -20, Place);
        AssertTakenAndSilent(copter, "another commander's target");
    }

    [Fact]
    public void Target_RefusedByTheAutopilot_IsNotOurs()
    {
        using ScriptedAutopilot copter = Flying();
        copter.GiveAndRun(VehicleCommandKind.GoTo, seconds: 1);
        Report(copter, 10, -20, Place);
        copter.Run(1);
        copter.Script = (frame, command) => command == MavCmd.DoReposition
            ? MavResult.Failed : copter.Accept(frame, command);
        copter.GiveAndRun(VehicleCommandKind.GoTo, seconds: 2, with: c => c with { HeightAboveHomeMetres = 60 });
        Report(copter, 10, -20, Place);
        copter.Run(1);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        Report(copter, 10, -40, Place);
        AssertTakenAndSilent(copter, "another commander's target");
    }

    [Theory]
    [InlineData(0, 0, Velocity)]
    [InlineData(25, -30, Place)]
    public void Target_InOurTakeOff_MustNotChange(float north, float down, int mask)
    {
        using ScriptedAutopilot copter = Flying();
        copter.GiveAndRun(VehicleCommandKind.TakeOff, seconds: 1);
        for (int i = 0; i < 5; i++)
        {
            Report(copter, 0, 0, Place);   // what ArduPilot reports in a take-off
            copter.Run(0.5);
        }

        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
        Report(copter, north, down, mask);
        AssertTakenAndSilent(copter, "another commander's target");
    }

    [Fact]
    public void Target_OfOurFirstLegAfterTheTakeOff_IsOurs()
    {
        using ScriptedAutopilot copter = Flying();
        copter.GiveAndRun(VehicleCommandKind.TakeOff, seconds: 1);
        Report(copter, 0, 0, Place);
        copter.Run(1);
        copter.Give(VehicleCommandKind.GoTo);
        copter.Run(0.06);
        Report(copter, 300, -40, Place);   // before the acknowledgement has come
        copter.Run(2);
        Report(copter, 300, -40, Place);
        copter.Run(1);
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
    }

    [Fact]
    public void Px4Hold_TargetMoves_TakesTheCommandAwayOnceTheModeIsConfirmed()
    {
        using ScriptedAutopilot px4 = Holding();
        ReportPlace(px4, 401_000_000);
        px4.Run(5);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
        ReportPlace(px4, 401_003_000);
        AssertTakenAndSilent(px4, "another commander's target");
    }

    [Fact]
    public void Px4Hold_TargetMovesByAFailsafe_IsTheFailsafes()
    {
        using ScriptedAutopilot px4 = Holding();
        ReportPlace(px4, 401_000_000);
        px4.Run(5);
        px4.Mode = Rtl;   // not reported yet
        ReportPlace(px4, 401_003_000);
        px4.Run(2);
        Assert.Equal(
            (CommandAuthorityState.TakenAway, TakeoverCause.Mode), (px4.Authority, px4.Rig.Authority.Cause));
    }

    [Fact]
    public void Px4Offboard_AnothersSetPointsBetweenOurs_TakeTheCommandAway()
    {
        using ScriptedAutopilot px4 = InOffboard();
        for (int i = 0; i < 20; i++)
            ReportSetPoint(px4, 0);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
        for (int i = 0; i < 20 && px4.Authority == CommandAuthorityState.Ours; i++)
            ReportSetPoint(px4, i % 4 == 3 ? 20 : 0);
        AssertTakenAndSilent(px4, "another commander's set-points");
    }

    [Fact]
    public void Px4Offboard_FrameOfAnotherOrigin_IsNoCommander()
    {
        using ScriptedAutopilot px4 = InOffboard();
        for (int i = 0; i < 60; i++)
            ReportSetPoint(px4, i < 20 ? 0 : 50);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
    }

    private static void Report(ScriptedAutopilot copter, float north, float down, int mask)
        => copter.Say(new PositionTargetLocalNed { X = north, Z = down, TypeMask = (PositionTargetTypemask)mask });

    private static void ReportPlace(ScriptedAutopilot px4, int latitudeDegE7)
        => px4.Say(new PositionTargetGlobalInt { LatInt = latitudeDegE7, LonInt = 57_000_000, Alt = 130 });

    // The set-point that was received last, in a frame whose origin is elsewhere; for 0.1 s.
    private static void ReportSetPoint(ScriptedAutopilot px4, double north)
    {
        SetPositionTargetGlobalInt sent = px4.Last<SetPositionTargetGlobalInt>();
        double x = ((sent.LatInt - 401_000_000) * 1e-7 * 111_194.9) + 35 + north;
        double y = (sent.LonInt - 57_000_000) * 1e-7 * 111_194.9 * Math.Cos(40.1 * Angle.RadiansPerDegree);
        px4.Say(new PositionTargetLocalNed { X = (float)x, Y = (float)y, Z = -sent.Alt });
        px4.Run(0.1);
    }

    private static void AssertTakenAndSilent(ScriptedAutopilot autopilot, string by)
    {
        autopilot.Run(0.5);
        Assert.Equal(
            (CommandAuthorityState.TakenAway, TakeoverCause.OtherCommander, by),
            (autopilot.Authority, autopilot.Rig.Authority.Cause, autopilot.Rig.Authority.TakenBy));
        int sent = autopilot.Received.Count;
        autopilot.Run(10);
        Assert.Equal(sent, autopilot.Received.Count);
    }

    private static ScriptedAutopilot Flying()
    {
        ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Say(new ExtendedSysState { LandedState = MavLandedState.InAir });
        copter.Run(1);
        return copter;
    }

    private static ScriptedAutopilot Holding()
    {
        ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        px4.Say(new ExtendedSysState { LandedState = MavLandedState.InAir });
        px4.GiveAndRun(VehicleCommandKind.Hold);
        Assert.Equal(Loiter, px4.Mode);
        return px4;
    }

    private static ScriptedAutopilot InOffboard()
    {
        ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4) { FollowsSetPoints = true }.Armed();
        px4.GiveAndRun(
            VehicleCommandKind.GoTo, with: c => c with
            {
                Latitude = Angle.FromDegrees(40.102),
                Longitude = Angle.FromDegrees(5.7),
                HeightAboveHomeMetres = 30,
            });
        px4.Run(1);
        Assert.Equal(Offboard, px4.Mode);
        return px4;
    }
}
