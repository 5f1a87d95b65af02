using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>
/// Commands to fixed wings: one DO_REPOSITION a place, in the mode that the pilot gave. Home lies at 100 m.
/// </summary>
public class FixedWingCommandTests
{
    private const uint Px4Loiter = 0x0304_0000;
    private const uint Px4Return = 0x0504_0000;
    private const uint Posctl = 0x0003_0000;

    public static readonly TheoryData<MavAutopilot> Makes = [MavAutopilot.Ardupilotmega, MavAutopilot.Px4];

    [Theory]
    [MemberData(nameof(Makes))]
    public void GoTo_InTheGivenMode_IsOneReposition(MavAutopilot make)
    {
        using ScriptedAutopilot wing = Given(make);
        VehicleCommandResult answer = wing.GiveAndRun(
            VehicleCommandKind.GoTo, with: c => c with { LoiterRadiusMetres = 80, SpeedMetresPerSecond = 8 });
        Assert.Equal(VehicleCommandOutcome.Accepted, answer.Outcome);

        // No speed: a plane keeps its own above the stall.
        Assert.Equal([MavCmd.DoReposition], wing.Commands);
        CommandInt place = wing.Last<CommandInt>();
        bool isPx4 = make == MavAutopilot.Px4;
        Assert.Equal((-1f, isPx4 ? 1f : 0f, 80f), (place.Param1, place.Param2, place.Param3));
        Assert.Equal(isPx4 ? MavFrame.Global : MavFrame.GlobalRelativeAltInt, place.Frame);
        Assert.Equal(isPx4 ? 140f : 40f, place.Z);
        Assert.Equal(isPx4, float.IsNaN(place.Param4));
        Assert.Equal(CommandAuthorityState.Ours, wing.Authority);
    }

    [Theory]
    [MemberData(nameof(Makes))]
    public void GoTo_RenewedForAMinute_IsSentOnce(MavAutopilot make)
    {
        using ScriptedAutopilot wing = Given(make);
        long id = 0;
        VehicleCommand sent = default;
        id = wing.Give(VehicleCommandKind.GoTo, c => sent = c with { Validity = TimeSpan.FromSeconds(3) });
        for (int i = 0; i < 60; i++)
        {
            wing.Run(1);
            wing.Rig.Command(sent);
        }

        Assert.Equal([MavCmd.DoReposition], wing.Commands);
        Assert.Single(wing.Answers, a => a.Id == id);
    }

    [Theory]
    [MemberData(nameof(Makes))]
    public void GoTo_AnswerLost_TheReportedTargetCountsAndNothingIsSentAgain(MavAutopilot make)
    {
        using ScriptedAutopilot wing = Given(make);
        wing.Script = (_, _) => null;
        long id = wing.Give(VehicleCommandKind.GoTo);
        for (int i = 0; i < 12; i++)
        {
            wing.Run(0.25);
            ReportTarget(wing, wing.Last<CommandInt>());
        }

        Assert.Equal([MavCmd.DoReposition], wing.Commands);
        Assert.Equal(VehicleCommandOutcome.Accepted, wing.Answers.Single(a => a.Id == id).Outcome);
        Assert.Equal(CommandAuthorityState.Ours, wing.Authority);
    }

