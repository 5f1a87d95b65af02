using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>A real target, and the track that was made of it. Immutable.</summary>
public sealed class TargetScore
{
    /// <summary>The name of the target.</summary>
    public string Name { get; init; } = string.Empty;

    /// <summary>The class of the target.</summary>
    public TargetClassName Class { get; init; }

    /// <summary>The true position; the altitude is not used.</summary>
    public GeodeticPosition Position { get; init; }

    /// <summary>The confirmed track of this target; null where it was not found.</summary>
    public TargetTrack? Track { get; init; }

    /// <summary>Track less truth, to the north, metres; 0 where it was not found.</summary>
    public double ErrorNorthMetres { get; init; }

    /// <summary>Track less truth, to the east, metres; 0 where it was not found.</summary>
    public double ErrorEastMetres { get; init; }

    /// <summary>Whether there is a track.</summary>
    public bool IsFound => Track is not null;

    /// <summary>
    /// Whether it was not found because its track was rejected, by the operator or by another vehicle.
    /// </summary>
    public bool IsRejected { get; init; }

    /// <summary>
    /// Whether another vehicle rejected its track, which was asked to validate it, and not the operator.
    /// </summary>
    public bool IsRejectedByVehicle { get; init; }

    /// <summary>Horizontal distance of the track from the truth, metres; 0 where it was not found.</summary>
    public double ErrorMetres => Math.Sqrt((ErrorNorthMetres * ErrorNorthMetres) + (ErrorEastMetres * ErrorEastMetres));

    /// <summary>Whether the truth is inside the 95 % ellipse of the track; false where it was not found.</summary>
    public bool EllipseContainsTruth
        => Track is not null && Track.Covariance.Contains95(-ErrorNorthMetres, -ErrorEastMetres);

    /// <summary>For logs and tests.</summary>
    public override string ToString() => Track is null
        ? $"{Name}: not found"
        : FormattableString.Invariant(
            $"{Name}: {ErrorMetres:0.00} m, half axis {Track.Covariance.HalfMajorAxis95Metres:0.00} m, truth {(EllipseContainsTruth ? "inside" : "outside")}, {Track.Reports} reports");
}
