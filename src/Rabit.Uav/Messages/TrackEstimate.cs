using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// What another vehicle knows of a target that moves: the state of its track, whose errors may have anything in common
/// with ours. A plain value.
/// </summary>
public struct TrackEstimate
{
    /// <summary>MAVLink system id of the vehicle whose track it is.</summary>
    public byte SourceSystemId { get; set; }

    /// <summary>The number of the track there.</summary>
    public int TrackId { get; set; }

    /// <summary>
    /// The last picture in which that vehicle saw the target. With the source and <see cref="TrackId"/> it is the
    /// identity of the estimate: each counts once.
    /// </summary>
    public long PictureNumber { get; set; }

    /// <summary>When the target was there, by the clock of the run.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>Where it was, on the ground.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>Its velocity, metres per second; down is not read.</summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>The covariance of the position, m2.</summary>
    public HorizontalCovariance Covariance { get; set; }

    /// <summary>The covariance of the velocity, m2/s2.</summary>
    public HorizontalCovariance VelocityCovariance { get; set; }

    /// <summary>The covariance of the position north with the velocity north, m2/s.</summary>
    public double NorthWithNorthRate { get; set; }

    /// <summary>The covariance of the position north with the velocity east, m2/s.</summary>
    public double NorthWithEastRate { get; set; }

    /// <summary>The covariance of the position east with the velocity north, m2/s.</summary>
    public double EastWithNorthRate { get; set; }

    /// <summary>The covariance of the position east with the velocity east, m2/s.</summary>
    public double EastWithEastRate { get; set; }

    /// <summary>Its class, one that moves.</summary>
    public TargetClassName Class { get; set; }

    /// <summary>The id of the printed marker on it; null where none was read.</summary>
    public int? MarkerId { get; set; }
}
