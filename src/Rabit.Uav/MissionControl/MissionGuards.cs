using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Reasons to return that Mission Control sees by itself: they hold also where Health Monitoring hangs. In flight,
/// while we command.
/// </summary>
internal static class MissionGuards
{
    // Health Monitoring posts at least once a second.
    private static readonly TimeSpan MaxHealthAge = TimeSpan.FromSeconds(5);

    // A hold at the operator's word ends PX4's failsafe for the loss of set-points, and with it the critical state.
    private static readonly TimeSpan MaxFailsafeEnd = TimeSpan.FromSeconds(5);

    /// <summary>Why the vehicle is to return; null where nothing is wrong.</summary>
    public static string? Find(MissionFlight flight)
    {
        if (flight.Authority.IsReturningByItself)
            return "Autopilot Interface returned by itself: no command was renewed";
        if (flight.HealthAge > MaxHealthAge)
            return $"no health report for {MissionNumbers.Seconds(flight.HealthAge)}";
        return flight.Now - flight.ControlGivenTime < MaxFailsafeEnd ? null : FindCritical(flight);
    }

    /// <summary>
    /// A failsafe of the autopilot that only warns: the mode is still ours, so that it does not bring the vehicle home.
    /// </summary>
    public static string? FindCritical(MissionFlight flight) => flight.Vehicle.SystemStatus switch
    {
        MavState.Critical => "the autopilot reports a critical state",
        MavState.Emergency => "the autopilot reports an emergency",
        MavState.FlightTermination => "the autopilot terminates the flight",
        _ => null,
    };
}
