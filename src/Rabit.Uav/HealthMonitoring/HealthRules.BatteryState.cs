using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// Beside the charge that is counted: the voltage of a cell and the autopilot's own announcement. Whichever is worse
// counts.
internal static partial class HealthRules
{
    private const double CellMarginVolts = 0.1;

    // Climbs and gusts draw the voltage down for some seconds.
    private static readonly TimeSpan VoltageDwell = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan AnnouncementDwell = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan AnnouncementClearDwell = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan UnknownDwell = TimeSpan.FromSeconds(10);

    public static readonly HealthRule<BatteryFacts>[] OfBatteryState =
    [
        new(HealthReasons.BatteryUnknown, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in BatteryFacts b, HealthOptions _) => b.IsConnected && !b.IsChargeKnown,
            Until = static (in BatteryFacts b, HealthOptions _) => b.IsChargeKnown,
            Dwell = static _ => UnknownDwell,
            Figure = static (in BatteryFacts b) => double.IsNaN(b.CellVolts) ? -1 : (long)Math.Round(b.CellVolts * 10),
            Text = static f => f.Figure < 0
                ? (FormattableString)$"battery unknown: neither its charge nor its voltage is reported"
                : $"the charge of the battery is unknown; it is judged by its voltage, {f.Figure / 10.0:0.0} V a cell",
            Condition = static _ => "the autopilot reports no remaining charge: -1, no battery monitor, or nothing for "
                + "10 s",
            End = static _ => "a charge is reported",
            Why = "a mission is not begun then unless it has `allowUnknownBattery`; in flight the voltage and the "
                + "autopilot's own failsafe are left",
        },
        new(HealthReasons.BatteryLow, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.BatteryLow,
            When = static (in BatteryFacts b, HealthOptions o) => b.IsConnected && b.CellVolts < o.BatteryLowCellVolts,
            Until = static (in BatteryFacts b, HealthOptions o)
                => b.CellVolts > o.BatteryLowCellVolts + CellMarginVolts,
            Dwell = static _ => VoltageDwell,
            ClearDwell = static _ => VoltageDwell,
            Figure = static (in BatteryFacts b) => VoltsFigure(b.CellVolts),
            Condition = static o => $"less than {Number(o.BatteryLowCellVolts)} V a cell, with at most 0.1 V added for "
                + "the load",
            End = static o => $"more than {Number(o.BatteryLowCellVolts + CellMarginVolts)} V for "
                + Seconds(VoltageDwell),
            Why = "some 10 % of a lithium polymer cell, whatever the count says: it counts from the stated capacity",
        },
        new(HealthReasons.BatteryLow, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.BatteryLow,
            When = static (in BatteryFacts b, HealthOptions _) => b.IsConnected
                && (b.ChargeState is MavBatteryChargeState.Low or MavBatteryChargeState.Unhealthy
                    || b.State.IsBatteryUnhealthy || b.Faults != 0),
            Dwell = static _ => AnnouncementDwell,
            ClearDwell = static _ => AnnouncementClearDwell,
            Figure = static (in BatteryFacts b) => AnnouncedFigure(b),
            Condition = static _ => "the autopilot announces it: charge state LOW or UNHEALTHY, a fault bit "
                + "(BATTERY_STATUS), or an unhealthy battery (SYS_STATUS)",
            End = static _ => $"nothing announced for {Seconds(AnnouncementClearDwell)}",
            Why = "its own limits are set for this battery; with BATT_FS_LOW_ACT 0 or COM_LOW_BAT_ACT 0 it only warns",
        },
        new(HealthReasons.BatteryCritical, HealthLevel.Critical, HealthAdvice.Land)
        {
            Supersedes = HealthReasons.BatteryLow | HealthReasons.BatteryCritical,
            When = static (in BatteryFacts b, HealthOptions o)
                => b.IsConnected && b.CellVolts < o.BatteryCriticalCellVolts,
            Until = static (in BatteryFacts b, HealthOptions o)
                => b.CellVolts > o.BatteryCriticalCellVolts + CellMarginVolts,
            Dwell = static _ => VoltageDwell,
            ClearDwell = static _ => VoltageDwell,
            Figure = static (in BatteryFacts b) => VoltsFigure(b.CellVolts),
            Condition = static o => $"less than {Number(o.BatteryCriticalCellVolts)} V a cell, with the load as above",
            End = static o => $"more than {Number(o.BatteryCriticalCellVolts + CellMarginVolts)} V for "
                + Seconds(VoltageDwell),
            Why = "below it the voltage of a lithium polymer cell collapses within a minute or two",
        },
        new(HealthReasons.BatteryCritical, HealthLevel.Critical, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.BatteryLow | HealthReasons.BatteryCritical,
            When = static (in BatteryFacts b, HealthOptions _) => b.IsEnergyKnown && IsAnnouncedCritical(b),
            Dwell = static _ => AnnouncementDwell,
            ClearDwell = static _ => AnnouncementClearDwell,
            Figure = static (in BatteryFacts b) => AnnouncedFigure(b),
            Condition = static _ => "the autopilot announces it: charge state CRITICAL, EMERGENCY or FAILED, and the "
                + "energy of the way home is known",
            End = static _ => $"another state for {Seconds(AnnouncementClearDwell)}",
            Why = "what reaches home does not land in a field",
        },
        new(HealthReasons.BatteryCritical, HealthLevel.Critical, HealthAdvice.Land)
        {
            Supersedes = HealthReasons.BatteryLow | HealthReasons.BatteryCritical,
            When = static (in BatteryFacts b, HealthOptions _) => !b.IsEnergyKnown && IsAnnouncedCritical(b),
            Dwell = static _ => AnnouncementDwell,
            ClearDwell = static _ => AnnouncementClearDwell,
            Figure = static (in BatteryFacts b) => AnnouncedFigure(b),
            Condition = static _ => "the autopilot announces it: charge state CRITICAL, EMERGENCY or FAILED, and the "
                + "energy of the way home is not known",
            End = static _ => $"another state for {Seconds(AnnouncementClearDwell)}",
            Why = "as for BatteryLow",
        },
    ];

    // One figure for what a battery is low by: per cent, then from 1000 hundredths of a volt, then what is announced.
    private const long VoltsBase = 1000;
    private const long AnnouncedBase = 10_000;

    private static long VoltsFigure(double volts)
        => VoltsBase + (double.IsNaN(volts) ? 0 : (long)Math.Floor((volts * 10) + 1e-9) * 10);

    private static long AnnouncedFigure(in BatteryFacts battery) => AnnouncedBase + (long)battery.ChargeState;

    private static bool IsAnnouncedCritical(in BatteryFacts battery) => battery.IsConnected
        && battery.ChargeState is MavBatteryChargeState.Critical or MavBatteryChargeState.Emergency
            or MavBatteryChargeState.Failed;

    private static FormattableString Describe(string how, long figure)
    {
        if (figure < VoltsBase)
            return $"battery {how} ({figure} %)";
        return figure < AnnouncedBase
            ? (FormattableString)$"battery {how} ({(figure - VoltsBase) / 100.0:0.0} V a cell)"
            : $"battery {how} (the autopilot reports it: {(MavBatteryChargeState)(figure - AnnouncedBase)})";
    }
}
