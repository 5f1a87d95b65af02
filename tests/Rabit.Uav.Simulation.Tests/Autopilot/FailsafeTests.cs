using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Autopilot;

/// <summary>
/// What the autopilot does by itself when something fails, and that it does nothing where a parameter says so. The
/// recordings of the real one are in <see cref="Recordings.CopterRecordingTests"/>.
/// </summary>
public class FailsafeTests
{
    private const double FaultAt = 40;
    private const MavSysStatusSensor Battery = MavSysStatusSensor.Battery;
    private const MavSysStatusSensor Radio = MavSysStatusSensor.RcReceiver;

    [Fact]
    public void GroundStation_Silent_ReturnsAndStaysInTheModeWhenItIsBack()
    {
        using Ground ground = Fly(
            [Fault(ScriptedFaultKind.GroundStationSilent, seconds: 10)], ("FS_GCS_ENABLE", 1));
        double returned = TimeUntil(ground, CopterMode.Rtl);

        Assert.InRange(returned - FaultAt, 4, 5.2);
        Assert.Equal(MavState.Critical, Copter(ground).SystemStatus);
        Assert.Contains("GCS Failsafe", ground.Texts);
        ground.Run(8);
        Assert.Contains("GCS Failsafe Cleared", ground.Texts);
        Assert.Equal(MavState.Active, Copter(ground).SystemStatus);
        Assert.Equal(CopterMode.Rtl, (CopterMode)ground.Truth.CustomMode);
    }

    [Theory]
    [InlineData(0, CopterMode.Guided)]
    [InlineData(5, CopterMode.Land)]
    [InlineData(7, CopterMode.Brake)]
    public void GroundStation_Silent_DoesWhatTheParameterSays(int action, CopterMode mode)
    {
        using Ground ground = Fly([Fault(ScriptedFaultKind.GroundStationSilent)], ("FS_GCS_ENABLE", action));
        RunTo(ground, FaultAt + 7);
        Assert.Equal(mode, (CopterMode)ground.Truth.CustomMode);
    }

    [Fact]
    public void GroundStation_SilentWhileThePilotFlies_GoesOn()
    {
        using Ground ground = Fly([Fault(ScriptedFaultKind.GroundStationSilent)], ("FS_GCS_ENABLE", 1));
        ground.SetMode(CopterMode.Loiter);
        RunTo(ground, FaultAt + 7);
        Assert.Equal(CopterMode.Loiter, (CopterMode)ground.Truth.CustomMode);
        Assert.Contains("GCS Failsafe - Continuing Pilot Control", ground.Texts);
    }

    [Fact]
    public void GroundStation_ThroughTheCompanionsLink_IsLostWithIt()
    {
        using var ground = new Ground(new SimulationOptions { Parameters = Parameters([("FS_GCS_ENABLE", 1)]) });
        ground.TakeOff();
        for (int second = 0; second < 10; second++)
        {
            ground.Send(new Heartbeat { Type = MavType.Gcs });
            ground.Run(1);
        }

        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
        for (int second = 0; second < 7; second++)
        {
            ground.Send(new Heartbeat { Type = MavType.OnboardController }, system: 1, component: 191);
            ground.Run(1);
        }

        Assert.Equal(CopterMode.Rtl, (CopterMode)ground.Truth.CustomMode);
    }

    [Theory]
    [InlineData(1, 16, CopterMode.Rtl, "Radio Failsafe")]
    [InlineData(3, 16, CopterMode.Land, "Radio Failsafe")]
    [InlineData(1, 20, CopterMode.Guided, "Radio Failsafe - Continuing Guided Mode")]
    public void Radio_Lost_DoesWhatTheParametersSay(int action, int options, CopterMode mode, string text)
    {
        using Ground ground = Fly(
            [Fault(ScriptedFaultKind.RcLost, seconds: 5)], ("FS_THR_ENABLE", action), ("FS_OPTIONS", options));
        ground.Stream(SysStatus.MavlinkId, 10);
        RunTo(ground, FaultAt + 1.5);

        Assert.Equal(mode, (CopterMode)ground.Truth.CustomMode);
        Assert.Contains(text, ground.Texts);
        Assert.Equal(Radio, Unhealthy(ground));
        Assert.Equal(MavState.Critical, Copter(ground).SystemStatus);
        ground.Run(5);
        Assert.Contains("Radio Failsafe Cleared", ground.Texts);
        Assert.Equal(MavState.Active, Copter(ground).SystemStatus);
    }

