using System;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.AutopilotInterface;

/// <summary>Velocities: repeated here, and never longer than they are commanded.</summary>
public class VelocityTests
{
    [Fact]
    public void Velocity_Repeated_GoesOutFiveTimesASecond()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        for (int second = 0; second < 10; second++)
            Assert.Equal(
                VehicleCommandOutcome.Accepted, copter.GiveAndRun(VehicleCommandKind.Velocity, seconds: 1).Outcome);

        double[] times = SetPoints(copter);
        Assert.InRange(times.Length, 50, 62);
        Assert.All(times.Zip(times.Skip(1), (a, b) => b - a), pause => Assert.InRange(pause, 0, 0.26));
        SetPositionTargetLocalNed target = copter.Last<SetPositionTargetLocalNed>();
        Assert.Equal(
            (3f, 1f, 0f, MavFrame.LocalNed, 1, 1),
            (target.Vx, target.Vy, target.Vz, target.CoordinateFrame, target.TargetSystem, target.TargetComponent));
        Assert.Equal(0x0DC7, (int)target.TypeMask);   // velocity alone
        Assert.All(copter.Answers.Skip(1), a => Assert.Equal(VehicleCommandOutcome.Accepted, a.Outcome));
    }

    [Fact]
    public void Velocity_WithHeading_SendsIt()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.GiveAndRun(VehicleCommandKind.Velocity, 0.5, c => c with { Yaw = Angle.FromRadians(1) });
        SetPositionTargetLocalNed target = copter.Last<SetPositionTargetLocalNed>();
        Assert.Equal((1f, 0x09C7), (target.Yaw, (int)target.TypeMask));
    }

    [Fact]
    public void Velocity_NotRepeated_EndsWithHold()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.VelocityNed = new NedVector(3, 1, 0);
        copter.Give(VehicleCommandKind.Velocity);
        double givenAt = copter.Rig.Reactor.Now.TotalSeconds;
        copter.Run(6);

        Assert.InRange(SetPoints(copter).Last() - givenAt, 1.2, 1.6);
        (TimeSpan time, MavlinkFrame hold) = copter.Received[copter.Received.Count - 1];
        Assert.Equal(MavCmd.DoReposition, ScriptedAutopilot.CommandOf(hold));
        Assert.InRange(time.TotalSeconds - givenAt, 1.4, 1.8);
        Assert.Equal(2, copter.Answers.Count);   // of Arm and Velocity: the hold was not commanded
        Assert.Equal(CommandAuthorityState.Ours, copter.Authority);
    }

    [Fact]
    public void Velocity_NotRepeatedWhileTheCameraIsTurned_StillEndsWithHold()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.Script = (frame, command) => command == MavCmd.DoGimbalManagerPitchyaw
            ? null
            : copter.Accept(frame, command);
        copter.Give(VehicleCommandKind.Velocity);
        copter.Run(0.5);
        copter.Give(VehicleCommandKind.PointCamera);
        copter.Run(0.5);
        int before = SetPoints(copter).Length;
        Assert.True(before > 3);
        copter.Run(6);
        Assert.Equal(MavCmd.DoReposition, copter.Commands.Last());
    }

    [Theory]
    [InlineData(VehicleCommandKind.GoTo)]
    [InlineData(VehicleCommandKind.Hold)]
    [InlineData(VehicleCommandKind.Return)]
    [InlineData(VehicleCommandKind.Land)]
    public void Velocity_FollowedByAnotherCommand_IsNotSentAnyMore(VehicleCommandKind kind)
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.GiveAndRun(VehicleCommandKind.Velocity, 1);
        copter.Give(kind);
        copter.Run(0.01);
        int setPoints = SetPoints(copter).Length;
        copter.Run(5);
        Assert.Equal(setPoints, SetPoints(copter).Length);
        Assert.Equal(1, copter.Commands.Skip(2).Count(c => c is MavCmd.DoReposition or MavCmd.DoSetMode));
    }

    [Fact]
    public void Velocity_AnotherModeOfOurs_TakesGuidedFirst()
    {
        using ScriptedAutopilot copter = new ScriptedAutopilot().Armed();
        copter.GiveAndRun(VehicleCommandKind.Return);
        copter.Give(VehicleCommandKind.Velocity);
        copter.Run(1.3);
        Assert.Equal((uint)CopterMode.Guided, copter.Mode);
        Assert.NotEmpty(SetPoints(copter));
        TimeSpan asked = copter.Received.Last(f => ScriptedAutopilot.CommandOf(f.Frame) == MavCmd.DoSetMode).Time;
        Assert.True(SetPoints(copter)[0] > asked.TotalSeconds);
    }

    private static double[] SetPoints(ScriptedAutopilot copter)
        => copter.Received.Where(f => f.Frame.MessageId == SetPositionTargetLocalNed.MavlinkId)
            .Select(f => f.Time.TotalSeconds).ToArray();
}
