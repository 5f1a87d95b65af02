using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>
/// This computer dies in flight: nothing comes from it any more, for good. What then brings the vehicle home is the
/// autopilot's own failsafe, by aircraft and by the way in which the ground station is connected.
/// </summary>
public sealed class DeadComputerTests
{
    private const double DiesAt = 60;

    // It is lost with the computer: FS_GCS_ENABLE 1 acts FS_GCS_TIMEOUT, 5 s, after its last heartbeat.
    [Fact]
    public void Ardupilot_GroundStationThroughThisComputer_ReturnsAfterFsGcsTimeout()
    {
        SimulationOptions options = World(SimulatedAutopilot.ArduPilot);
        using var flight = new Flight(options, hasGroundStation: true);
        flight.RunTo(DiesAt - 1);
        Assert.Equal("GUIDED", flight.Truth.Mode);

        flight.RunTo(DiesAt + 4);
        Assert.Equal("GUIDED", flight.Truth.Mode);
        flight.RunTo(DiesAt + 7);
        Assert.Equal("RTL", flight.Truth.Mode);
        flight.AssertLandsAtHome();
    }

    // Nothing is lost that the autopilot watches: it hovers in GUIDED, here for 3 min, until BATT_FS_LOW_ACT 2 acts.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Ardupilot_GroundStationOnItsOwnRadioOrNone_HoversUntilTheBatteryFailsafe(bool hasGroundStation)
    {
        SimulationOptions options = World(SimulatedAutopilot.ArduPilot, new ScriptedFault
        {
            Kind = ScriptedFaultKind.BatteryVolts,
            At = TimeSpan.FromSeconds(DiesAt + 180),
            Value = 9.5,
        });
        options.HasGroundStation = hasGroundStation;
        using var flight = new Flight(options, hasGroundStation: false);
        flight.RunTo(DiesAt + 30);
        TruePose hovers = flight.Truth.Pose;

        flight.RunTo(DiesAt + 179);
        Assert.Equal("GUIDED", flight.Truth.Mode);
        Assert.True(flight.Truth.IsAirborne);
        Assert.InRange((flight.Truth.Pose.Position - hovers.Position).Length, 0, 3);
        flight.RunTo(DiesAt + 180 + 15);
        Assert.Equal("RTL", flight.Truth.Mode);
        flight.AssertLandsAtHome();
    }

    // COM_OF_LOSS_T after the last set-point, however the ground station is connected.
    [Theory]
    [InlineData(3, false, "AUTO.RTL")]
    [InlineData(3, true, "AUTO.RTL")]
    [InlineData(5, false, "AUTO.LOITER")]
    public void Px4_NoSetPointsForComOfLossT_DoesWhatComOblRcActSays(int action, bool hasGroundStation, string mode)
    {
        SimulationOptions options = World(SimulatedAutopilot.Px4);
        options.Parameters = new Dictionary<string, double>
        {
            ["COM_OF_LOSS_T"] = 1,
            ["COM_OBL_RC_ACT"] = action,
        };
        using var flight = new Flight(options, hasGroundStation);
        flight.RunTo(DiesAt - 1);
        Assert.Equal("OFFBOARD", flight.Truth.Mode);

        flight.RunTo(DiesAt + 3);
        Assert.Equal(mode, flight.Truth.Mode);
        if (action == 3)
            flight.AssertLandsAtHome();
        else
            flight.AssertHolds();
    }

    // COM_OBL_RC_ACT 0 is POSCTL: without a pilot's sticks it holds, here for 3 min, until COM_LOW_BAT_ACT 3 acts.
    // The checklist refuses it; here the operator overrides that.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Px4_ComOblRcActIsPositionAndNoPilot_HoldsUntilTheBatteryFailsafe(bool hasGroundStation)
    {
        SimulationOptions options = World(SimulatedAutopilot.Px4, new ScriptedFault
        {
            Kind = ScriptedFaultKind.BatteryTo,
            At = TimeSpan.FromSeconds(DiesAt + 180),
            Value = 0.069,
        });
        options.Parameters = new Dictionary<string, double>
        {
            ["COM_OF_LOSS_T"] = 1,
            ["COM_OBL_RC_ACT"] = 0,
            ["COM_LOW_BAT_ACT"] = 3,
        };
        using var flight = new Flight(options, hasGroundStation, "COM_OBL_RC_ACT");
        flight.RunTo(DiesAt + 30);
        Assert.Equal("POSCTL", flight.Truth.Mode);
        TruePose holds = flight.Truth.Pose;

        flight.RunTo(DiesAt + 179);
        Assert.Equal("POSCTL", flight.Truth.Mode);
        Assert.True(flight.Truth.IsAirborne);
        Assert.InRange((flight.Truth.Pose.Position - holds.Position).Length, 0, 3);
        flight.RunTo(DiesAt + 180 + 15);
        Assert.Equal("AUTO.RTL", flight.Truth.Mode);
        flight.AssertLandsAtHome();
    }

