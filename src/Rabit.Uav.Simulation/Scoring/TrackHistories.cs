using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace Rabit.Uav.Simulation;

/// <summary>
/// On which true target each track of a class that moves was, point by point. By its end alone a track that went over
/// to another target cannot be distinguished from a second track of one target.
/// </summary>
internal sealed class TrackHistories
{
    private const int None = -1;

    // A target that turns is a few metres from its track for a moment; two targets that meet have a point in common.
    private const double MinOnTargets = 0.8;
    private const double MaxTogether = 0.2;

    // What is shorter is two targets that pass each other, not a track that went over.
    private const int MinRun = 3;

    private static readonly TimeSpan SameTime = TimeSpan.FromSeconds(1);

    private readonly Dictionary<int, (TimeSpan Time, int Target)[]> _histories;

    /// <param name="truth">The true targets.</param>
    /// <param name="tracks">Those that are scored.</param>
    /// <param name="paths">Where they were; of those without one nothing is said.</param>
    public TrackHistories(TargetTruth truth, IEnumerable<TargetTrack> tracks, IReadOnlyList<TrackPath> paths)
        => _histories = tracks
            .Join(paths, t => t.Id, p => p.TrackId, (track, path) => (Track: track, path.Points))
            .ToDictionary(
                t => t.Track.Id,
                t => t.Points.Select(p => (p.Time, NearestTarget(truth, t.Track.Class, p))).ToArray());

    /// <summary>How often a track went over to another target, all together.</summary>
    public int IdentitySwitches => _histories.Values.Sum(CountSwitches);

    /// <summary>
    /// Whether a track was on true targets while it was seen, each time on one that no other track was on then.
    /// </summary>
    public bool IsOfTargets(TargetTrack track)
    {
        if (!_histories.TryGetValue(track.Id, out (TimeSpan Time, int Target)[]? points) || points.Length < MinRun)
            return false;
        int on = points.Count(p => p.Target != None);
        int together = points.Count(p => p.Target != None && IsOnAnother(track.Id, p.Time, p.Target));
        return on >= MinOnTargets * points.Length && together <= MaxTogether * points.Length;
    }

    private bool IsOnAnother(int trackId, TimeSpan time, int target) => _histories.Any(
        h => h.Key != trackId && h.Value.Any(p => p.Target == target && (p.Time - time).Duration() <= SameTime));

    private static int CountSwitches((TimeSpan Time, int Target)[] points)
    {
        (int switches, int current, int candidate, int run) = (0, None, None, 0);
        foreach ((_, int target) in points.Where(p => p.Target != None))
        {
            (candidate, run) = target == candidate ? (candidate, run + 1) : (target, 1);
            if (run < MinRun || candidate == current)
                continue;
            switches += current == None ? 0 : 1;
            current = candidate;
        }

        return switches;
    }

    private static int NearestTarget(TargetTruth truth, TargetClassName name, TrackPoint point)
    {
        (int nearest, double least) = (None, TargetScoring.GateMetres);
        for (int i = 0; i < truth.Targets.Count; i++)
        {
            if (truth.Targets[i].Class != name)
                continue;
            double metres = TargetScoring.MetresBetween(truth.Targets[i].PositionAt(point.Time), point.Position);
            if (metres <= least)
                (nearest, least) = (i, metres);
        }

        return nearest;
    }
}
