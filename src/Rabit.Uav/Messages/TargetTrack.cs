using System;
using System.Collections.Immutable;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>Something on the ground that several reports agree on. Immutable.</summary>
public sealed class TargetTrack
{
    /// <summary>Number of the track, from 1; never used again.</summary>
    public int Id { get; init; }

    /// <summary>Tentative, confirmed or lost.</summary>
    public TrackState State { get; init; }

    /// <summary>What the operator said about it.</summary>
    public TargetDecision Decision { get; init; }

    /// <summary>Its class.</summary>
    public TargetClassName Class { get; init; }

    /// <summary>The id of the printed marker that it is; null for what is none.</summary>
    public int? MarkerId { get; init; }

    /// <summary>How targets of its class move.</summary>
    public TargetMotion Motion { get; init; }

    /// <summary>Where it is estimated to be at <see cref="Time"/>.</summary>
    public GeodeticPosition Position { get; init; }

    /// <summary>Velocity over ground, metres per second; down is 0. Zeros for a target that stands.</summary>
    public NedVector VelocityNed { get; init; }

    /// <summary>How uncertain the position is: the sum of the filter's and the systematic part.</summary>
    public HorizontalCovariance Covariance { get; init; }

    /// <summary>How uncertain the velocity is, m2/s2; zeros for a target that stands.</summary>
    public HorizontalCovariance VelocityCovariance { get; init; }

    /// <summary>The time of the estimate, by the clock of the run.</summary>
    public TimeSpan Time { get; init; }

    /// <summary>When it was first reported.</summary>
    public TimeSpan FirstSeen { get; init; }

    /// <summary>When it was last reported.</summary>
    public TimeSpan LastSeen { get; init; }

    /// <summary>How many reports it is made of.</summary>
    public int Reports { get; init; }

    /// <summary>How many observations showed its place and did not report it.</summary>
    public int Misses { get; init; }

    /// <summary>Side of a square of its area, metres: mean of the reports.</summary>
    public double SizeMetres { get; init; }

    /// <summary>
    /// Where it points on the ground, clockwise from true north: the mean of the reports, of a target that moves that
    /// of the last one. Null where no report says, or they differ too much to say anything.
    /// </summary>
    public TargetBearing? Bearing { get; init; }

    /// <summary>
    /// The picture of the report with the best score, of our own camera; -1 when another vehicle saw it.
    /// </summary>
    public long BestPictureNumber { get; init; } = -1;

    /// <summary>Which report of that picture.</summary>
    public int BestReportIndex { get; init; }

    /// <summary>The reports with the second and the third best score, as far as there are.</summary>
    public ImmutableArray<TrackPicture> OtherPictures { get; init; } = [];
}
