using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>Places on PX4: set-points in OFFBOARD, and when they are sent.</summary>
public class OffboardTests
{
    private const uint Loiter = 0x0304_0000;
    private const uint Offboard = 0x0006_0000;
    private const uint Posctl = 0x0003_0000;
    private const uint Rtl = 0x0504_0000;

    [Fact]
    public void GoTo_StreamRunsForASecondBeforeOffboardIsAskedFor()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        long id = Go(px4);
        px4.Run(3);
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.Answers.Single(a => a.Id == id).Outcome);
        Assert.Equal(Offboard, px4.Mode);
        Assert.DoesNotContain(MavCmd.DoReposition, px4.Commands);

        TimeSpan asked = px4.Received.Last(f => ScriptedAutopilot.CommandOf(f.Frame) == MavCmd.DoSetMode).Time;
        List<TimeSpan> times = SetPoints(px4).Select(s => s.Time).ToList();
        Assert.InRange((asked - times[0]).TotalSeconds, 1, 1.2);
        Assert.All(times.Zip(times.Skip(1), (a, b) => b - a), gap => Assert.InRange(gap.TotalSeconds, 0.02, 0.1));
    }

    [Fact]
    public void GoTo_SetPoints_MoveAlongTheLegWithItsSpeedAsFeedForward()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4) { FollowsSetPoints = true }.Armed();
        Go(px4);
        px4.Run(16);
        SetPositionTargetGlobalInt cruise = SetPoints(px4).Last().SetPoint;
        Assert.Equal(MavFrame.GlobalRelativeAltInt, cruise.CoordinateFrame);
        Assert.Equal(0x9C0, (int)cruise.TypeMask);   // as in the recordings of PX4
        Assert.InRange(cruise.Vx, 4.9, 5.1);
        Assert.InRange(cruise.Alt, 34.9, 35.1);
        Assert.InRange(cruise.Yaw, 0.99, 1.01);
        double metres = (cruise.LatInt - 401_000_000) * 1e-7 * 111_000;
        Assert.InRange(metres, 69.5, 72);   // ahead of the start by what was flown; with 2 m/s2 it were 68.3

        px4.Run(40);
        SetPositionTargetGlobalInt end = SetPoints(px4).Last().SetPoint;
        Assert.InRange(end.LatInt, 401_018_000 - 20, 401_018_000 + 20);
        Assert.InRange(end.Vx, -0.05, 0.05);
    }

    [Theory]
    [InlineData(Loiter, "mode AUTO.LOITER")]
    [InlineData(Posctl, "mode POSCTL")]
    public void Offboard_PilotTakesOver_EndsTheStreamWithinTwoReports(uint mode, string by)
    {
        using ScriptedAutopilot px4 = InOffboard();
        px4.Mode = mode;
        px4.Run(0.2);
        Assert.Equal((CommandAuthorityState.TakenAway, by), (px4.Authority, px4.Rig.Authority.TakenBy));
        int sent = px4.Received.Count;
        px4.Run(10);
        Assert.Equal(sent, px4.Received.Count);
        px4.Mode = Offboard;   // given back by a pilot's switch: not by the operator
        px4.Run(5);
        Assert.Equal(VehicleCommandOutcome.NotInCommand, px4.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
        Assert.Equal(sent, px4.Received.Count);
    }

    [Theory]
    [InlineData(VehicleCommandKind.Hold, Loiter)]
    [InlineData(VehicleCommandKind.Return, Rtl)]
    public void Offboard_OurOwnMode_StreamEndsWithTheFirstReportOfIt(VehicleCommandKind kind, uint mode)
    {
        using ScriptedAutopilot px4 = InOffboard();
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(kind, seconds: 1).Outcome);
        Assert.Equal((mode, CommandAuthorityState.Ours), (px4.Mode, px4.Authority));
        int sent = SetPoints(px4).Count;
        px4.Run(5);
        Assert.Equal(sent, SetPoints(px4).Count);
    }

    [Fact]
    public void Offboard_LinkIsLost_StreamPausesBeforeTheFailsafeAndGoesOnWithTheNextReport()
    {
        using ScriptedAutopilot px4 = InOffboard();
        px4.Beats = false;
        double lost = px4.Rig.Reactor.Now.TotalSeconds;
        px4.Run(2);
        Assert.InRange(SetPoints(px4).Last().Time.TotalSeconds, lost, lost + 0.55);
        int sent = SetPoints(px4).Count;
        px4.Beats = true;
        px4.Run(1.2);
        Assert.True(SetPoints(px4).Count > sent + 2);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
    }

    // PX4's own heartbeats go on: they prove one way only.
    [Fact]
    public void Offboard_UplinkIsLost_StreamPausesBeforeTheFailsafe()
    {
        using ScriptedAutopilot px4 = InOffboard();
        px4.ReportAnswer = null;
        double lost = px4.Rig.Reactor.Now.TotalSeconds;
        px4.Run(3);
        Assert.InRange(SetPoints(px4).Last().Time.TotalSeconds, lost, lost + 0.55);
        int sent = SetPoints(px4).Count;
        px4.ReportAnswer = MavResult.Accepted;
        px4.Run(0.6);
        Assert.True(SetPoints(px4).Count > sent + 2);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
    }

    [Fact]
    public void Offboard_OneRequestInFourIsLost_StreamGoesOn()
    {
        using ScriptedAutopilot px4 = InOffboard();
        int sent = SetPoints(px4).Count;
        for (int i = 0; i < 100; i++)
        {
            px4.ReportAnswer = i % 4 == 0 ? null : MavResult.Accepted;
            px4.Run(0.1);
        }

        Assert.InRange(SetPoints(px4).Count - sent, 195, 205);
    }

    [Fact]
    public void Offboard_FailsafeWhileTheLinkWasLost_NothingIsSentUntilTheOperatorSaysSo()
    {
        using ScriptedAutopilot px4 = InOffboard();
        px4.Beats = false;
        px4.Run(3);
        px4.Mode = Rtl;
        px4.Status = MavState.Critical;
        px4.Beats = true;
        int sent = px4.Received.Count;
        px4.Run(5);
        Assert.Equal(sent, px4.Received.Count);
        Assert.Equal(
            (CommandAuthorityState.TakenAway, TakeoverCause.Failsafe), (px4.Authority, px4.Rig.Authority.Cause));

        // AUTO.LOITER first, which ends the failsafe; then the stream, then OFFBOARD.
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(VehicleCommandKind.TakeControl).Outcome);
        Assert.Equal(CommandAuthorityState.Ours, px4.Authority);
        Assert.Equal(VehicleCommandOutcome.Refused, px4.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(VehicleCommandKind.Hold).Outcome);
        px4.Status = MavState.Active;
        px4.Run(1);
        int commands = px4.Commands.Count();
        Assert.Equal(VehicleCommandOutcome.Accepted, px4.GiveAndRun(VehicleCommandKind.GoTo).Outcome);
        Assert.Equal([MavCmd.DoSetMode], px4.Commands.Skip(commands));
        Assert.Equal(Offboard, px4.Mode);
    }

    [Fact]
    public void GoTo_InAFailsafe_IsRefusedAndNoSetPointSent()
    {
        using ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        px4.Status = MavState.Critical;
        px4.Run(1);
        VehicleCommandResult answer = px4.GiveAndRun(VehicleCommandKind.GoTo);
        Assert.Equal(VehicleCommandOutcome.Refused, answer.Outcome);
        Assert.Contains("no set-point is sent in a failsafe", answer.Text, StringComparison.Ordinal);
        Assert.Empty(SetPoints(px4));
    }

    private static ScriptedAutopilot InOffboard()
    {
        ScriptedAutopilot px4 = new ScriptedAutopilot(MavAutopilot.Px4).Armed();
        Go(px4);
        px4.Run(5);
        Assert.Equal(Offboard, px4.Mode);
        return px4;
    }

    // 200 m to the north, 5 m higher.
    private static long Go(ScriptedAutopilot px4) => px4.Give(VehicleCommandKind.GoTo, c => c with
    {
        Latitude = Angle.FromDegrees(40.1018),
        Longitude = Angle.FromDegrees(5.7),
        HeightAboveHomeMetres = 35,
        SpeedMetresPerSecond = 5,
        Yaw = Angle.FromRadians(1),
    });

    private static List<(TimeSpan Time, SetPositionTargetGlobalInt SetPoint)> SetPoints(ScriptedAutopilot px4)
        => px4.Received.Where(f => f.Frame.MessageId == SetPositionTargetGlobalInt.MavlinkId)
            .Select(f => (f.Time, OutgoingSink.Decode<SetPositionTargetGlobalInt>(f.Frame))).ToList();
}
