using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The battery is judged by what the autopilot reports of it: a low battery means return to launch, a critical one to
// land, where the energy of the way home is not known. Where it is, see HealthRules.Energy.cs.
internal static partial class HealthRules
{
    // What is left in a battery rises by some per cent when its load falls; a figure at its limit would come and go.
    private const double BatteryMargin = 0.03;

    // Reported once a second: two reports.
    private static readonly TimeSpan ChargeDwell = TimeSpan.FromSeconds(2);

    public static readonly HealthRule<VehicleFacts>[] OfBattery =
    [
        new(HealthReasons.BatteryLow, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            When = static (in VehicleFacts v, HealthOptions o) => !v.IsEnergyKnown && IsLow(v, o),
            Until = static (in VehicleFacts v, HealthOptions o) => v.IsEnergyKnown || IsNotLow(v, o),
            Dwell = static _ => ChargeDwell,
            ClearDwell = static _ => ChargeDwell,
            Figure = static (in VehicleFacts v) => Percent(v.State.BatteryRemaining),
            Text = static f => Describe("low", f.Figure),
            Condition = static o
                => $"{PercentText(o.BatteryLowFraction)} or less remains, and the energy of the way home is not known; "
                    + "an unknown charge is not judged",
            End = static o
                => $"more than {PercentText(o.BatteryLowFraction + BatteryMargin)} for {Seconds(ChargeDwell)}",
            Why = "before the usual 20 % of ArduPilot's and PX4's own first warnings; one report may be wrong",
        },
        new(HealthReasons.BatteryCritical, HealthLevel.Critical, HealthAdvice.Land)
        {
            Supersedes = HealthReasons.BatteryLow,
            When = static (in VehicleFacts v, HealthOptions o) => !v.IsEnergyKnown && IsCritical(v, o),
            Until = static (in VehicleFacts v, HealthOptions o) => v.IsEnergyKnown || IsNotCritical(v, o),
            Dwell = static _ => ChargeDwell,
            ClearDwell = static _ => ChargeDwell,
            Figure = static (in VehicleFacts v) => Percent(v.State.BatteryRemaining),
            Text = static f => Describe("nearly empty", f.Figure),
            Condition = static o
                => $"{PercentText(o.BatteryCriticalFraction)} or less remains, and the energy of the way home is not known",
            End = static o
                => $"more than {PercentText(o.BatteryCriticalFraction + BatteryMargin)} for {Seconds(ChargeDwell)}",
            Why = "PX4 returns by itself near there (BAT_CRIT_THR is 7 %)",
        },
        new(HealthReasons.BatteryLow, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in VehicleFacts v, HealthOptions o) => v.IsEnergyKnown && IsLow(v, o),
            Until = static (in VehicleFacts v, HealthOptions o) => !v.IsEnergyKnown || IsNotLow(v, o),
            Dwell = static _ => ChargeDwell,
            ClearDwell = static _ => ChargeDwell,
            Figure = static (in VehicleFacts v) => Percent(v.State.BatteryRemaining),
            Condition = static o
                => $"{PercentText(o.BatteryLowFraction)} or less remains, and the energy of the way home is known",
            End = static o
                => $"more than {PercentText(o.BatteryLowFraction + BatteryMargin)} for {Seconds(ChargeDwell)}",
            Why = "the way home decides when to return: the operator should know all the same",
        },
        new(HealthReasons.BatteryCritical, HealthLevel.Critical, HealthAdvice.None)
        {
            Supersedes = HealthReasons.BatteryLow,
            When = static (in VehicleFacts v, HealthOptions o) => v.IsEnergyKnown && IsCritical(v, o),
            Until = static (in VehicleFacts v, HealthOptions o) => !v.IsEnergyKnown || IsNotCritical(v, o),
            Dwell = static _ => ChargeDwell,
            ClearDwell = static _ => ChargeDwell,
            Figure = static (in VehicleFacts v) => Percent(v.State.BatteryRemaining),
            Condition = static o
                => $"{PercentText(o.BatteryCriticalFraction)} or less remains, and the energy of the way home is known",
            End = static o
                => $"more than {PercentText(o.BatteryCriticalFraction + BatteryMargin)} for {Seconds(ChargeDwell)}",
            Why = "what reaches home does not land in a field",
        },
    ];

    private static bool IsLow(in VehicleFacts v, HealthOptions o)
        => v.State.BatteryTime is not null && v.State.BatteryRemaining <= o.BatteryLowFraction;

    private static bool IsNotLow(in VehicleFacts v, HealthOptions o)
        => v.State.BatteryRemaining > o.BatteryLowFraction + BatteryMargin;

    private static bool IsCritical(in VehicleFacts v, HealthOptions o)
        => v.State.BatteryTime is not null && v.State.BatteryRemaining <= o.BatteryCriticalFraction;

    private static bool IsNotCritical(in VehicleFacts v, HealthOptions o)
        => v.State.BatteryRemaining > o.BatteryCriticalFraction + BatteryMargin;
}
