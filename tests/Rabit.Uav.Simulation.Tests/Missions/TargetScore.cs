using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>A target and what was made of it.</summary>
internal sealed class TargetScore(SimulatedTarget target, TargetTrack? track, NedVector error)
{
    public SimulatedTarget Target { get; } = target;

    public TargetTrack? Track { get; } = track;

    public double ErrorMetres { get; } = Math.Sqrt((error.North * error.North) + (error.East * error.East));

    public bool IsInEllipse { get; } = track is not null && track.Covariance.Contains95(error.North, error.East);

    public double HalfAxisMetres { get; } = track?.Covariance.HalfMajorAxis95Metres ?? double.NaN;

    public override string ToString() => Track is null
        ? $"{Target.Name}: not found"
        : FormattableString.Invariant($"{Target.Name}: {ErrorMetres:0.00} m, half axis {HalfAxisMetres:0.00} m, {(IsInEllipse ? "in" : "outside of")} it, {Track.Reports} reports");
}
