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
    private readonly SortedDictionary<int, TargetTrack> _tracks = [];

    /// <summary>The tracks as posted, and those of targets that moved and are gone, as they were posted last.</summary>
    public TrackList Take(TrackList posted)
    {
        foreach (TargetTrack track in posted.Tracks.Where(t => t.Motion != TargetMotion.Standing))
        {
            if (track.State is TrackState.Confirmed or TrackState.Lost)
                _tracks[track.Id] = track;
            else
                _tracks.Remove(track.Id);
        }

        TargetTrack[] gone = _tracks.Values.Where(t => posted.Tracks.All(p => p.Id != t.Id)).ToArray();
        return gone.Length == 0
            ? posted
            : new TrackList(posted.Time, posted.Tracks.Concat(gone).OrderBy(t => t.Id))
            {
                CameraClock = posted.CameraClock,
            };
    }
}
