using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>Whole flights, commanded by frames.</summary>
public class FlightTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(1, 0)]
    [InlineData(2, 8)]
    public void Mission_TakeOffGoToReturn_LandsAtHomeAndDisarms(long seed, double wind)
    {
        output.WriteLine($"seed {seed}");
        using var ground = new Ground(new SimulationOptions { Seed = seed, WindMetresPerSecond = wind });
        ground.Stream(ExtendedSysState.MavlinkId, 4);
        ground.TakeOff(20);
        Assert.Equal(MavState.Active, ground.Heartbeat.SystemStatus);
        ground.GoTo(100, 40, 30);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.DoChangeSpeed, 1, 6, -1));
        ground.RunUntil(
            () => Distance(ground, 100, 40) < 4 && -ground.Truth.Pose.Position.Down > 26, 60, "at the target");
        ground.Run(15);
        Assert.True(Distance(ground, 100, 40) < 4, $"{Distance(ground, 100, 40)} m");
        Assert.InRange(ground.Truth.MaxSpeedMetresPerSecond, 5, 7.5);

        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.NavReturnToLaunch));
        ground.RunUntil(() => !ground.IsArmed, 200, "landed and disarmed");
        SimulatedTruth truth = ground.Truth;
        output.WriteLine($"landed {Distance(ground, 0, 0):0.00} m from home at {truth.TouchdownMetresPerSecond:0.00} "
            + $"m/s, {truth.BatteryRemaining:P1} left, {truth.Airtime}");
        Assert.NotNull(truth.Landing);
        Assert.True(Distance(ground, 0, 0) < 3);
        Assert.InRange(truth.TouchdownMetresPerSecond, 0.2, 1);
        Assert.False(truth.HasCrashed);
        Assert.Equal(CopterMode.Rtl, (CopterMode)ground.Heartbeat.CustomMode);
        Assert.Equal(MavState.Standby, ground.Heartbeat.SystemStatus);
        Assert.Equal(
            [MavLandedState.OnGround, MavLandedState.Takeoff, MavLandedState.InAir, MavLandedState.Landing,
                MavLandedState.OnGround],
            Changes(ground.All<ExtendedSysState>().Select(s => s.Message.LandedState).ToArray()));
    }

    [Fact]
    public void Land_FromGuided_ComesDownWhereItIs()
    {
        using var ground = new Ground();
        ground.TakeOff(15);
        TruePose above = ground.Truth.Pose;
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.NavLand));
        ground.RunUntil(() => !ground.IsArmed, 60, "disarmed");

        TruePose landing = ground.Truth.Landing!.Value;
        Assert.InRange(landing.Position.North - above.Position.North, -1, 1);
        Assert.InRange(landing.Position.East - above.Position.East, -1, 1);
        Assert.Contains("Disarming motors", ground.Texts);
        Assert.Equal(CopterMode.Land, (CopterMode)ground.Heartbeat.CustomMode);
    }

    [Fact]
    public void Land_Below10Metres_SlowsDown()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(25);
        ground.Command(MavCmd.NavLand);
        ground.RunUntil(() => -ground.Truth.Pose.Position.Down < 15, 60, "at 15 m");
        Assert.InRange(ground.Truth.Pose.VelocityNed.Down, 1.3, 1.6);
        ground.RunUntil(() => -ground.Truth.Pose.Position.Down < 5, 60, "at 5 m");
        Assert.InRange(ground.Truth.Pose.VelocityNed.Down, 0.4, 0.6);
    }

    [Fact]
    public void Return_FromLow_ClimbsFirst()
    {
        using var ground = new Ground();
        ground.TakeOff(5);
        ground.GoTo(60, 0, 5);
        ground.RunUntil(() => Distance(ground, 60, 0) < 4, 60, "out");
        ground.Command(MavCmd.NavReturnToLaunch);
        ground.RunUntil(() => Distance(ground, 60, 0) > 10, 60, "on the way");
        Assert.InRange(-ground.Truth.Pose.Position.Down, 12, 18);
    }

    [Fact]
    public void Arm_WithoutTakeOff_DisarmsAfterTenSeconds()
    {
        using var ground = new Ground();
        ground.Run(6);
        ground.SetMode(CopterMode.Guided);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.ComponentArmDisarm, 1));
        ground.Run(9);
        Assert.True(ground.IsArmed);
        ground.Run(3);
        Assert.False(ground.IsArmed);
    }

    [Fact]
    public void Hover_InWind_HoldsItsPlace()
    {
        using var ground = new Ground(
            new SimulationOptions { Seed = 3, WindMetresPerSecond = 10, WindFrom = Angle.FromRadians(1) });
        ground.TakeOff(20);
        ground.Run(5);
        TruePose start = ground.Truth.Pose;
        double worst = 0;
        for (int second = 0; second < 60; second++)
        {
            ground.Run(1);
            worst = Math.Max(worst, Distance(ground, start.Position.North, start.Position.East));
        }

        output.WriteLine($"{worst:0.00} m at most");
        Assert.InRange(worst, 0.01, 2);
    }

    [Fact]
    public void GoTo_DefaultHeading_PointsAlongTheFlight()
    {
        using var ground = new Ground(new SimulationOptions { WindMetresPerSecond = 0 });
        ground.TakeOff(20);
        ground.GoTo(0, 80, 20);
        ground.Run(8);
        Assert.InRange(ground.Truth.Pose.Attitude.Yaw.Radians, (Math.PI / 2) - 0.1, (Math.PI / 2) + 0.1);
    }

    [Fact]
    public void Reposition_IntInGuided_FliesThere()
    {
        using var ground = new Ground();
        ground.TakeOff(20);
        Assert.Equal(MavResult.Accepted, ground.Command(Reposition(ground, 0)));
        ground.Run(25);
        Assert.True(Distance(ground, 0, 0) > 40);
    }

    [Fact]
    public void Gimbal_Commanded_TurnsTheCameraAtItsRate()
    {
        using var ground = new Ground();
        ground.Run(1);
        Assert.Equal(-Math.PI / 2, ground.Truth.Pose.CameraPitch.Radians, 6);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.DoGimbalManagerPitchyaw, -30, 20, float.NaN, float.NaN));
        ground.Run(0.5);
        Assert.InRange(ground.Truth.Pose.CameraPitch.Radians / Ground.RadiansPerDegree, -62, -57);
        ground.Run(1);
        Assert.Equal(-30, ground.Truth.Pose.CameraPitch.Radians / Ground.RadiansPerDegree, 3);
        Assert.Equal(20, ground.Truth.Pose.CameraYaw.Radians / Ground.RadiansPerDegree, 3);
    }

    internal static CommandInt Reposition(Ground ground, float flags) => new()
    {
        TargetSystem = 1,
        TargetComponent = 1,
        Command = MavCmd.DoReposition,
        Frame = MavFrame.GlobalRelativeAltInt,
        Param1 = -1,
        Param2 = flags,
        Param4 = float.NaN,
        X = (int)(ground.Options.Home.Latitude.Degrees * 1e7) + 5389,
        Y = (int)(ground.Options.Home.Longitude.Degrees * 1e7),
        Z = 20,
    };

    internal static double Distance(Ground ground, double north, double east)
    {
        TruePose pose = ground.Truth.Pose;
        return Math.Sqrt(
            ((pose.Position.North - north) * (pose.Position.North - north))
                + ((pose.Position.East - east) * (pose.Position.East - east)));
    }

    private static MavLandedState[] Changes(MavLandedState[] states)
        => states.Where((s, i) => i == 0 || states[i - 1] != s).ToArray();
}
