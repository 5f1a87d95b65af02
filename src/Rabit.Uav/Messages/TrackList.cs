using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;

namespace Rabit.Uav.Messages;

/// <summary>
/// All tracks of Sensor Fusion, by id. Tracks that were deleted are in no list any more: those that were never
/// confirmed, and those of targets that move and are gone. Immutable.
/// </summary>
public sealed class TrackList
{
    /// <summary>Makes one.</summary>
    /// <param name="time">The time of the newest report or observation that is in it.</param>
    /// <param name="tracks">The tracks, by id.</param>
    public TrackList(TimeSpan time, IEnumerable<TargetTrack> tracks)
    {
        Time = time;
        Tracks = (tracks ?? throw new ArgumentNullException(nameof(tracks))).ToImmutableArray();
        RejectedCount = Tracks.Count(t => t.State == TrackState.Rejected);
        ConfirmedCount = Tracks.Count(t => t.State == TrackState.Confirmed);
    }

    /// <summary>No tracks yet.</summary>
    public static TrackList None { get; } = new(TimeSpan.Zero, []);

    /// <summary>The time of the newest report or observation that is in it.</summary>
    public TimeSpan Time { get; }

    /// <summary>The tracks, by id.</summary>
    public ImmutableArray<TargetTrack> Tracks { get; }

    /// <summary>How far the times of the pictures are off, as the reports show it.</summary>
    public CameraClockEstimate CameraClock { get; init; }

    /// <summary>How many are confirmed.</summary>
    public int ConfirmedCount { get; }

    /// <summary>How many the operator rejected.</summary>
    public int RejectedCount { get; }

    /// <summary>Those that are confirmed.</summary>
    public IEnumerable<TargetTrack> Confirmed => Tracks.Where(t => t.State == TrackState.Confirmed);
}