    // Neither answer nor target: it did not arrive, and the same command is repeated; on PX4 each time on a report.
    [Theory]
    [MemberData(nameof(Makes))]
    public void GoTo_CommandLost_IsRepeatedUntilItArrives(MavAutopilot make)
    {
        using ScriptedAutopilot wing = Given(make);
        int tries = 0;
        wing.Script = (_, _) => ++tries < 3 ? null : MavResult.Accepted;
        Assert.Equal(VehicleCommandOutcome.Accepted, wing.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
        Assert.Equal(3, wing.Commands.Count());

        wing.Run(30);
        Assert.Equal(3, wing.Commands.Count());
    }

    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega, (uint)PlaneMode.FlyByWireA, "FBWA", "GUIDED")]
    [InlineData(MavAutopilot.Ardupilotmega, (uint)PlaneMode.Loiter, "LOITER", "GUIDED")]
    [InlineData(MavAutopilot.Px4, Posctl, "POSCTL", "AUTO.LOITER")]
    public void GoTo_NotGiven_IsRefusedByNameAndNothingSent(
        MavAutopilot make, uint mode, string name, string given)
    {
        using ScriptedAutopilot wing = Given(make, mode);
        foreach (VehicleCommandKind kind in new[] { VehicleCommandKind.GoTo, VehicleCommandKind.Hold })
        {
            VehicleCommandResult answer = wing.GiveAndRun(kind);
            Assert.Equal(VehicleCommandOutcome.Refused, answer.Outcome);
            Assert.Equal(
                $"the vehicle is in {name}: its pilot has not given it over, in {given}", answer.Text);
        }

        Assert.Empty(wing.Received);
        Assert.Equal(CommandAuthorityState.Free, wing.Authority);
    }

    // The pilot's mode is there when the report that PX4's flag needs comes.
    [Fact]
    public void GoTo_ModeLeftBeforeTheReport_IsNotSent()
    {
        using ScriptedAutopilot wing = Given(MavAutopilot.Px4);
        wing.Run(0.05);
        wing.Mode = Posctl;   // not reported yet
        VehicleCommandResult answer = wing.GiveAndRun(VehicleCommandKind.GoTo);
        Assert.Equal(
            (VehicleCommandOutcome.Refused, "DO_REPOSITION is not sent in POSCTL"), (answer.Outcome, answer.Text));
        Assert.Empty(wing.Received);
    }

    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega, (uint)PlaneMode.Loiter, "mode LOITER")]
    [InlineData(MavAutopilot.Px4, Posctl, "mode POSCTL")]
    public void Takeover_OnALeg_NotOneFrameMoreUntilTheOperatorGivesControl(
        MavAutopilot make, uint mode, string by)
    {
        using ScriptedAutopilot wing = Given(make);
        wing.GiveAndRun(VehicleCommandKind.GoTo);
        uint given = wing.Mode;
        wing.Mode = mode;
        wing.Run(1.2);
        Assert.Equal((CommandAuthorityState.TakenAway, by), (wing.Authority, wing.Rig.Authority.TakenBy));
        foreach (VehicleCommandKind kind in
            new[] { VehicleCommandKind.GoTo, VehicleCommandKind.Hold, VehicleCommandKind.Return })
            Assert.Equal(VehicleCommandOutcome.NotInCommand, wing.GiveAndRun(kind).Outcome);
        wing.Mode = given;
        wing.Run(5);
        Assert.Equal(VehicleCommandOutcome.NotInCommand, wing.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
        Assert.Single(wing.Received);

        wing.GiveAndRun(VehicleCommandKind.TakeControl);
        Assert.Equal(VehicleCommandOutcome.Accepted, wing.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
        Assert.Equal(2, wing.Received.Count);
    }

    // Also of a command whose answer is lost: the pilot's mode is seen before it would be repeated.
    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega, (uint)PlaneMode.FlyByWireA)]
    [InlineData(MavAutopilot.Px4, Posctl)]
    public void Takeover_WhileACommandIsUnanswered_IsNotRepeated(MavAutopilot make, uint mode)
    {
        using ScriptedAutopilot wing = Given(make);
        wing.Script = (_, _) => null;
        wing.Give(VehicleCommandKind.GoTo);
        wing.Run(0.3);
        wing.Mode = mode;
        wing.Run(6);
        Assert.Single(wing.Received);
        Assert.Equal(CommandAuthorityState.TakenAway, wing.Authority);
    }

    [Theory]
    [MemberData(nameof(Makes))]
    public void Hold_OnALeg_IsACircleWhereItIs(MavAutopilot make)
    {
        using ScriptedAutopilot wing = Given(make);
        wing.GiveAndRun(VehicleCommandKind.GoTo);
        Assert.Equal(VehicleCommandOutcome.Accepted, wing.GiveAndRun(VehicleCommandKind.Hold).Outcome);
        Assert.Equal([MavCmd.DoReposition, MavCmd.DoReposition], wing.Commands);
        CommandInt place = wing.Last<CommandInt>();
        Assert.Equal((401_000_000, 57_000_000), (place.X, place.Y));
        Assert.Equal(make == MavAutopilot.Px4 ? 130f : 30f, place.Z);
    }

    [Theory]
    [InlineData(MavAutopilot.Ardupilotmega, (uint)PlaneMode.Rtl)]
    [InlineData(MavAutopilot.Px4, Px4Return)]
    public void Return_IsTheModeOnceAndAHoldLeavesIt(MavAutopilot make, uint mode)
    {
        using ScriptedAutopilot wing = Given(make);
        uint given = wing.Mode;
        wing.GiveAndRun(VehicleCommandKind.GoTo);
        Assert.Equal(VehicleCommandOutcome.Accepted, wing.GiveAndRun(VehicleCommandKind.Return).Outcome);
        Assert.Equal(mode, wing.Mode);
        wing.Run(20);
        Assert.Equal([MavCmd.DoReposition, MavCmd.DoSetMode], wing.Commands);

        Assert.Equal(VehicleCommandOutcome.Accepted, wing.GiveAndRun(VehicleCommandKind.Hold).Outcome);
        Assert.Equal(given, wing.Mode);
        Assert.Equal([MavCmd.DoReposition, MavCmd.DoSetMode, MavCmd.DoSetMode], wing.Commands);
    }

    [Theory]
    [InlineData(VehicleCommandKind.Arm)]
    [InlineData(VehicleCommandKind.Disarm)]
    [InlineData(VehicleCommandKind.TakeOff)]
    [InlineData(VehicleCommandKind.Land)]
    [InlineData(VehicleCommandKind.Velocity)]
    [InlineData(VehicleCommandKind.SetMode)]
    public void Command_ThatIsThePilots_IsRefusedByNameAndNothingSent(VehicleCommandKind kind)
    {
        foreach (MavAutopilot make in new[] { MavAutopilot.Ardupilotmega, MavAutopilot.Px4 })
        {
            using ScriptedAutopilot wing = Given(make);
            VehicleCommandResult answer = wing.GiveAndRun(kind);
            Assert.Equal(VehicleCommandOutcome.Refused, answer.Outcome);
            Assert.StartsWith(kind + ": ", answer.Text, StringComparison.Ordinal);
            Assert.Empty(wing.Received);
        }
    }

    [Theory]
    [MemberData(nameof(Makes))]
    public void Target_OfAnotherCommander_TakesTheCommandAway(MavAutopilot make)
    {
        using ScriptedAutopilot wing = Given(make);
        wing.GiveAndRun(VehicleCommandKind.GoTo, 0.5);
        CommandInt ours = wing.Last<CommandInt>();
        for (int i = 0; i < 20; i++)
        {
            ReportTarget(wing, ours);
            wing.Run(0.25);
        }

        Assert.Equal(CommandAuthorityState.Ours, wing.Authority);
        ReportTarget(wing, ours with { X = ours.X + 5000 });
        wing.Run(1);
        Assert.Equal(TakeoverCause.OtherCommander, wing.Rig.Authority.Cause);

        VehicleCommandResult answer = wing.GiveAndRun(VehicleCommandKind.GoTo);
        Assert.Equal(VehicleCommandOutcome.NotInCommand, answer.Outcome);
        Assert.Single(wing.Received);
    }

    [Theory]
    [MemberData(nameof(Makes))]
    public void Validity_NotRenewed_ReturnsByItself(MavAutopilot make)
    {
        using ScriptedAutopilot wing = Given(make);
        wing.GiveAndRun(
            VehicleCommandKind.GoTo, 10, c => c with { Validity = TimeSpan.FromSeconds(3) });
        Assert.Equal([MavCmd.DoReposition, MavCmd.DoSetMode], wing.Commands);
        Assert.True(wing.Rig.Authority.IsReturningByItself);
    }

    private static void ReportTarget(ScriptedAutopilot wing, CommandInt place) => wing.Say(new PositionTargetGlobalInt
    {
        LatInt = place.X,
        LonInt = place.Y,
        Alt = place.Frame == MavFrame.Global ? place.Z : 100 + place.Z,
        TypeMask = (PositionTargetTypemask)65016,
    });

    // In the air, in the mode that the pilot set.
    private static ScriptedAutopilot Given(MavAutopilot make, uint? mode = null)
    {
        var options = new AutopilotOptions { RequestsRates = false, MayCommandFixedWing = true };
        var wing = new ScriptedAutopilot(make, options: options)
        {
            Type = MavType.FixedWing,
            IsArmed = true,
            Mode = mode ?? (make == MavAutopilot.Px4 ? Px4Loiter : (uint)PlaneMode.Guided),
        };
        wing.Run(1.5);
        return wing;
    }
}
