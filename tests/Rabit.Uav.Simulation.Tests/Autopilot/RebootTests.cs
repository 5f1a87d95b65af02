using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>A start again of the autopilot: on the ground by command, in flight by the script.</summary>
public class RebootTests
{
    [Fact]
    public void Command_OnTheGround_StartsAgainInStabilize()
    {
        using var ground = new Ground(
            new SimulationOptions { TelemetryLatency = TimeSpan.Zero, BootedBefore = TimeSpan.FromSeconds(60) });
        ground.Run(7);
        ground.SetMode(CopterMode.Guided);
        ground.Stream(SystemTime.MavlinkId, 10);
        ground.Run(2);
        Assert.InRange(ground.Last<SystemTime>().TimeBootMs, 68_000u, 70_000u);

        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.PreflightRebootShutdown, 1));
        double rebooted = ground.Now.TotalSeconds;
        ground.Forget();
        ground.Run(1.2);
        (TimeSpan time, Heartbeat first) = ground.All<Heartbeat>().First();
        Assert.InRange(time.TotalSeconds - rebooted, 0.8, 1);
        Assert.Equal((0u, MavState.Boot), (first.CustomMode, first.SystemStatus));
        ground.Run(2);
        Assert.Equal(MavState.Standby, ground.Heartbeat.SystemStatus);
        Assert.Equal(0, ground.Count<SystemTime>());
        ground.Command(MavCmd.RequestMessage, SystemTime.MavlinkId);
        ground.Run(0.1);
        Assert.InRange(ground.Last<SystemTime>().TimeBootMs, 3_000u, 4_000u);
        ground.Run(4);
        Assert.Contains("EKF3 IMU0 is using GPS", ground.Texts);
    }

    [Fact]
    public void Command_WhileArmed_FailsUnlessForced()
    {
        using var ground = new Ground();
        ground.TakeOff(10);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.PreflightRebootShutdown, 1));
        Assert.Equal(MavResult.Unsupported, ground.Command(MavCmd.PreflightRebootShutdown, 0));
        Assert.True(ground.Truth.IsArmed);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.PreflightRebootShutdown, 1, p6: 20190226));
        ground.Run(5);
        Assert.True(ground.Truth.HasCrashed);
    }

    [Theory]
    [InlineData(0, false)]
    [InlineData(1, true)]
    public void Script_InFlight_HoldsOrFalls(double value, bool falls)
    {
        using var ground = new Ground(new SimulationOptions
        {
            Faults = [new ScriptedFault
            {
                Kind = ScriptedFaultKind.Reboot,
                At = TimeSpan.FromSeconds(40),
                Value = value,
            }],
        });
        ground.TakeOff(20);
        ground.Stream(Attitude.MavlinkId, 10);
        FailsafeTests.RunTo(ground, 41.5);
        ground.Forget();
        FailsafeTests.RunTo(ground, 50);
        Assert.Equal(falls, ground.Truth.HasCrashed);
        Assert.Equal(!falls, ground.Truth.IsArmed);
        Assert.Equal(CopterMode.Stabilize, (CopterMode)ground.Heartbeat.CustomMode);
        Assert.Equal(0, ground.Count<Attitude>());
        if (falls)
            return;
        Assert.Equal(MavState.Active, ground.Heartbeat.SystemStatus);
        Assert.Equal(MavResult.Accepted, ground.SetMode(CopterMode.Rtl));
    }

    [Fact]
    public void Reboot_KeepsParametersAndFence_CountsTheBatteryFromFull()
    {
        using var ground = new Ground(new SimulationOptions { BatteryRemaining = 0.5 });
        ground.Run(7);
        ground.Send(new ParamSet
        {
            TargetSystem = 1,
            TargetComponent = 1,
            ParamId = new Text16("FS_GCS_ENABLE"),
            ParamValue = 1,
        });
        ground.Run(0.5);
        ground.Command(MavCmd.PreflightRebootShutdown, 1);
        ground.Run(3);
        ground.Stream(SysStatus.MavlinkId, 5);
        ground.Send(new ParamRequestRead
        {
            TargetSystem = 1,
            TargetComponent = 1,
            ParamId = new Text16("FS_GCS_ENABLE"),
            ParamIndex = -1,
        });
        ground.Run(1);
        Assert.Equal(1, ground.Last<ParamValue>().Value);
        Assert.Equal(100, ground.Last<SysStatus>().BatteryRemaining);
    }
}
