using System;
using System.Collections.Generic;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// Which occluded track goes on as a track that began later (track segment association): the points of the later one
/// must be likelier as those of the earlier one's target than as those of a new one. Fixed room; for one thread.
/// </summary>
internal sealed class TrackStitcher(TrackerSettings settings)
{
    private readonly MotionFilter _same = new();
    private readonly MotionFilter _other = new();

    /// <summary>The track that goes on; null for none.</summary>
    public MovingTrack? Find(List<MovingTrack> tracks, MovingTrack later)
    {
        MovingTrack? best = null;
        double most = 0;
        foreach (MovingTrack earlier in tracks)
        {
            if (!earlier.IsOccluded || earlier.Class != later.Class
                || (earlier.Marker >= 0 && later.Marker >= 0 && earlier.Marker != later.Marker)
                || later.FirstSeen <= earlier.LastSeen)
                continue;
            double ratio = Math.Log(earlier.Existence / settings.BirthDensity) + Compare(earlier, later);
            if (ratio > most)
                (best, most) = (earlier, ratio);
        }

        return best;
    }

    // The logarithm of the likelihoods' ratio, per square metre of the first point.
    private double Compare(MovingTrack earlier, MovingTrack later)
    {
        _same.CopyFrom(earlier.Filter.Current);
        _other.CopyFrom(later.Filter.Before);
        double ratio = 0;
        foreach (TrackMeasurement measurement in later.Filter.Kept)
            ratio += LogTake(_same, measurement, earlier) - LogTake(_other, measurement, later);
        return ratio;
    }

    private static double LogTake(MotionFilter filter, in TrackMeasurement measurement, MovingTrack track)
        => Math.Log(Math.Max(1e-300, filter.Take(measurement, track.Filter.Slots)));
}
