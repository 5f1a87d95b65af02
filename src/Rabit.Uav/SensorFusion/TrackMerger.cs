using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Makes one of two tracks that are of one target. Two that were reported in the same picture more than once are two
/// targets, however near they stand.
/// </summary>
internal sealed class TrackMerger
{
    // Chi-square with two degrees of freedom, 95 %: narrower than the gate, since it cannot be taken back.
    private const double MergeGate = 5.99;

    // Once may be a target that was cut in two by a shadow.
    private const int TimesSeenTogether = 2;

    private readonly Dictionary<(int First, int Second), int> _together = [];
    private readonly List<(int First, int Second)> _stale = [];

    /// <summary>Merges what is to be merged: into the confirmed one, else the older one.</summary>
    /// <returns>How many tracks are no more.</returns>
    public int Merge(List<FusedTrack> tracks, long observation, List<FusedTrack?> updated)
    {
        int merged = 0;
        for (int i = 0; i < tracks.Count; i++)
        {
            for (int j = i + 1; j < tracks.Count; j++)
            {
                if (!AreOne(tracks[i], tracks[j], observation))
                    continue;
                merged++;
                bool takesSecond = tracks[i].State == TrackState.Tentative && tracks[j].State != TrackState.Tentative;
                Join(tracks, takesSecond ? j : i, takesSecond ? i : j, updated);
                if (takesSecond)
                {
                    i--;
                    break;
                }

                j--;
            }
        }

        return merged;
    }

    /// <summary>Forgets what was remembered of a track that is no more.</summary>
    public void Forget(int id)
    {
        _stale.Clear();
        foreach ((int First, int Second) pair in _together.Keys)
        {
            if (pair.First == id || pair.Second == id)
                _stale.Add(pair);
        }

        foreach ((int First, int Second) pair in _stale)
            _together.Remove(pair);
    }

    private void Join(List<FusedTrack> tracks, int stays, int goes, List<FusedTrack?> updated)
    {
        (FusedTrack kept, FusedTrack gone) = (tracks[stays], tracks[goes]);
        kept.Absorb(gone);
        for (int i = 0; i < updated.Count; i++)
        {
            if (ReferenceEquals(updated[i], gone))
                updated[i] = kept;
        }

        tracks.RemoveAt(goes);
        Forget(gone.Id);
    }

    private bool AreOne(FusedTrack a, FusedTrack b, long observation)
    {
        if (!a.MayBe(b.Class, b.MarkerId))
            return false;
        (PositionFilter fa, PositionFilter fb) = (a.Filter, b.Filter);
        HorizontalCovariance total = fa.Covariance + fb.Covariance + a.SystematicTo(b);
        if (total.MahalanobisSquared(fa.North - fb.North, fa.East - fb.East) > MergeGate)
            return false;

        (int, int) pair = a.Id < b.Id ? (a.Id, b.Id) : (b.Id, a.Id);
        _together.TryGetValue(pair, out int times);
        if (a.LastObservation == observation && b.LastObservation == observation)
        {
            _together[pair] = times + 1;
            return false;
        }

        return times < TimesSeenTogether;
    }
}
