using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>
/// When the phases of a flight are in which nothing goes wrong: the same seed flies the same up to the fault.
/// </summary>
internal sealed class NominalTimeline
{
    /// <summary>How long the vehicle holds before something goes wrong.</summary>
    public static readonly TimeSpan HoldBefore = TimeSpan.FromSeconds(6);

    /// <summary>How long after it the operator has it resume the search.</summary>
    public static readonly TimeSpan HoldTime = TimeSpan.FromSeconds(25);

    private static readonly ConcurrentDictionary<(SimulatedAutopilot Model, long Seed), Lazy<NominalTimeline>> Known
        = new();

    private readonly Dictionary<MissionPhase, (TimeSpan From, TimeSpan To)> _phases = [];

    private NominalTimeline(SimulatedAutopilot model, long seed)
    {
        using var flight = new MatrixFlight(null, model, seed, TimeSpan.Zero);
        MissionPhase before = MissionPhase.NoMission;
        var ended = new HashSet<MissionPhase>();
        while (flight.Mission.Phase is not (MissionPhase.Done or MissionPhase.Failed or MissionPhase.HandedOver))
        {
            flight.FlyUntil(flight.Flight.Reactor.Now + TimeSpan.FromMilliseconds(100));
            MissionPhase phase = flight.Mission.Phase;
            TimeSpan now = flight.Flight.Reactor.Now;
            if (phase != before)
                ended.Add(before);
            if (!ended.Contains(phase))
            {
                bool isKnown = _phases.TryGetValue(phase, out (TimeSpan From, TimeSpan To) known);
                _phases[phase] = (isKnown ? known.From : now, now);
            }

            before = phase;
            End = now;
        }

        flight.Flight.End();
        Result = flight.Mission;
    }

    public TimeSpan End { get; }

    public MissionStatus Result { get; }

    /// <summary>That of a seed; flown once.</summary>
    public static NominalTimeline Of(SimulatedAutopilot model, long seed)
        => Known.GetOrAdd(
            (model, seed), k => new Lazy<NominalTimeline>(() => new NominalTimeline(k.Model, k.Seed))).Value;

    /// <summary>When the operator holds for a cell of the hold.</summary>
    public TimeSpan HoldAt => Within(MissionPhase.Searching, 0.5);

    /// <summary>The middle of the first time in a phase; early in the return, which is short.</summary>
    public TimeSpan TimeOf(MissionPhase phase) => phase switch
    {
        MissionPhase.Holding => HoldAt + HoldBefore,
        MissionPhase.Returning => Within(phase, 0.2),
        _ => Within(phase, 0.5),
    };

    public override string ToString()
    {
        var parts = new List<string>();
        foreach (KeyValuePair<MissionPhase, (TimeSpan From, TimeSpan To)> phase in _phases)
        {
            parts.Add(FormattableString.Invariant(
                $"{phase.Key} {phase.Value.From.TotalSeconds:0.0}-{phase.Value.To.TotalSeconds:0.0}"));
        }

        return string.Join(", ", parts) + " " + Result.Result.Outcome + " " + Result.Text;
    }

    private TimeSpan Within(MissionPhase phase, double part)
    {
        if (!_phases.TryGetValue(phase, out (TimeSpan From, TimeSpan To) times))
            throw new InvalidOperationException($"the nominal flight has no phase {phase}: {this}");
        double seconds = times.From.TotalSeconds + (part * (times.To - times.From).TotalSeconds);
        return TimeSpan.FromSeconds(Math.Round(seconds, 1));
    }
}
