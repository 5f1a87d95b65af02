using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Finds which tracks are the targets that a group follows: where a task says that its target was seen, there the track
/// was at that time. At the end both may be anywhere. For one thread.
/// </summary>
internal sealed class FollowedTracks
{
    // Two targets of one class that pass each other are nearer than that, but not for long.
    private const double MaxMetres = 15;
    private const double MinPart = 0.2;

    private static readonly TimeSpan MaxApart = TimeSpan.FromSeconds(3);

    private readonly Dictionary<FollowedTrack, int> _together = [];
    private readonly Dictionary<(byte, ushort, ushort), TimeSpan> _taken = [];

    public void Take(TrackList tracks, in GroupStatus group)
    {
        foreach (FollowTask task in group.Followings)
        {
            (byte, ushort, ushort) key = (task.Finder, task.Session, task.Number);
            if (_taken.TryGetValue(key, out TimeSpan time) && time == task.Time)
                continue;
            TargetTrack? nearest = tracks.Tracks
                .Where(t => t.Motion != TargetMotion.Standing && t.State != TrackState.Tentative
                    && t.Class == task.Class && t.MarkerId == task.MarkerId
                    && (t.Time - task.Time).Duration() < MaxApart)
                .Select(t => (Track: t, Metres: MetresBetween(task, t)))
                .Where(t => t.Metres < MaxMetres).OrderBy(t => t.Metres).Select(t => t.Track).FirstOrDefault();
            if (nearest is null)
                continue;
            _taken[key] = task.Time;
            var found = new FollowedTrack(task.Finder, task.Session, task.Number, nearest.Id);
            _together.TryGetValue(found, out int times);
            _together[found] = times + 1;
        }
    }

    /// <summary>Those that were there for a part of the time that is worth to be named.</summary>
    public FollowedTrack[] ToArray() => _together
        .GroupBy(t => (t.Key.Finder, t.Key.Session, t.Key.Number))
        .SelectMany(g => g.Where(t => t.Value >= MinPart * g.Max(o => o.Value)).Select(t => t.Key))
        .OrderBy(t => (t.Finder, t.Session, t.Number, t.TrackId)).ToArray();

    private static double MetresBetween(in FollowTask task, TargetTrack track)
    {
        NedPosition off = LocalNedFrame.IgnoringGeoid(task.Position).ToNed(track.Position);
        double seconds = (task.Time - track.Time).TotalSeconds;
        return NedPosition.Origin.HorizontalDistanceTo(off + (seconds * track.VelocityNed));
    }
}
