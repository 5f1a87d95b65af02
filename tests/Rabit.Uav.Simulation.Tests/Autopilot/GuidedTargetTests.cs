using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>Position and velocity targets of GUIDED.</summary>
public class GuidedTargetTests
{
    private const double Degree = Ground.RadiansPerDegree;

    [Fact]
    public void VelocityTarget_NotRepeated_StopsAfterThreeSeconds()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(20);
        ground.Fly(5, 0, 0);
        ground.Run(2.9);
        Assert.InRange(ground.Truth.Pose.VelocityNed.North, 4.5, 5.5);
        ground.Run(4);
        Assert.InRange(ground.Truth.Pose.VelocityNed.North, -0.3, 0.3);
        TruePose stopped = ground.Truth.Pose;
        ground.Run(20);
        Assert.True(FlightTests.Distance(ground, stopped.Position.North, stopped.Position.East) < 1.5, "and it stays");
    }

    [Fact]
    public void VelocityTarget_Repeated_GoesOn()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(20);
        for (int second = 0; second < 10; second++)
        {
            ground.Fly(0, -4, -0.5);
            ground.Run(1);
        }

        Assert.InRange(ground.Truth.Pose.VelocityNed.East, -4.3, -3.7);
        Assert.InRange(ground.Truth.Pose.VelocityNed.Down, -0.6, -0.4);
    }

    [Fact]
    public void PositionTarget_SentOnce_Persists()
    {
        using var ground = new Ground();
        ground.TakeOff(20);
        ground.GoTo(150, 0, 20);
        ground.Run(40);
        Assert.True(FlightTests.Distance(ground, 150, 0) < 4);
    }

    [Fact]
    public void Targets_OutsideGuided_AreIgnoredInSilence()
    {
        using var ground = new Ground();
        ground.TakeOff(20);
        ground.SetMode(CopterMode.Loiter);
        ground.Run(3);
        TruePose pose = ground.Truth.Pose;
        int frames = ground.Count<CommandAck>();
        ground.GoTo(100, 0, 20);
        ground.Fly(5, 0, 0);
        ground.Run(10);
        Assert.True(FlightTests.Distance(ground, pose.Position.North, pose.Position.East) < 2);
        Assert.Equal(frames, ground.Count<CommandAck>());
    }

    [Theory]
    [InlineData(4095, MavFrame.LocalNed)]      // nothing to fly
    [InlineData(3527 + 512, MavFrame.LocalNed)]   // force
    [InlineData(3527, MavFrame.LocalEnu)]      // a frame that it does not know
    public void Targets_Invalid_StopTheVehicle(int mask, MavFrame axes)
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(20);
        ground.GoTo(200, 0, 20);
        ground.Run(8);
        Assert.True(ground.Truth.Pose.VelocityNed.North > 5);
        ground.Send(
            new SetPositionTargetLocalNed
            {
                TargetSystem = 1,
                TargetComponent = 1,
                CoordinateFrame = axes,
                TypeMask = (PositionTargetTypemask)mask,
                Vx = 5
            });
        ground.Run(8);
        Assert.InRange(ground.Truth.Pose.VelocityNed.North, -0.5, 0.5);
    }

    [Fact]
    public void Targets_OnTheGround_AreNotFlown()
    {
        using var ground = new Ground();
        ground.Run(6);
        ground.SetMode(CopterMode.Guided);
        ground.Command(MavCmd.ComponentArmDisarm, 1);
        ground.GoTo(50, 0, 20);
        ground.Run(8);
        Assert.False(ground.Truth.HasFlown);
    }

    [Fact]
    public void BodyVelocity_GoesWhereTheNoseIs()
    {
        using var ground = new Ground(
            new SimulationOptions { WindMetresPerSecond = 0, Heading = Angle.FromDegrees(90) });
        ground.TakeOff(20);
        for (int second = 0; second < 5; second++)
        {
            ground.Send(new SetPositionTargetLocalNed
            {
                TargetSystem = 1,
                TargetComponent = 1,
                CoordinateFrame = MavFrame.BodyOffsetNed,
                TypeMask = (PositionTargetTypemask)3527,
                Vx = 4,
            });
            ground.Run(1);
        }

        Assert.InRange(ground.Truth.Pose.VelocityNed.East, 3.5, 4.5);
        Assert.InRange(ground.Truth.Pose.VelocityNed.North, -0.5, 0.5);
    }

    [Fact]
    public void Yaw_SetByCommand_StaysForTheNextTargetOfThatKind()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(20);
        ground.GoTo(50, 0, 20);
        ground.Run(1);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.ConditionYaw, 200, 30, 1, 0));
        ground.GoTo(60, 0, 20);
        ground.Run(10);
        Assert.Equal(200, Math.Round((ground.Truth.Pose.Attitude.Yaw.Radians / Degree) + 720) % 360);
    }

    [Fact]
    public void Speed_ChangedByCommand_HoldsForTargetsOfThatKindOnly()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(20);
        ground.GoTo(300, 0, 20);
        ground.Command(MavCmd.DoChangeSpeed, 1, 4, -1);
        ground.Run(10);
        Assert.InRange(ground.Truth.Pose.VelocityNed.North, 3.7, 4.3);
        ground.GoTo(301, 0, 20);
        ground.Run(5);
        Assert.InRange(ground.Truth.Pose.VelocityNed.North, 3.7, 4.3);
        ground.Fly(0, 0, 0);
        ground.Run(2);
        ground.GoTo(300, 0, 20);
        ground.Run(8);
        Assert.InRange(ground.Truth.Pose.VelocityNed.North, 9, 11);
    }

    [Fact]
    public void Pause_StopsUntilContinued()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(20);
        ground.GoTo(200, 0, 20);
        ground.Run(6);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.DoPauseContinue, 0));
        ground.Run(10);
        Assert.InRange(ground.Truth.Pose.VelocityNed.North, -0.3, 0.3);
        double stopped = ground.Truth.Pose.Position.North;
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.DoPauseContinue, 1));
        ground.Run(5);
        Assert.True(ground.Truth.Pose.Position.North > stopped + 10);
    }
}
