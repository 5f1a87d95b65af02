using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>What became of one real target. Immutable.</summary>
internal sealed class TargetScore(TruthTarget target, TargetTrack? track, double errorNorthMetres, double errorEastMetres)
{
    public TruthTarget Target { get; } = target;

    /// <summary>The confirmed track that is it; null where it was not found.</summary>
    public TargetTrack? Track { get; } = track;

    /// <summary>How far north of the truth the track stands.</summary>
    public double ErrorNorthMetres { get; } = errorNorthMetres;

    /// <summary>How far east of the truth the track stands.</summary>
    public double ErrorEastMetres { get; } = errorEastMetres;

    public bool IsFound => Track is not null;

    /// <summary>Horizontal distance of the track from the truth.</summary>
    public double ErrorMetres => System.Math.Sqrt((ErrorNorthMetres * ErrorNorthMetres) + (ErrorEastMetres * ErrorEastMetres));

    /// <summary>Whether the ellipse that should hold the truth with 95 % does; false where it was not found.</summary>
    public bool EllipseHoldsTruth => Track is not null && Track.Covariance.Contains95(-ErrorNorthMetres, -ErrorEastMetres);
}
