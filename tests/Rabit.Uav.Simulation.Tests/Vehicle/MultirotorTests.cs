using System;
using Rabit.Geodesy;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Vehicle;

/// <summary>How the body moves.</summary>
public class MultirotorTests
{
    private const double Step = SimulatedVehicle.StepSeconds;
    private const double Limit = 3;

    [Fact]
    public void FlyingNorth_PutsTheNoseDown()
    {
        Multirotor body = Hovering(yaw: 0);
        Fly(body, new NedVector(10, 0, 0), 1);
        Assert.InRange(body.Pitch, -0.5, -0.1);
        Assert.InRange(body.Roll, -0.02, 0.02);
        Assert.True(body.Velocity.North > 1);
    }

    [Fact]
    public void FlyingEast_PutsTheRightSideDown()
    {
        Multirotor body = Hovering(yaw: 0);
        Fly(body, new NedVector(0, 10, 0), 1);
        Assert.InRange(body.Roll, 0.1, 0.5);
        Assert.InRange(body.Pitch, -0.02, 0.02);
        Assert.True(body.Velocity.East > 1);
    }

    [Fact]
    public void FlyingEast_NoseEast_PutsTheNoseDown()
    {
        Multirotor body = Hovering(yaw: Math.PI / 2);
        Fly(body, new NedVector(0, 10, 0), 1);
        Assert.InRange(body.Pitch, -0.5, -0.1);
        Assert.InRange(body.Roll, -0.02, 0.02);
    }

    [Fact]
    public void HoldingAgainstWind_LeansIntoIt()
    {
        Multirotor body = Hovering(yaw: 0);
        var fromNorth = new NedVector(-10, 0, 0);
        Fly(body, default, 20, fromNorth);
        Assert.InRange(body.Velocity.HorizontalLength(), 0, 0.05);
        Assert.Equal(-Math.Atan(0.2 * 10 / NedMath.Gravity), body.Pitch, 2);
    }

    [Fact]
    public void Acceleration_FullReversal_StaysWithinItsLimit()
    {
        Multirotor body = Hovering(yaw: 0.3);
        double worst = 0;
        foreach (NedVector velocity
            in (NedVector[])[new(8, 0, 0), new(-8, 0, 0), new(0, 8, -2), new(8, -8, 1.5), default])
        {
            for (int step = 0; step < 600; step++)
            {
                Fly(body, velocity, Step);
                worst = Math.Max(worst, body.Acceleration.HorizontalLength());
            }
        }

        Assert.InRange(worst, 0.8 * Limit, 1.2 * Limit);
        Assert.InRange(Math.Max(Math.Abs(body.Pitch), Math.Abs(body.Roll)), 0, 30 * NedMath.RadiansPerDegree);
    }

    [Fact]
    public void Attitude_AfterACommand_FollowsWithALag()
    {
        Multirotor body = Hovering(yaw: 0);
        Fly(body, new NedVector(10, 0, 0), Step);
        double first = body.Pitch;
        Fly(body, new NedVector(10, 0, 0), 1);
        Assert.InRange(first / body.Pitch, 0.001, 0.2);
    }

    [Fact]
    public void Yaw_ToAnotherHeading_TurnsTheShortWayAtItsRate()
    {
        Multirotor body = Hovering(yaw: 3);
        double fastest = 0;
        for (int step = 0; step < 500; step++)
        {
            double before = body.Yaw;
            body.Step(Command(default, yaw: -2), default, Step);
            fastest = Math.Max(fastest, (body.Yaw - before) / Step);
        }

        Assert.InRange(fastest, 0.5, 60 * NedMath.RadiansPerDegree + 1e-9);
        Assert.Equal((2 * Math.PI) - 2, body.Yaw, 2);
    }

    [Fact]
    public void BodyRates_TurningWhileLevel_AreTheYawRate()
    {
        Multirotor body = Hovering(yaw: 0);
        for (int step = 0; step < 100; step++)
        {
            var command = Command(default, yaw: double.NaN);
            command.YawRate = 0.5;
            body.Step(command, default, Step);
        }

        Assert.Equal(0.5, body.Rates.YawRadiansPerSecond, 2);
    }

    [Fact]
    public void Ground_IsNotPassed()
    {
        Multirotor body = Hovering(yaw: 0);
        Fly(body, new NedVector(2, 0, 1.5), 20);
        Assert.Equal(0, body.Position.Down);
        Assert.Equal(0, body.Velocity.HorizontalLength());
        Assert.InRange(body.TouchdownSpeed, 1.2, 1.8);
    }

    [Fact]
    public void MotorsOff_InTheAir_Falls()
    {
        Multirotor body = Hovering(yaw: 0);
        for (int step = 0; step < 100; step++)
            body.Step(new MotionCommand { Motors = MotorState.Off }, default, Step);
        Assert.InRange(body.Velocity.Down, 7, 9);
    }

    [Fact]
    public void ConstantVelocity_PositionIsItsIntegral()
    {
        Multirotor body = Hovering(yaw: 0);
        Fly(body, new NedVector(5, -3, 0), 10);
        NedVector before = body.Position;
        Fly(body, new NedVector(5, -3, 0), 10);
        Assert.Equal(50, body.Position.North - before.North, 0);
        Assert.Equal(-30, body.Position.East - before.East, 0);
    }

    private static Multirotor Hovering(double yaw) => new() { Position = new NedVector(0, 0, -20), Yaw = yaw };

    private static void Fly(Multirotor body, NedVector velocity, double seconds, NedVector wind = default)
    {
        double yaw = body.Yaw;
        for (int step = 0; step < (int)Math.Round(seconds / Step); step++)
            body.Step(Command(velocity, yaw), wind, Step);
    }

    private static MotionCommand Command(NedVector velocity, double yaw) => new()
    {
        Motors = MotorState.Flying,
        Velocity = velocity,
        HorizontalAcceleration = Limit,
        VerticalAcceleration = 1,
        Yaw = yaw,
    };
}
