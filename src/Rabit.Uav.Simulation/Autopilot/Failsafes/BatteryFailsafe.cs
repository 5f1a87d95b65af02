using System;
using System.Globalization;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// BATT_LOW_VOLT and what belongs to it: a low or critical battery is reported while armed, and acted upon as
/// BATT_FS_LOW_ACT and BATT_FS_CRT_ACT say. It stays until the next start of the autopilot.
/// </summary>
internal sealed class BatteryFailsafe(
    ParameterStore parameters, FailsafeResponse response, Action<MavSeverity, string> say)
{
    // From the most severe action on: a later failsafe does not replace it by a less severe one.
    private static readonly FailsafeAction[] BySeverity =
        [FailsafeAction.Terminate, FailsafeAction.Land, FailsafeAction.Return, FailsafeAction.SmartReturnOrLand,
            FailsafeAction.SmartReturnOrReturn, FailsafeAction.None];

    private readonly BatteryWatch _watch = new();
    private int _severity = BySeverity.Length;

    public BatteryLevel Level => _watch.Level;

    public bool IsOn => Level > BatteryLevel.Ok;

    /// <summary>V, as measured.</summary>
    public double Volts { get; set; }

    /// <summary>Counted since the autopilot's start.</summary>
    public double ConsumedAmpereHours { get; set; }

    public double MilliampereHoursLeft => parameters.Battery.Capacity.Value - (ConsumedAmpereHours * 1000);

    /// <summary>One step of an armed vehicle.</summary>
    public void Step(double stepSeconds)
    {
        if (!_watch.Step(parameters.Battery, Volts, MilliampereHoursLeft, stepSeconds))
            return;
        bool isCritical = Level == BatteryLevel.Critical;
        say(MavSeverity.Warning, string.Format(
            CultureInfo.InvariantCulture,
            "Battery 1 is {0} {1:0.00}V used {2:0} mAh",
            isCritical ? "critical" : "low",
            Volts,
            ConsumedAmpereHours * 1000));
        BatteryParameters battery = parameters.Battery;
        var action = (FailsafeAction)(int)(isCritical ? battery.CriticalAction : battery.LowAction).Value;
        int severity = Array.IndexOf(BySeverity, action);
        severity = severity < 0 ? BySeverity.Length - 1 : severity;
        if (severity > _severity)
            return;
        _severity = severity;
        response.Respond(FailsafeCause.Battery, action);
    }
}