    private static SimulationOptions World(SimulatedAutopilot autopilot, params ScriptedFault[] faults) => new()
    {
        Seed = 5,
        Autopilot = autopilot,
        TargetCount = 0,
        DistractorCount = 0,
        Faults =
        [
            new ScriptedFault
            {
                Kind = ScriptedFaultKind.LinkSilent,
                At = TimeSpan.FromSeconds(DiesAt),
                Duration = TimeSpan.FromHours(10),
            },
            .. faults,
        ],
    };

    /// <summary>A search without pictures, which dies in its first lane.</summary>
    private sealed class Flight : IDisposable
    {
        private readonly SimulatedWorld _world;
        private readonly UavSystem _uav;
        private readonly RabitReactor _reactor;

        public Flight(SimulationOptions options, bool hasGroundStation, params string[] overrides)
        {
            var vehicle = new MemoryLinkPair("vehicle");
            var station = new MemoryLinkPair("ground station");
            var uavOptions = new UavOptions
            {
                OpenLinks = hasGroundStation ? [vehicle.A, station.A] : [vehicle.A],
                Mission = SearchFlight.SmallPlan(),
                MayCommand = true,
                Time = new VirtualTime(options.Seed),
            };
            uavOptions.MissionControl.RequiresCamera = false;
            uavOptions.Preflight.Overrides = overrides;
            options.TakePlacesFrom(uavOptions.Mission);
            _world = new SimulatedWorld(options);
            _uav = UavSystem.Open(uavOptions);
            _reactor = _uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });
            _reactor.Add(_world.CreateVehicle(vehicle.B));
            if (hasGroundStation)
                _reactor.Add(new GroundStation(station.B));
            _reactor.Start();
        }

        public SimulatedTruth Truth => _world.Truth;

        public void RunTo(double seconds) => _reactor.RunFor(TimeSpan.FromSeconds(seconds) - _reactor.Now);

        public void AssertLandsAtHome()
        {
            for (int i = 0; i < 180 && Truth.IsArmed; i++)
                _reactor.RunFor(TimeSpan.FromSeconds(1));
            Assert.True(Truth is { IsArmed: false, HasFlown: true, HasCrashed: false });
            NedVector off = Truth.Pose.Position - NedPosition.Origin;
            Assert.InRange(off.HorizontalLength, 0, 3);
        }

        public void AssertHolds()
        {
            TruePose from = Truth.Pose;
            _reactor.RunFor(TimeSpan.FromSeconds(60));
            Assert.True(Truth is { IsArmed: true, IsAirborne: true });
            Assert.InRange((Truth.Pose.Position - from.Position).Length, 0, 20);
        }

        public void Dispose()
        {
            _reactor.Stop("the test is over");
            _reactor.Finish();
            _uav.Dispose();
        }
    }

    /// <summary>Sends its heartbeat to the computer, which forwards it to the vehicle.</summary>
    private sealed class GroundStation : RabitManager
    {
        private readonly IByteLink _link;
        private byte _sequence;

        public GroundStation(IByteLink link)
            : base("ground station")
        {
            _link = link;
            WakeUpDelay = TimeSpan.FromSeconds(1);
        }

        protected override void ExecuteUnitOfWork()
        {
            var heartbeat = new Heartbeat
            {
                Type = MavType.Gcs,
                Autopilot = MavAutopilot.Invalid,
                MavlinkVersion = 3,
            };
            var bytes = new byte[MavlinkFrame.MaxWireLength];
            int length = MavlinkFrame.Create(heartbeat, 255, 190, _sequence++).WriteTo(bytes);
            _link.Write(bytes, 0, length);
        }
    }
}
