using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>How a group flew. Immutable.</summary>
internal sealed class GroupSummary
{
    public GroupSummary(GroupFlight flight, IReadOnlyList<FlightSummary> vehicles)
    {
        (Vehicles, Group) = (vehicles, flight.Group);
        Score = vehicles.Select(v => TargetScoring.Score(flight.Truth, v.Record.Tracks.Tracks))
            .OrderByDescending(s => s.Found).ThenBy(s => s.FalseTracks.Count).First();
        TruePose[] flown = flight.Group.Vehicles.SelectMany(v => v.World.Truth.Path.Where(p => p.Position.Down < 0))
            .ToArray();
        FlightTime = flown.Length == 0 ? TimeSpan.Zero : flown.Max(p => p.Time) - flown.Min(p => p.Time);
        Coverage = vehicles.Max(v => v.Record.Mission.Coverage);
        Validations = flight.Vehicles
            .SelectMany(v => v.Group.Validations.Where(t => t.Finder == v.Simulated.SystemId))
            .Where(t => t.State != ValidationState.Closed || t.Validator != 0).ToArray();
    }

    /// <summary>Each vehicle, in the order of the system ids.</summary>
    public IReadOnlyList<FlightSummary> Vehicles { get; }

    public SimulatedGroup Group { get; }

    /// <summary>The tracks of the vehicle that knows the most of all targets, compared with the truth.</summary>
    public MissionScore Score { get; }

    /// <summary>
    /// The targets that were to be validated by a second vehicle, as their finders know them; without those that were
    /// left to the task of another finder.
    /// </summary>
    public IReadOnlyList<ValidationTask> Validations { get; }

    /// <summary>From the first take-off to the last landing.</summary>
    public TimeSpan FlightTime { get; }

    /// <summary>How much of the area was seen by all together, 0 to 1.</summary>
    public double Coverage { get; }

    /// <summary>What of it failed, for people.</summary>
    public IEnumerable<string> Failures => Vehicles
        .SelectMany((v, i) => new MissionSummary(v.Record, score: null).Failures
            .Select(f => $"vehicle {FlightText.Number(i + 1)}: {f}"))
        .Concat(Score.Targets.Where(t => !t.IsFound).Select(t => $"target {t.Name} was not found"))
        .Concat(Score.FalseTracks.Select(t => $"a confirmed {t.Class} is no target"))
        .Concat(Group.TooNear.Select(GroupSummaryText.Of));

    public bool HasPassed => !Failures.Any();
}
