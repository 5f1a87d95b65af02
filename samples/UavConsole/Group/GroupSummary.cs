using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>Takes together how a group flew.</summary>
internal static class GroupSummary
{
    /// <param name="flight">After its end.</param>
    /// <param name="vehicles">How each of them flew, in their order.</param>
    /// <param name="options">What was asked for.</param>
    /// <param name="reports">The files of their reports, beside the group's; none where none is wanted.</param>
    /// <param name="stoppedBy">What ended the run before the missions were over; null where they were.</param>
    public static GroupFlightSummary Of(
        GroupFlight flight, IReadOnlyList<FlightSummary> vehicles, ConsoleOptions options,
        IReadOnlyList<string> reports, string? stoppedBy)
    {
        MissionScore[] scores = vehicles.Select(v => TargetScoring.Score(flight.Truth, v.Record, null))
            .OrderByDescending(s => s.Found).ThenBy(s => s.FalseTracks.Count)
            .ThenByDescending(s => s.RejectedTracks.Count + s.Targets.Count(t => t.IsRejected)).ToArray();
        TruePose[] flown = flight.Group.Vehicles.SelectMany(v => v.World.Truth.Path.Where(p => p.Position.Down < 0))
            .ToArray();
        GroupVehicleSummary[] all = vehicles
            .Select((v, i) => Of(flight, flight.Vehicles[i], v, i < reports.Count ? reports[i] : string.Empty))
            .ToArray();
        var group = new GroupFlightSummary(all);
        MissionScore score = group.WithFalseTracksOf(scores[0], scores.Skip(1).ToArray());
        return new GroupFlightSummary(all)
        {
            Name = flight.Mission.Name,
            Source = $"simulated: {FlightText.Number((long)vehicles.Count)} vehicles, seed "
                + FlightText.Number(options.Seed),
            CommandLine = options.CommandLine,
            Seed = options.Seed,
            FlightTime = flown.Length == 0 ? TimeSpan.Zero : flown.Max(p => p.Time) - flown.Min(p => p.Time),
            Score = score,
            Failures =
            [
                .. stoppedBy is null ? [] : new[] { "the run was stopped before its end: " + stoppedBy },
                .. FailuresOf(flight, group, score),
            ],
        };
    }

    private static GroupVehicleSummary Of(
        GroupFlight flight, GroupVehicle vehicle, FlightSummary summary, string report)
    {
        RadioCounters radio = flight.Group.RadioOf(vehicle.Number);
        return new GroupVehicleSummary(vehicle.Simulated.SystemId, summary)
        {
            ClockOffset = vehicle.Simulated.SwitchedOnAt,
            ReportFile = report.Length == 0 ? string.Empty : Path.GetFileName(report),
            Radio = new RadioUse
            {
                Samples = vehicle.RadioSamples.ToArray(),
                FramesSent = radio.FramesSent,
                BytesSent = radio.BytesSent,
                FramesRefused = radio.FramesRefused,
                Delivered = radio.Delivered,
                Lost = radio.LostAtRandom + radio.LostInBursts + radio.LostByPartition,
                Duration = flight.Group.Now - vehicle.Simulated.SwitchedOnAt,
            },
        };
    }

    private static IEnumerable<string> FailuresOf(GroupFlight flight, GroupFlightSummary group, MissionScore score)
        => group.VehicleFailures
            .Concat(score.Targets.Where(t => !t.IsFound).Select(
                t => $"target {t.Name} {FlightText.Missed(t)}"))
            .Concat(score.FalseTracks.Select(t => $"a confirmed {t.Class} is no target"))
            .Concat(flight.Group.TooNear.Select(GroupSummaryText.Of));
}