    [Fact]
    public void Radio_LostOnTheGround_Disarms()
    {
        using var ground = new Ground(new SimulationOptions { Faults = [Fault(ScriptedFaultKind.RcLost, at: 10)] });
        ground.Run(8);
        ground.SetMode(CopterMode.Guided);
        Assert.Equal(MavResult.Accepted, ground.Command(MavCmd.ComponentArmDisarm, 1));
        RunTo(ground, 12);
        Assert.False(ground.Truth.IsArmed);
        Assert.Contains("Radio Failsafe - Disarming", ground.Texts);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.ComponentArmDisarm, 1));
        ground.Run(0.2);
        Assert.Contains("Arm: Radio failsafe on", ground.Texts);
    }

    [Fact]
    public void Battery_VoltageLowForATime_IsLatchedAndArmingIsRejected()
    {
        ScriptedFault low = Fault(ScriptedFaultKind.BatteryVolts, 10.3, seconds: 8);
        using Ground ground = Fly(
            [low], ("BATT_LOW_VOLT", 10.5), ("BATT_LOW_TIMER", 4), ("BATT_FS_LOW_ACT", 2), ("BATT_CAPACITY", 8000));
        ground.Stream(SysStatus.MavlinkId, 10);
        ground.Stream(BatteryStatus.MavlinkId, 10);
        double returned = TimeUntil(ground, CopterMode.Rtl);

        Assert.InRange(returned - FaultAt, 4, 4.3);
        ground.Run(8);
        Assert.True(ground.Last<SysStatus>().VoltageBattery > 11_000);
        Assert.Equal(Battery, Unhealthy(ground));
        Assert.Equal(MavBatteryChargeState.Low, ground.Last<BatteryStatus>().ChargeState);
        ground.RunUntil(() => !ground.Truth.IsArmed, 100, "landed");
        Assert.Equal(MavState.Critical, Copter(ground).SystemStatus);
        ground.SetMode(CopterMode.Guided);
        Assert.Equal(MavResult.Failed, ground.Command(MavCmd.ComponentArmDisarm, 1));
        ground.Run(0.2);
        Assert.Equal("Arm: Battery failsafe", ground.Texts.Last());
    }

    [Fact]
    public void Battery_VoltageLowForAMoment_IsNothing()
    {
        using Ground ground = Fly(
            [Fault(ScriptedFaultKind.BatteryVolts, 10.3, seconds: 3)], ("BATT_LOW_TIMER", 4), ("BATT_FS_LOW_ACT", 2));
        RunTo(ground, FaultAt + 10);
        Assert.Equal(MavState.Active, Copter(ground).SystemStatus);
    }

    [Fact]
    public void Battery_LowThenCritical_ReturnsThenLands()
    {
        ScriptedFault low = Fault(ScriptedFaultKind.BatteryVolts, 10.3);
        ScriptedFault critical = Fault(ScriptedFaultKind.BatteryVolts, 9.5, at: FaultAt + 6);
        using Ground ground = Fly(
            [low, critical], ("BATT_LOW_TIMER", 4), ("BATT_CRT_VOLT", 10), ("BATT_FS_LOW_ACT", 2),
            ("BATT_FS_CRT_ACT", 1));
        RunTo(ground, FaultAt + 5);
        Assert.Equal(CopterMode.Rtl, (CopterMode)ground.Truth.CustomMode);
        RunTo(ground, FaultAt + 11);
        Assert.Equal(CopterMode.Land, (CopterMode)ground.Truth.CustomMode);
        Assert.Equal(2, ground.Texts.Count(t => t == "Battery Failsafe"));
    }

    [Fact]
    public void Battery_CriticalWithoutAnAction_DoesNotEndAReturn()
    {
        using Ground ground = Fly(
            [Fault(ScriptedFaultKind.BatteryVolts, 10.3), Fault(ScriptedFaultKind.BatteryVolts, 9.5, at: FaultAt + 6)],
            ("BATT_LOW_TIMER", 4), ("BATT_CRT_VOLT", 10), ("BATT_FS_LOW_ACT", 2));
        RunTo(ground, FaultAt + 12);
        Assert.Equal(CopterMode.Rtl, (CopterMode)ground.Truth.CustomMode);
        Assert.Contains(ground.Texts, t => t.StartsWith("Battery 1 is critical 9.50V", StringComparison.Ordinal));
    }

    [Fact]
    public void Battery_LittleChargeLeft_ActsAtOnceWhateverTheVoltage()
    {
        using Ground ground = Fly([], ("BATT_LOW_MAH", 7850), ("BATT_FS_LOW_ACT", 2), ("BATT_LOW_TIMER", 0));
        ground.RunUntil(() => ground.Truth.CustomMode == (uint)CopterMode.Rtl, 60, "RTL at 150 mAh");
        Assert.Contains(ground.Texts, t => t.EndsWith("used 150 mAh", StringComparison.Ordinal));
    }

    [Fact]
    public void Gps_Lost_LandsAndTakesNoModeWithAPositionUntilItIsBack()
    {
        using Ground ground = Fly([Fault(ScriptedFaultKind.GpsLost, seconds: 14)], 40);
        ground.Stream(GpsRawInt.MavlinkId, 10);
        ground.Stream(EkfStatusReport.MavlinkId, 10);
        double landed = TimeUntil(ground, CopterMode.Land);

        Assert.InRange(landed - FaultAt, 7.9, 8.4);
        Assert.Equal(GpsFixType.NoFix, ground.Last<GpsRawInt>().FixType);
        Assert.Equal((EkfStatusFlags)0x8025, ground.Last<EkfStatusReport>().Flags);
        Assert.Equal(MavState.Critical, Copter(ground).SystemStatus);
        Assert.Equal(MavResult.Failed, ground.Command(FlightTests.Reposition(ground, 1)));
        Assert.Equal(MavResult.Failed, ground.SetMode(CopterMode.Rtl));
        ground.Run(0.2);
        Assert.Contains("Mode change to RTL failed: requires position", ground.Texts);
        RunTo(ground, FaultAt + 16);
        Assert.Contains("EKF Failsafe Cleared", ground.Texts);
        Assert.Equal(MavResult.Accepted, ground.SetMode(CopterMode.Guided));
    }

    // The vehicle is steered by the barometer; the receiver says where it is.
    [Fact]
    public void Gps_BarometerDrifts_ReportsTheTrueAltitude()
    {
        using var ground = new Ground(
            new SimulationOptions { Seed = 3, WindMetresPerSecond = 0, BarometerDriftMetres = 20 });
        ground.Stream(GpsRawInt.MavlinkId, 10);
        ground.Stream(GlobalPositionInt.MavlinkId, 10);
        ground.TakeOff(60);
        ground.Run(240);
        double height = -ground.Truth.Pose.Position.Down;
        double reported = ground.Last<GlobalPositionInt>().RelativeAlt / 1000.0;
        Assert.True(Math.Abs(height - reported) > 6, $"{height} m, {reported} m reported");
        double gnss = (ground.Last<GpsRawInt>().Alt - ground.Last<GlobalPositionInt>().Alt) / 1000.0;
        Assert.InRange(reported + gnss - height, -4, 4);
    }

    [Fact]
    public void Gps_Glitch_SetsTheFlagAndFliesOn()
    {
        using Ground ground = Fly([Fault(ScriptedFaultKind.GpsGlitch, 40, seconds: 5)]);
        ground.Stream(EkfStatusReport.MavlinkId, 10);
        ground.Stream(GpsRawInt.MavlinkId, 10);
        ground.Stream(GlobalPositionInt.MavlinkId, 10);
        RunTo(ground, FaultAt + 2);
        int metres = (ground.Last<GpsRawInt>().Lat - ground.Last<GlobalPositionInt>().Lat) / 90;
        Assert.InRange(metres, 38, 42);
        Assert.Equal(EkfStatusFlags.GpsGlitching, ground.Last<EkfStatusReport>().Flags & EkfStatusFlags.GpsGlitching);
        Assert.Contains("GPS Glitch or Compass error", ground.Texts);
        RunTo(ground, FaultAt + 6);
        Assert.Contains("Glitch cleared", ground.Texts);
        Assert.Equal(CopterMode.Guided, (CopterMode)ground.Truth.CustomMode);
        Assert.Equal(MavState.Active, Copter(ground).SystemStatus);
    }

    [Theory]
    [InlineData(0, CopterMode.Guided)]
    [InlineData(1, CopterMode.Land)]
    [InlineData(2, CopterMode.AltHold)]
    public void Estimator_Bad_DoesWhatTheParameterSays(int action, CopterMode mode)
    {
        using Ground ground = Fly([Fault(ScriptedFaultKind.EkfFailsafe, seconds: 5)], ("FS_EKF_ACTION", action));
        RunTo(ground, FaultAt + 2);
        Assert.Equal(mode, (CopterMode)ground.Truth.CustomMode);
        Assert.Contains("EKF variance", ground.Texts);
        Assert.Equal(MavState.Critical, Copter(ground).SystemStatus);
        RunTo(ground, FaultAt + 8);
        Assert.Equal(MavState.Active, Copter(ground).SystemStatus);
    }

    [Fact]
    public void Land_WithoutAPosition_DriftsWithTheWind()
    {
        using var ground = new Ground(new SimulationOptions
        {
            WindMetresPerSecond = 5,
            WindFrom = Rabit.Geodesy.Angle.FromDegrees(270),
            Faults = [Fault(ScriptedFaultKind.GpsLost)],
        });
        ground.TakeOff(30);
        RunTo(ground, FaultAt + 20);
        Assert.True(ground.Truth.Pose.Position.East > 10, $"{ground.Truth.Pose.Position.East} m");
    }

    internal static Dictionary<string, double> Parameters(IEnumerable<(string Name, double Value)> parameters)
        => parameters.ToDictionary(p => p.Name, p => p.Value);

    internal static void RunTo(Ground ground, double time) => ground.Run(time - ground.Now.TotalSeconds);

    private static ScriptedFault Fault(
        ScriptedFaultKind kind, double value = 0, double seconds = 0, double at = FaultAt) => new()
        {
            Kind = kind,
            At = TimeSpan.FromSeconds(at),
            Duration = TimeSpan.FromSeconds(seconds),
            Value = value,
        };

    private static Ground Fly(ScriptedFault[] faults, params (string Name, double Value)[] parameters)
        => Fly(faults, 20, parameters);

    private static Ground Fly(ScriptedFault[] faults, double height, params (string Name, double Value)[] parameters)
    {
        var ground = new Ground(new SimulationOptions
        {
            WindMetresPerSecond = 0,
            HasGroundStation = true,
            Faults = faults,
            Parameters = Parameters(parameters),
        });
        ground.TakeOff(height);
        return ground;
    }

    private static double TimeUntil(Ground ground, CopterMode mode)
    {
        ground.RunUntil(() => ground.Truth.CustomMode == (uint)mode, 60, mode.ToString());
        double time = ground.Now.TotalSeconds;
        ground.Run(1.1);
        return time;
    }

    private static Heartbeat Copter(Ground ground)
        => ground.All<Heartbeat>().Last(h => h.Message.Autopilot == MavAutopilot.Ardupilotmega).Message;

    private static MavSysStatusSensor Unhealthy(Ground ground)
    {
        SysStatus status = ground.Last<SysStatus>();
        return status.OnboardControlSensorsEnabled & ~status.OnboardControlSensorsHealth;
    }
}
