using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Where the targets really are: of a simulated world, or of a file that was written by a survey (
/// <see cref="TruthFile"/>). Immutable.
/// </summary>
/// <param name="home">Where the vehicle starts; the altitude is not used.</param>
/// <param name="targets">All targets.</param>
/// <example>
/// <code>
/// var world = new SimulatedWorld(new SimulationOptions { Seed = 7 });
/// MissionScore score = TargetScoring.Score(TargetTruth.Of(world), recorder.Record.Tracks.Tracks);
/// Console.WriteLine($"{score.Found} of {score.Targets.Count} targets found, {score.RmseMetres:0.0} m RMS");
/// </code>
/// </example>
public sealed class TargetTruth(GeodeticPosition home, IReadOnlyList<TruthTarget> targets)
{
    /// <summary>Where the vehicle starts; the altitude is not used.</summary>
    public GeodeticPosition Home { get; } = home;

    /// <summary>All targets.</summary>
    public IReadOnlyList<TruthTarget> Targets { get; } = targets ?? throw new ArgumentNullException(nameof(targets));

    /// <summary>The truth of a simulated world.</summary>
    /// <param name="world">The world.</param>
    /// <param name="classes">
    /// The classes that count; null for all. Objects of other classes are not targets of the mission.
    /// </param>
    public static TargetTruth Of(SimulatedWorld world, IReadOnlyList<TargetClassName>? classes = null)
    {
        if (world is null)
            throw new ArgumentNullException(nameof(world));
        return new TargetTruth(world.Options.Home, [.. world.Targets
            .Where(t => !t.Class.IsNone && (classes is not { Count: > 0 } || classes.Contains(t.Class)))
            .Select(t => new TruthTarget(t.Name, t.Class, world.PositionOf(t.Position))
            {
                Way = t.Route is null ? null : time => world.PositionOf(t.PositionAt(time)),
            })]);
    }
}
