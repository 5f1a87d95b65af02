using System;
using System.Linq;

namespace Rabit.Uav.SensorFusion.Moving;

// What other vehicles know of targets.
internal sealed partial class MovingTracker
{
    private readonly EstimateFusion _estimates = new();

    /// <summary>States of other vehicles that started a track.</summary>
    public long TracksStartedByEstimates { get; private set; }

    /// <summary>Takes what another vehicle knows of a target in.</summary>
    public EstimateResult Update(ForeignEstimate estimate)
    {
        MotionModel model = _models[estimate.Class];
        if (_estimates.Find(_tracks, estimate) is { } track)
        {
            if (estimate.Time <= track.LastSeen + _settings.EstimateNewerBy)
                return EstimateResult.NotNeeded;
            return _estimates.TryFuse(track, estimate, model) ? EstimateResult.Fused : EstimateResult.Unusable;
        }

        // Targets of our own always find room.
        if (_unused.Count == 0 || _tracks.Count(t => t.IsOfOthers) >= _settings.MaxTracks / 2)
            return EstimateResult.WithoutRoom;
        MovingTrack started = _unused.Pop();
        _estimates.Start(started, _nextId(), estimate, model, _settings.Confirm);
        _tracks.Add(started);
        TracksStartedByEstimates++;
        return EstimateResult.Started;
    }

    /// <summary>Deletes tracks that are known from other vehicles alone, and from before a time.</summary>
    /// <returns>How many.</returns>
    public int DeleteUnconfirmedOfOthers(TimeSpan since)
    {
        long before = TracksDeleted;
        for (int t = _tracks.Count - 1; t >= 0; t--)
        {
            if (_tracks[t].IsOfOthers && _tracks[t].LastSeen < since)
                Remove(t);
        }

        return (int)(TracksDeleted - before);
    }

    // Of a target that is known by something newer: a track that began with it would be a second one.
    private void LeaveLate(ReadOnlySpan<ScanPoint> points)
    {
        foreach (MovingTrack track in _tracks)
        {
            for (int p = 0; track.IsTooNew && p < points.Length; p++)
            {
                if (_trackOfPoint[p] != 0 || !track.HasMissed(points[p]))
                    continue;
                _trackOfPoint[p] = LatePoint;
                _withoutTrack[points[p].Class]--;
                PointsLate++;
            }
        }
    }
}
