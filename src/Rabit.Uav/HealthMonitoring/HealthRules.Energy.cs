using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The energy is judged by Mission Control's estimate: what is left against what the way home takes.
internal static partial class HealthRules
{
    private static readonly TimeSpan EnergyDwell = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan OutOfReachDwell = TimeSpan.FromSeconds(3);

    public static readonly HealthRule<VehicleFacts>[] OfEnergy =
    [
        new(HealthReasons.EnergyLow, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            When = static (in VehicleFacts v, HealthOptions _) => v.IsEnergyKnown && v.Energy.MustReturn,
            Dwell = static _ => EnergyDwell,
            ClearDwell = static _ => EnergyDwell,
            Figure = static (in VehicleFacts v) => Percent(v.Energy.ChargeLeft),
            Text = static f => $"the battery is needed for the way home ({f.Figure} % truly left)",
            Condition = static _ => "what is truly left is no more than the way home in this wind takes, the landing "
                + "and the reserve of the mission (10 %), with the uncertainty of both, for " + Seconds(EnergyDwell),
            End = static _ => "more is left for " + Seconds(EnergyDwell),
            Why = "a fixed level is too late far from home and against the wind, and too early near it; the estimates "
                + "are means already",
        },
        new(HealthReasons.HomeOutOfReach, HealthLevel.Critical, HealthAdvice.Land)
        {
            Supersedes = HealthReasons.EnergyLow,
            When = static (in VehicleFacts v, HealthOptions _) => v.IsEnergyKnown && v.Energy.IsHomeOutOfReach,
            Dwell = static _ => OutOfReachDwell,
            ClearDwell = static _ => OutOfReachDwell,
            Figure = static (in VehicleFacts v) => Percent(v.Energy.ChargeLeft),
            Text = static f => $"home is out of reach ({f.Figure} % truly left)",
            Condition = static _ => "what is truly left does not reach home, also where it is two standard deviations "
                + "more, and is just enough to land, for " + Seconds(OutOfReachDwell),
            End = static _ => "home is within reach for " + Seconds(OutOfReachDwell),
            Why = "until then it flies towards home: a landing under control in a field is better than a fall",
        },
    ];
}
