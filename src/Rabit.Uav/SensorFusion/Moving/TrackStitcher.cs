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

    // Sources of points that are only tried take no slot of the tracks.
    private readonly RegistrationSlots _slotsOfSame = new();
    private readonly RegistrationSlots _slotsOfOther = new();

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
        _slotsOfSame.CopyFrom(earlier.Filter.Slots);
        _slotsOfOther.CopyFrom(later.Filter.Slots);
        double ratio = 0;
        foreach (TrackMeasurement measurement in later.Filter.Kept)
            ratio += LogTake(_same, measurement, _slotsOfSame) - LogTake(_other, measurement, _slotsOfOther);
        return ratio;
    }

    private static double LogTake(MotionFilter filter, in TrackMeasurement measurement, RegistrationSlots slots)
        => Math.Log(Math.Max(1e-300, filter.Take(measurement, slots)));
}
