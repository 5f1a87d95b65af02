using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>What the simulated PX4 does by itself: links, battery, position, fence, sticks.</summary>
public class Px4FailsafeTests
{
    private readonly Px4Flyer _flyer = new();
    private readonly Px4Pilot _pilot = new();
    private double _nextGround = double.MaxValue;

    [Fact]
    public void GroundStation_Lost_HoldsThenReturnsAndGoesOnWhenItIsBack()
    {
        Start("NAV_DLL_ACT", 2, hasGround: true);
        _flyer.Set("COM_DL_LOSS_T", 5);
        _nextGround = double.MaxValue;
        Run(5);
        Assert.Equal(MavState.Active, Status);
        Run(2);
        Assert.Equal(MavState.Critical, Status);
        Assert.Equal(Px4Mode.Loiter, _flyer.Mode);
        Run(5);
        Assert.Equal(Px4Mode.Rtl, _flyer.Mode);
        _nextGround = _flyer.Time;
        Run(2);
        Assert.Equal(Px4Mode.Rtl, _flyer.Mode);
        Assert.Contains(Px4Event.GroundRegained, _flyer.Events);
        _flyer.SetMode(Px4Mode.Loiter);
        Run(0.2);
        Assert.Equal(MavState.Active, Status);
    }

    [Theory]
    [InlineData(0, Px4Mode.Rtl)]
    [InlineData(2, Px4Mode.Loiter)]   // COM_RCL_EXCEPT: hold
    public void ManualControl_Lost_ReturnsUnlessExcepted(int exceptions, object expected)
    {
        Start("COM_RCL_EXCEPT", exceptions, hasSticks: true);
        _pilot.Stop();
        Run(7);
        Assert.Equal((Px4Mode)expected, _flyer.Mode);
        Assert.Contains(Px4Event.ManualControlLost, _flyer.Events);
    }

    [Fact]
    public void ManualControl_NeverReceived_IsNoFailsafe()
    {
        Start("NAV_RCL_ACT", 2);
        Run(20);
        Assert.Equal(MavState.Active, Status);
    }

    [Theory]
    [InlineData(0, 0.06, Px4Mode.Loiter)]
    [InlineData(2, 0.06, Px4Mode.Land)]
    [InlineData(3, 0.06, Px4Mode.Rtl)]
    [InlineData(3, 0.04, Px4Mode.Land)]
    [InlineData(3, 0.12, Px4Mode.Loiter)]
    public void Battery_Falls_ActsByItsLevel(int action, double remaining, object expected)
    {
        Start("COM_LOW_BAT_ACT", action);
        _flyer.Vehicle.Pack.Set(remaining);
        Run(7);
        Assert.Equal((Px4Mode)expected, _flyer.Mode);
        Assert.Equal(MavState.Critical, Status);
        SysStatus status = _flyer.All<SysStatus>().Last().Message;
        Assert.Equal(0u, (uint)(status.OnboardControlSensorsHealth & MavSysStatusSensor.Battery));
    }

    [Fact]
    public void Gps_Lost_AltitudeControlSinksToTheGround()
    {
        Start("NAV_DLL_ACT", 0);
        _flyer.SetMode(Px4Mode.Posctl);
        _flyer.Set("SIM_GPS_USED", 0);
        Run(6);
        Assert.Equal(Px4Mode.Altctl, _flyer.Mode);
        _flyer.RunUntil(() => !_flyer.Vehicle.Autopilot.IsArmed, 30, "sunk and disarmed");
        Assert.Equal(MavResult.TemporarilyRejected, _flyer.Command(MavCmd.ComponentArmDisarm, 1));
    }

    [Theory]
    [InlineData(1, false)]
    [InlineData(3, true)]
    public void Sticks_MovedFastInOffboard_TakeOverWithBitOneOnly(int option, bool takesOver)
    {
        Start("COM_RC_OVERRIDE", option, hasSticks: true);
        _flyer.Set("COM_OF_LOSS_T", 1);
        var path = new Px4Path(_flyer);
        path.Start();
        Run(1, path.Step);
        _flyer.SetMode(Px4Mode.Offboard);
        Run(1, path.Step);
        _pilot.Move(0, 650, 500, 0);
        Run(0.3, path.Step);
        Assert.Equal(takesOver ? Px4Mode.Posctl : Px4Mode.Offboard, _flyer.Mode);
        Assert.Equal(takesOver, _flyer.Events.Contains(Px4Event.StickOverride));
    }

