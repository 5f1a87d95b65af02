using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Keeps the tracks of targets that move, which Sensor Fusion deletes when they are gone: they were found all the
/// same. For one thread.
/// </summary>
internal sealed class MovingTrackMemory
{
    private const int MaxPoints = 3600;

    private static readonly TimeSpan PointPeriod = TimeSpan.FromSeconds(1);

    private readonly SortedDictionary<int, TargetTrack> _tracks = [];
    private readonly SortedDictionary<int, List<TrackPoint>> _paths = [];

    /// <summary>Where those tracks were while they were seen: a copy.</summary>
    public TrackPath[] Paths => _paths.Select(p => new TrackPath(p.Key, p.Value.ToArray())).ToArray();

    /// <summary>The tracks as posted, and those of targets that moved and are gone, as they were posted last.</summary>
    public TrackList Take(TrackList posted)
    {
        foreach (TargetTrack track in posted.Tracks.Where(t => t.Motion != TargetMotion.Standing))
        {
            if (track.State is TrackState.Confirmed or TrackState.Lost)
                Keep(track);
            else
                Forget(track.Id);
        }

        TargetTrack[] gone = _tracks.Values.Where(t => posted.Tracks.All(p => p.Id != t.Id)).ToArray();
        return gone.Length == 0
            ? posted
            : new TrackList(posted.Time, posted.Tracks.Concat(gone).OrderBy(t => t.Id))
            {
                CameraClock = posted.CameraClock,
            };
    }

    private void Keep(TargetTrack track)
    {
        _tracks[track.Id] = track;
        if (!_paths.TryGetValue(track.Id, out List<TrackPoint>? points))
            _paths[track.Id] = points = [];
        bool isDue = points.Count == 0 || track.Time - points[points.Count - 1].Time >= PointPeriod;
        if (isDue && points.Count < MaxPoints && track.Time - track.LastSeen < PointPeriod)
            points.Add(new TrackPoint(track.Time, track.Position));
    }

    private void Forget(int trackId)
    {
        _tracks.Remove(trackId);
        _paths.Remove(trackId);
    }
}
