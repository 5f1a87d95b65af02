using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// The rules of Health Monitoring in one place: a table for each kind of subject. A row has the reason, the level, the
/// advice in flight, the condition with its dwell, what ends the finding, the text for the operator, and why its
/// thresholds are as they are. Thresholds that can be set are in <see cref="HealthOptions"/>. The table of the
/// documentation is generated from it.
/// </summary>
internal static partial class HealthRules
{
    /// <summary>All rows, in the order of the table.</summary>
    public static IReadOnlyList<HealthRule> All =>
    [
        .. OfManagers, .. OfVehicle, .. OfPosition, .. OfBattery, .. OfBatteryState, .. OfEnergy, .. OfCamera,
        .. OfTargets, .. OfLinks, .. OfRecording, .. OfGroundStation, .. OfComputer,
    ];

    /// <summary>The words of a reason; null where it has no row.</summary>
    public static HealthText.Words? WordsOf(HealthReasons reason)
        => All.FirstOrDefault(r => r.Reason == reason && r.Text is not null)?.Text;

    /// <summary>
    /// Whether a manager works, as our heartbeat claims: it runs, did not fault lately and begins its units of work in
    /// time.
    /// </summary>
    public static bool IsAlive(in ManagerFacts manager, HealthOptions options)
    {
        if (!IsRunning(manager))
            return false;
        foreach (HealthRule<ManagerFacts> rule in OfManagers)
        {
            if (rule.When(manager, options))
                return false;
        }

        return true;
    }

    // Before its first unit of work a manager is "starting"; one that never begins it counts as stuck too.
    private static bool IsRunning(in ManagerFacts manager)
        => manager.State is ManagerState.Running or ManagerState.Starting;

    private static string Seconds(TimeSpan time)
        => time.ExactSeconds.ToString("0.#", CultureInfo.InvariantCulture) + " s";

    private static string Seconds(long ticks)
        => new TimeSpan(ticks).ExactSeconds.ToString("0.0", CultureInfo.InvariantCulture);

    // Rounded down; autopilots report whole per cent, and 0.29 * 100 is slightly less than 29.
    private static long Percent(double fraction) => (long)Math.Floor((fraction * 100) + 1e-9);

    private static string PercentText(double fraction)
        => Percent(fraction).ToString(CultureInfo.InvariantCulture) + " %";

    private static string Number(double value) => value.ToString("0.###", CultureInfo.InvariantCulture);
}
