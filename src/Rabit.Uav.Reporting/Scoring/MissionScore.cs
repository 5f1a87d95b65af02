using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// The tracks of a mission compared with the truth. Immutable; made by whatever knows the truth, for example a
/// simulation.
/// </summary>
public sealed class MissionScore
{
    /// <summary>One for each real target, in the order of the truth.</summary>
    public IReadOnlyList<TargetScore> Targets { get; init; } = [];

    /// <summary>
    /// Confirmed tracks of no target: none of that class is near enough, or another track is nearer to it. One that was
    /// on one target and then on another is in <see cref="IdentitySwitches"/> instead.
    /// </summary>
    public IReadOnlyList<TargetTrack> FalseTracks { get; init; } = [];

    /// <summary>
    /// Tracks of no target that another vehicle rejected when it was asked to validate them: they are not in
    /// <see cref="FalseTracks"/>, since the group does not count them as targets. They stay confirmed tracks of the
    /// vehicle that found them.
    /// </summary>
    public IReadOnlyList<TargetTrack> RejectedTracks { get; init; } = [];

    /// <summary>How often a track of a target that moves went over to another target of its class.</summary>
    public int IdentitySwitches { get; init; }

    /// <summary>
    /// The true horizontal distance of the vehicle from home at the end, metres; null where only the autopilot's own
    /// position is known.
    /// </summary>
    public double? DistanceFromHomeMetres { get; init; }

    /// <summary>How many targets were found.</summary>
    public int Found => Targets.Count(t => t.IsFound);

    /// <summary>How many of the found targets are inside the 95 % ellipse of their track.</summary>
    public int InEllipse => Targets.Count(t => t.EllipseContainsTruth);

    /// <summary>Root mean square of the errors of the found targets, metres; NaN where none was found.</summary>
    public double RmseMetres
        => Found == 0
            ? double.NaN
            : Math.Sqrt(Targets.Where(t => t.IsFound).Average(t => t.ErrorMetres * t.ErrorMetres));
}