    [Fact]
    public void Fence_Uploaded_IsSentBackAndHeldAt()
    {
        Start("GF_ACTION", 2);
        double north = 20 / 111_100.0;
        double east = 20 / (111_100.0 * Math.Cos(_flyer.Home.Latitude.Radians));
        (double lat, double lon) = (_flyer.Home.Latitude.Degrees, _flyer.Home.Longitude.Degrees);
        _flyer.UploadFence(
        [
            (lat + north, lon + east), (lat + north, lon - east), (lat - north, lon - east),
            (lat - north, lon + east),
        ]);
        Assert.Equal(MavMissionResult.Accepted, _flyer.All<MissionAck>().Single().Message.Type);
        _flyer.Send(0, new MissionRequestList
        {
            TargetSystem = 1,
            TargetComponent = 1,
            MissionType = MavMissionType.Fence,
        }, 1, 191);
        Assert.Equal(4, _flyer.All<MissionCount>().Single().Message.Count);

        _flyer.Command(new CommandInt
        {
            TargetSystem = 1,
            TargetComponent = 1,
            Command = MavCmd.DoReposition,
            Param2 = 1,
            Param4 = float.NaN,
            X = (int)((lat * 1e7) + (60 / 0.01111)),
            Y = (int)(lon * 1e7),
            Z = (float)_flyer.Home.AltitudeAmslMetres + 12,
        });
        _flyer.RunUntil(() => Status == MavState.Critical, 20, "breached");
        Assert.InRange(_flyer.Pose.Position.North, 16, 24);
        Assert.Contains(Px4Event.FenceViolation, _flyer.Events);
    }

    [Fact]
    public void Simulation_FaultsOfTheScript_ReachPx4()
    {
        var options = new SimulationOptions
        {
            Autopilot = SimulatedAutopilot.Px4,
            HasGroundStation = true,
            WindMetresPerSecond = 0,
            Faults =
            [
                new ScriptedFault
                {
                    Kind = ScriptedFaultKind.PilotMode, At = TimeSpan.FromSeconds(30), Mode = "POSCTL",
                },
            ],
        };
        options.Parameters = new System.Collections.Generic.Dictionary<string, double> { ["NAV_DLL_ACT"] = 2 };
        SimulatedVehicle vehicle = new SimulatedWorld(options).CreateVehicle();
        for (int step = 1; step <= 3200; step++)
            vehicle.Step(TimeSpan.FromMilliseconds(10 * step), DateTimeOffset.FromUnixTimeSeconds(0));
        Assert.Equal(Px4Mode.Posctl, (Px4Mode)vehicle.Autopilot.CustomMode);
        options.Parameters = new System.Collections.Generic.Dictionary<string, double> { ["FS_GCS_ENABLE"] = 1 };
        Assert.Contains("FS_GCS_ENABLE", Assert.Throws<ArgumentException>(() => new SimulatedWorld(options)).Message);
    }

    private MavState Status => _flyer.AskForHeartbeat().SystemStatus;

    private void Start(string parameter, double value, bool hasGround = false, bool hasSticks = false)
    {
        _flyer.Step();
        if (hasGround)
            _nextGround = 0;
        if (hasSticks)
        {
            _pilot.Move(0, 0, 500, 0);
            _pilot.Start(_flyer.Time);
        }

        Run(1);
        _flyer.Set(parameter, value);
        _flyer.Set("MPC_TKO_SPEED", 3);
        _flyer.SetMode(Px4Mode.Loiter);
        Assert.Equal(MavResult.Accepted, _flyer.Command(MavCmd.ComponentArmDisarm, 1));
        _flyer.Command(MavCmd.NavTakeoff, p7: (float)(_flyer.Home.AltitudeAmslMetres + 12));
        Run(12);
        Assert.Equal(Px4Mode.Loiter, _flyer.Mode);
    }

    private void Run(double seconds, Action? each = null) => _flyer.Run(seconds, () =>
    {
        if (_flyer.Time >= _nextGround)
        {
            _nextGround = _flyer.Time + 1;
            _flyer.Send(1, new Heartbeat { Type = MavType.Gcs }, 255, 190);
        }

        _pilot.Step(_flyer);
        each?.Invoke();
    });
}
