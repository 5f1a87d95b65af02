using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>What the tracks are worth against the truth. Immutable.</summary>
internal sealed class MissionScore(IReadOnlyList<TargetScore> targets, IReadOnlyList<TargetTrack> falseTracks)
{
    /// <summary>One for each real target, in the order of the truth.</summary>
    public IReadOnlyList<TargetScore> Targets { get; } = targets;

    /// <summary>Confirmed tracks that are no target: there is none of that colour near enough, or another track is it already.</summary>
    public IReadOnlyList<TargetTrack> FalseTracks { get; } = falseTracks;

    public int Found => Targets.Count(t => t.IsFound);

    /// <summary>How many of the found ones stand in the ellipse that their track states.</summary>
    public int InEllipse => Targets.Count(t => t.EllipseHoldsTruth);

    /// <summary>Root mean square of the errors of those found, metres; NaN when none was.</summary>
    public double RmseMetres => Found == 0 ? double.NaN : Math.Sqrt(Targets.Where(t => t.IsFound).Average(t => t.ErrorMetres * t.ErrorMetres));
}
