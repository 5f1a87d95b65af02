using System;
using System.Globalization;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// What the autopilot watches by itself: a low battery, which it always reports and by default does nothing about,
/// and a silent ground station, which it watches only if a parameter says so.
/// </summary>
internal sealed class Failsafes(ParameterStore parameters, FlightController controller, Action<MavSeverity, string> say)
{
    private double _lowSeconds;
    private bool _isBatteryLow;
    private bool _isGroundLost;
    private TimeSpan? _groundReceived;

    public bool IsBatteryLow => _isBatteryLow;

    public bool IsAnyOn => _isBatteryLow || _isGroundLost;

    public double ConsumedAmpereHours { get; set; }

    /// <summary>A heartbeat of a ground station came.</summary>
    public void ReceiveGroundHeartbeat(byte systemId)
    {
        if (systemId != (byte)parameters.GroundSystemId.Value)
            return;
        _groundReceived = controller.Situation.Time;
        if (_isGroundLost)
            say(MavSeverity.Warning, "GCS Failsafe Cleared");
        _isGroundLost = false;
    }

    public void Reset()
    {
        _lowSeconds = 0;
        _isBatteryLow = false;
        _isGroundLost = false;
    }

    public void Step()
    {
        if (!controller.IsArmed)
            return;
        CheckBattery();
        CheckGroundStation();
    }

    private void CheckBattery()
    {
        bool isLow = controller.BatteryVolts < parameters.BatteryLowVolts.Value;
        _lowSeconds = isLow ? _lowSeconds + controller.Situation.StepSeconds : 0;
        if (_isBatteryLow || _lowSeconds < parameters.BatteryLowTimer.Value || !isLow)
            return;

        _isBatteryLow = true;
        say(MavSeverity.Warning, string.Format(
            CultureInfo.InvariantCulture,
            "Battery 1 is low {0:0.00}V used {1:0} mAh",
            controller.BatteryVolts,
            ConsumedAmpereHours * 1000));
        Act((int)parameters.BatteryLowAction.Value);
    }

    private void CheckGroundStation()
    {
        if (_isGroundLost || parameters.GroundFailsafe.Value <= 0 || _groundReceived is not { } received)
            return;
        if ((controller.Situation.Time - received).TotalSeconds <= parameters.GroundFailsafeTimeout.Value)
            return;
        _isGroundLost = true;
        say(MavSeverity.Warning, "GCS Failsafe");
        Act(action: 2);
    }

    // 1: land, 2: return; whatever else ArduCopter has is not simulated.
    private void Act(int action)
    {
        if (controller.Situation.IsLanded)
            return;
        if (action == 1)
            controller.TrySetMode((uint)CopterMode.Land);
        else if (action == 2)
            controller.TrySetMode((uint)CopterMode.Rtl);
    }
}
