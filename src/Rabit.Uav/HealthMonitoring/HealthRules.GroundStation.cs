using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The ground station is judged by its heartbeats on all links; what its loss leads to the mission says.
internal static partial class HealthRules
{
    private static readonly TimeSpan GroundStationClearDwell = TimeSpan.FromSeconds(3);

    public static readonly HealthRule<GroundStationFacts>[] OfGroundStation =
    [
        OfGroundStationLoss(
            HealthAdvice.None, static o => o.GroundStationLostAfter,
            static o => "one was received, and none of its heartbeats (MAV_TYPE_GCS) came over any link for "
                + Seconds(o.GroundStationLostAfter),
            "five missed at 1 Hz; a link that fades for a moment comes back",
            static f => $"ground station lost (last heartbeat at {Seconds(f.Figure)} s)"),
        OfGroundStationLoss(
            HealthAdvice.Hold, static o => o.GroundStationLoss.HoldAfter,
            static o => $"the same for {Seconds(o.GroundStationLoss.HoldAfter ?? TimeSpan.Zero)}, unless the mission "
                + "says otherwise (`groundStationLost`)",
            "turning a little may bring the link back; after the 5 s of ArduPilot's own failsafe, which has priority"),
        OfGroundStationLoss(
            HealthAdvice.ReturnToLaunch, static o => o.GroundStationLoss.ReturnAfter,
            static o => $"the same for {Seconds(o.GroundStationLoss.ReturnAfter ?? TimeSpan.Zero)}, unless the "
                + "mission says otherwise",
            "home is where the link was; who watches the flight has to be able to end it"),
    ];

    private static HealthRule<GroundStationFacts> OfGroundStationLoss(
        HealthAdvice advice, Func<HealthOptions, TimeSpan?> after, Func<HealthOptions, string> condition, string why,
        HealthText.Words? text = null)
        => new(HealthReasons.GroundStationLost, HealthLevel.Warning, advice)
        {
            Supersedes = HealthReasons.GroundStationLost,
            When = (in GroundStationFacts g, HealthOptions o) => g.Silence >= (after(o) ?? TimeSpan.MaxValue),
            Until = static (in GroundStationFacts g, HealthOptions o) => g.Silence < o.GroundStationLostAfter,
            ClearDwell = static _ => GroundStationClearDwell,
            Figure = static (in GroundStationFacts g) => g.LastTime?.Ticks ?? 0,
            Text = text,
            Condition = condition,
            End = static _ => $"its heartbeats come for {Seconds(GroundStationClearDwell)}",
            Why = why,
        };
}
