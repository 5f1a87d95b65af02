using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The vehicle is judged by what its autopilot reports.
internal static partial class HealthRules
{
    private const double WindMarginMetresPerSecond = 1;

    // A figure above it is that of gusts.
    private const long GustFigure = 1000;

    private static readonly TimeSpan StatusClearDwell = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan WindClearDwell = TimeSpan.FromSeconds(5);

    public static readonly HealthRule<VehicleFacts>[] OfVehicle =
    [
        new(HealthReasons.NoAutopilot, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in VehicleFacts v, HealthOptions _) => v.State.SystemId == 0,
            Text = static _ => $"no autopilot detected yet",
            Condition = static _ => "none was detected yet",
            End = static _ => "its first heartbeat, for good",
            Why = "nothing can be judged without it",
        },
        new(HealthReasons.AutopilotLost, HealthLevel.Critical, HealthAdvice.ReturnToLaunch)
        {
            IsAdvisedAfterwards = true,
            When = static (in VehicleFacts v, HealthOptions o) => v.State.SystemId != 0 && !v.IsReplayOver
                && (!v.State.IsConnected || v.HeartbeatAge > o.AutopilotTimeout),
            Figure = static (in VehicleFacts v) => v.State.LastHeartbeatTime.Ticks,
            Text = static f => $"autopilot lost (last heartbeat at {Seconds(f.Figure)} s)",
            Condition = static o => "Autopilot Interface reports it, or its last heartbeat is older than "
                + $"{Seconds(o.AutopilotTimeout)}; not when all links are logs that have been played",
            End = static _ => "its next heartbeat",
            Why = "four to five missed heartbeats at 1 Hz; a link that was lost once may be lost for good",
        },
        new(HealthReasons.AutopilotCritical, HealthLevel.Critical, HealthAdvice.None)
        {
            When = static (in VehicleFacts v, HealthOptions _) => v.State.SystemStatus
                is MavState.Critical or MavState.Emergency or MavState.FlightTermination,
            ClearDwell = static _ => StatusClearDwell,
            Figure = static (in VehicleFacts v) => (long)v.State.SystemStatus,
            Text = static f => $"autopilot reports {(MavState)f.Figure}",
            Condition = static _ => "its system status is CRITICAL, EMERGENCY or FLIGHT_TERMINATION",
            End = static _ => "another status for 1 s",
            Why = "its own failsafes have priority; Mission Control returns by itself where they change no mode",
        },
        new(HealthReasons.CommandsUnanswered, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in VehicleFacts v, HealthOptions _) => v.State.IsConnected && v.Requests.Unanswered > 0
                && v.Requests.Accepted == 0 && v.Requests.Refused == 0,
            Figure = static (in VehicleFacts v) => v.Requests.Unanswered,
            Text = static f
                => $"the autopilot answers no command ({f.Figure} so far): it may sign its link, or receive nothing",
            Condition = static _ => "it is received, and none of our first commands, which ask for message rates, was "
                + "answered in time",
            End = static _ => "its first answer",
            Why = "a link that it signs, or of one way, shows in nothing else",
        },
        new(HealthReasons.WindHigh, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            When = static (in VehicleFacts v, HealthOptions o) => v.IsWindKnown
                && v.State.WindMetresPerSecond > o.WindHighMetresPerSecond,
            Until = static (in VehicleFacts v, HealthOptions o) => !v.IsWindKnown
                || v.State.WindMetresPerSecond < o.WindHighMetresPerSecond - WindMarginMetresPerSecond,
            Dwell = static o => o.WindHighAfter,
            ClearDwell = static _ => WindClearDwell,
            Figure = static (in VehicleFacts v) => (long)Math.Round(v.State.WindMetresPerSecond),
            Text = static f => f.Figure < GustFigure
                ? (FormattableString)$"wind too strong ({f.Figure} m/s)"
                : $"gusts too strong ({f.Figure - GustFigure} m/s)",
            Condition = static o => $"the autopilot's estimate is above {Number(o.WindHighMetresPerSecond)} m/s",
            End = static o => $"below {Number(o.WindHighMetresPerSecond - WindMarginMetresPerSecond)} m/s, or not "
                + $"reported, for {Seconds(WindClearDwell)}",
            Why = "the usual rating of small multirotors, well below the speed that they can fly; gusts are ignored",
        },
        new(HealthReasons.WindHigh, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.WindHigh,
            When = static (in VehicleFacts v, HealthOptions o)
                => v.GustMetresPerSecond > o.GustHighMetresPerSecond,
            Until = static (in VehicleFacts v, HealthOptions o)
                => !(v.GustMetresPerSecond >= o.GustHighMetresPerSecond - WindMarginMetresPerSecond),
            ClearDwell = static _ => WindClearDwell,
            Figure = static (in VehicleFacts v) => GustFigure + (long)Math.Round(v.GustMetresPerSecond),
            Condition = static o => "gusts, by two estimates of the last 10 s, are above "
                + $"{Number(o.GustHighMetresPerSecond)} m/s",
            End = static o => $"below {Number(o.GustHighMetresPerSecond - WindMarginMetresPerSecond)} m/s, or not "
                + $"reported, for {Seconds(WindClearDwell)}",
            Why = "1.4 times the limit of the wind, as gusts are; a small multirotor tilts to its limit there",
        },
    ];
}
