using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// PX4's health checks, ten times a second: what is no longer received, or low, now. It reports changes by events; what
/// is done about them is decided elsewhere.
/// </summary>
internal sealed class Px4Checks(
    Px4Situation situation, Px4Links links, Px4Events events, Px4Fence fence)
{
    private const double Load = 8;   // per cent; recorded: 4 to 10
    private static readonly TimeSpan Period = TimeSpan.FromMilliseconds(100);

    private TimeSpan _next;
    private TimeSpan _setPointReceived = TimeSpan.MinValue;
    private bool _isLoadTooHigh;
    private TimeSpan _manualLostAt;

    public bool IsOffboardStreamLost { get; private set; } = true;

    public bool IsManualControlLost { get; private set; }

    public bool IsGroundStationLost { get; private set; }

    public bool IsFenceBreached { get; private set; }

    /// <summary>Where it flies back to in the hold of the fence; null where it has not been breached.</summary>
    public NedVector? InsideFence { get; private set; }

    public MavBatteryChargeState Charge { get; private set; } = MavBatteryChargeState.Ok;

    /// <summary>A set-point that can be flown was received.</summary>
    public void ReceiveSetPoint() => _setPointReceived = situation.Time;

    /// <summary>Checks where a check is due; true where it did.</summary>
    public bool Step(bool isArmed, double batteryRemaining)
    {
        if (situation.Time < _next)
            return false;
        _next = situation.Time + Period;
        Px4Parameters parameters = situation.Parameters;
        IsOffboardStreamLost = _setPointReceived == TimeSpan.MinValue
            || (situation.Time - _setPointReceived).ExactSeconds > parameters.OffboardLossTime.Value;
        CheckLoad();
        CheckManualControl();
        CheckGroundStation();
        CheckBattery(batteryRemaining);
        CheckFence(isArmed);
        return true;
    }

    /// <summary>Whether arming is refused whatever the mode; the events before say why, the answer does not.</summary>
    public bool PreventsArming
        => _isLoadTooHigh || !situation.HasPosition
            || Charge is MavBatteryChargeState.Critical or MavBatteryChargeState.Emergency
            || (situation.Parameters.GroundStationLossAction.Whole > 0
                && links.IsGroundStationLost(GroundStationLossSeconds));

    private double GroundStationLossSeconds => situation.Parameters.GroundStationLossTime.Value;

    private void CheckLoad()
    {
        double limit = situation.Parameters.MaxLoad.Value;
        bool isTooHigh = limit > 0 && limit < Load;
        if (isTooHigh && !_isLoadTooHigh)
            events.Send(
                Px4Event.LoadTooHigh, 0x33, default(Px4EventArguments).UInt32(uint.MaxValue).Byte(0x14).Float(Load),
                FormattableString.Invariant($"Preflight Fail: CPU load too high: {Load:0.0}%"));
        _isLoadTooHigh = isTooHigh;
    }

    private void CheckManualControl()
    {
        Px4Sticks sticks = situation.Sticks;
        sticks.Update(situation.Time, situation.Parameters.ManualLossTime.Value);
        bool isLost = sticks.WereReceived && !sticks.AreValid;
        if (isLost && !IsManualControlLost)
        {
            _manualLostAt = sticks.Received;
            events.Send(Px4Event.ManualControlLost, 0x62);
        }
        else if (!isLost && IsManualControlLost)
        {
            events.Send(
                Px4Event.ManualControlRegained, 0x66,
                default(Px4EventArguments).Float((situation.Time - _manualLostAt).ExactSeconds));
        }

        IsManualControlLost = isLost;
    }

    private void CheckGroundStation()
    {
        bool isLost = links.HadGroundStation && links.IsGroundStationLost(GroundStationLossSeconds);
        if (isLost && !IsGroundStationLost)
        {
            byte levels = situation.Parameters.GroundStationLossAction.Whole > 0 ? (byte)0x33 : (byte)0x66;
            events.Send(Px4Event.GroundStationLost, 0x64);
            events.Send(
                Px4Event.NoGroundConnection, levels, default(Px4EventArguments).UInt32(uint.MaxValue).Byte(0x0C));
        }
        else if (!isLost && IsGroundStationLost)
        {
            events.Send(Px4Event.GroundRegained, 0x66, text: "GCS connection regained");
        }

        IsGroundStationLost = isLost;
    }

    private void CheckBattery(double remaining)
    {
        Px4Parameters parameters = situation.Parameters;
        MavBatteryChargeState charge = remaining < parameters.EmergencyBattery.Value ? MavBatteryChargeState.Emergency
            : remaining < parameters.CriticalBattery.Value ? MavBatteryChargeState.Critical
            : remaining < parameters.LowBattery.Value ? MavBatteryChargeState.Low : MavBatteryChargeState.Ok;
        if (charge == Charge)
            return;
        if (charge != MavBatteryChargeState.Ok && charge != MavBatteryChargeState.Emergency)
        {
            byte levels = charge == MavBatteryChargeState.Low ? (byte)0x44 : (byte)0x22;
            Px4EventArguments arguments = default(Px4EventArguments).UInt32(uint.MaxValue).Byte(0x0B);
            events.Send(Px4Event.BatteryIsLow, levels, arguments);
            events.Say(MavSeverity.Emergency, "Preflight Fail: low battery");
        }
        else if (charge == MavBatteryChargeState.Emergency && !situation.IsLanded)
        {
            // It tries to switch itself off, and cannot while armed.
            Px4EventArguments states = default(Px4EventArguments).Byte(2).Byte(4);
            events.Send(Px4Event.TransitionDenied, 0x22, states, "Transition denied: Armed to Shutdown");
            events.Send(Px4Event.ShutdownFailed, 0x30, text: "System does not support shutdown");
        }

        Charge = charge;
    }

    private void CheckFence(bool isArmed)
    {
        bool isBreached = isArmed && situation.HasPosition && fence.IsBreached(situation);
        if (isBreached && !IsFenceBreached)
        {
            Px4EventArguments arguments = default(Px4EventArguments).UInt32(uint.MaxValue).Byte(0x14).Byte(2);
            events.Send(Px4Event.FenceViolation, 0x33, arguments);
            events.Say(MavSeverity.Critical, "Preflight Fail: Geofence violation");

            // Recorded: it stops some metres outside and flies back, until it is about 5 m inside.
            const double Inside = 5;
            double speed = Math.Max(0.1, situation.Velocity.HorizontalLength());
            InsideFence = situation.Position.Minus(
                new NedVector(situation.Velocity.North, situation.Velocity.East, 0).Times(Inside / speed));
        }
        else if (!isBreached && !isArmed)
        {
            InsideFence = null;
        }

        IsFenceBreached = isBreached;
    }
}
