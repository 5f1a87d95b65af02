using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for the battery.</summary>
internal readonly struct BatteryFacts(
    in VehicleState state, double cellVolts, TimeSpan now, bool isEnergyKnown)
{
    // Autopilots report it at least every 2 s.
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(10);

    private static readonly TimeSpan MaxHeartbeatAge = TimeSpan.FromSeconds(5);

    // Cold cells give less, which the voltage shows; the firmware of a battery says nothing of this flight.
    private const MavBatteryFault Ignored
        = MavBatteryFault.UnderTemperature | MavBatteryFault.IncompatibleFirmware;

    public VehicleState State { get; } = state;

    /// <summary>Whether an autopilot is connected: only then silence says something.</summary>
    public bool IsConnected { get; }
        = state.SystemId != 0 && state.IsConnected && now - state.LastHeartbeatTime <= MaxHeartbeatAge;

    /// <summary>Whether the energy of the way home is known: then it decides when to return.</summary>
    public bool IsEnergyKnown { get; } = isEnergyKnown;

    public bool IsChargeKnown { get; }
        = now - state.BatteryTime <= MaxAge && !double.IsNaN(state.BatteryRemaining);

    /// <summary>Voltage of a cell as it would be without load, volts; NaN where it is not known.</summary>
    public double CellVolts { get; } = now - state.BatteryTime <= MaxAge ? cellVolts : double.NaN;

    public MavBatteryFault Faults { get; } = state.BatteryFaults & ~Ignored;

    public MavBatteryChargeState ChargeState => State.BatteryChargeState;
}
