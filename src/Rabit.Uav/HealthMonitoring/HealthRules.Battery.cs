using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The battery is judged by what the autopilot reports of it: a low battery means return to launch, a critical one to
// land.
internal static partial class HealthRules
{
    // What is left in a battery rises by some per cent when its load falls; a figure at its limit would come and go.
    private const double BatteryMargin = 0.03;

    public static readonly HealthRule<VehicleFacts>[] OfBattery =
    [
        new(HealthReasons.BatteryLow, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            When = static (in VehicleFacts v, HealthOptions o) => v.State.BatteryTime is not null
                && v.State.BatteryRemaining <= o.BatteryLowFraction,
            Until = static (in VehicleFacts v, HealthOptions o)
                => v.State.BatteryRemaining > o.BatteryLowFraction + BatteryMargin,
            Figure = static (in VehicleFacts v) => Percent(v.State.BatteryRemaining),
            Text = static f => $"battery low ({f.Figure} %)",
            Condition = static o
                => $"{PercentText(o.BatteryLowFraction)} or less remains; an unknown charge is not judged",
            End = static o => $"more than {PercentText(o.BatteryLowFraction + BatteryMargin)}",
            Why = "before the usual 20 % of ArduPilot's and PX4's own first warnings; a count of charge needs no dwell",
        },
        new(HealthReasons.BatteryCritical, HealthLevel.Critical, HealthAdvice.Land)
        {
            Supersedes = HealthReasons.BatteryLow,
            When = static (in VehicleFacts v, HealthOptions o) => v.State.BatteryTime is not null
                && v.State.BatteryRemaining <= o.BatteryCriticalFraction,
            Until = static (in VehicleFacts v, HealthOptions o)
                => v.State.BatteryRemaining > o.BatteryCriticalFraction + BatteryMargin,
            Figure = static (in VehicleFacts v) => Percent(v.State.BatteryRemaining),
            Text = static f => $"battery nearly empty ({f.Figure} %)",
            Condition = static o => $"{PercentText(o.BatteryCriticalFraction)} or less remains",
            End = static o => $"more than {PercentText(o.BatteryCriticalFraction + BatteryMargin)}",
            Why = "PX4 returns by itself near there (BAT_CRIT_THR is 7 %)",
        },
    ];
}
