using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>What speaks against arming, in ArduCopter's words and order.</summary>
internal sealed class ArmingChecks(FlightController controller, Action<MavSeverity, string> say)
{
    private static readonly TimeSpan CheckPeriod = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan ReportPeriod = TimeSpan.FromSeconds(30);

    private readonly List<string> _reasons = [];
    private TimeSpan _next = controller.StartTime + CheckPeriod;
    private TimeSpan _nextReport;

    /// <summary>Whether the last check, each second while disarmed, found nothing.</summary>
    public bool HasPassed { get; private set; }

    /// <summary>Whether it may arm; the reasons against it are sent as texts.</summary>
    public bool Check(bool isForced)
    {
        Find(isForced, checksMode: true);
        Report("Arm: ");
        return _reasons.Count == 0;
    }

    /// <summary>Checks each second while disarmed; says what it found again after half a minute.</summary>
    public void Step()
    {
        TimeSpan now = controller.Situation.Time;
        if (now < _next)
            return;
        _next = now + CheckPeriod;
        Find(isForced: false, checksMode: false);
        HasPassed = _reasons.Count == 0;
        if (HasPassed)
            _nextReport = now;
        if (HasPassed || now < _nextReport)
            return;
        _nextReport = now + ReportPeriod;
        Report("PreArm: ");
    }

    private void Report(string kind)
    {
        foreach (string reason in _reasons)
            say(MavSeverity.Critical, kind + reason);
    }

    private void Find(bool isForced, bool checksMode)
    {
        _reasons.Clear();
        ParameterStore parameters = controller.Situation.Parameters;
        if (CopterModes.NeedsPosition(controller.Mode) && !controller.HasPosition)
        {
            _reasons.Add("Need Position Estimate");
            return;
        }

        if (isForced)
            return;
        if (!parameters.ArmingCheck.Value.Equals(0))
            FindFailures(parameters.Battery, controller.Failsafes);
        if (_reasons.Count == 0 && checksMode && !CopterModes.IsArmable(controller.Mode))
            _reasons.Add(CopterModes.NameOf(controller.Mode) + " mode not armable");
    }

    private void FindFailures(BatteryParameters limits, Failsafes failsafes)
    {
        BatteryFailsafe battery = failsafes.Battery;
        if (battery.Volts < limits.ArmVolts.Value)
            _reasons.Add("Battery 1 below minimum arming voltage");
        else if (BatteryWatch.IsBelow(battery.Volts, limits.LowVolts))
            _reasons.Add("Battery 1 low voltage failsafe");
        else if (BatteryWatch.IsBelow(battery.MilliampereHoursLeft, limits.LowCharge))
            _reasons.Add("Battery 1 low capacity failsafe");
        if (battery.IsOn)
            _reasons.Add("Battery failsafe");
        if (failsafes.Radio.IsOn)
            _reasons.Add("Radio failsafe on");
        if (failsafes.GroundStation.IsOn)
            _reasons.Add("GCS failsafe on");
        if (failsafes.Fence.FindReasonNotToArm() is { } reason)
            _reasons.Add(reason);
    }
}
