using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Makes one of two tracks that are of one target. Two that were reported in the same picture more than once are two
/// targets, however near they stand. Of two classes at one place, the one that was taken for the other now and then is
/// dropped.
/// </summary>
internal sealed class TrackMerger
{
    // Chi-square with two degrees of freedom, 95 %: narrower than the gate, since it cannot be taken back.
    private const double MergeGate = 5.99;

    // Once may be a target that was cut in two by a shadow.
    private const int TimesSeenTogether = 2;

    // What is of one class in so many reports for each of another is of the first.
    private const int ReportsForEachOfAnother = 3;

    // A part of a target is within it.
    private const double MaxMetresToPart = 1.5;

    // Once may be two targets at the border of the picture.
    private const int MinTurns = 2;

    private readonly Dictionary<(int First, int Second), int> _together = [];

    // How often the second was reported after the first, and when the first was before that.
    private readonly Dictionary<(int First, int Second), (int Count, long Before)> _turns = [];
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
                bool isSecondKept = tracks[i].State == TrackState.Tentative && tracks[j].State != TrackState.Tentative;
                if (AreOne(tracks[i], tracks[j], observation))
                    Join(tracks, isSecondKept ? j : i, isSecondKept ? i : j, updated);
                else if (IsMistakenFor(tracks[i], tracks[j], observation, out isSecondKept))
                    Drop(tracks, isSecondKept ? i : j);
                else
                    continue;
                merged++;
                if (isSecondKept)
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
        Forget(_together, id);
        Forget(_turns, id);
    }

    private void Forget<T>(Dictionary<(int First, int Second), T> pairs, int id)
    {
        _stale.Clear();
        foreach ((int First, int Second) pair in pairs.Keys)
        {
            if (pair.First == id || pair.Second == id)
                _stale.Add(pair);
        }

        foreach ((int First, int Second) pair in _stale)
            pairs.Remove(pair);
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

    // It is in none of the reports of this observation.
    private void Drop(List<FusedTrack> tracks, int goes)
    {
        Forget(tracks[goes].Id);
        tracks.RemoveAt(goes);
    }

    private bool AreOne(FusedTrack a, FusedTrack b, long observation)
        => a.MayBe(b.Class, b.MarkerId) && AreAtOnePlace(a, b) && CountTogether(a, b, observation) < TimesSeenTogether
            && !IsInBoth(a, b, observation);

    // A part of a panel may look like a person in a few pictures, in turn with those in which the panel is found. One
    // of two things side by side is reported with the other now and then; what covers the other ends its reports.
    private bool IsMistakenFor(FusedTrack a, FusedTrack b, long observation, out bool isSecondKept)
    {
        isSecondKept = b.Reports > a.Reports;
        (FusedTrack kept, FusedTrack other) = isSecondKept ? (b, a) : (a, b);
        if (a.Class == b.Class || a.Decision != TargetDecision.None || b.Decision != TargetDecision.None
            || other.MarkerId is not null || other.HasSeveralSources
            || !IsWithin(a, b, MaxMetresToPart) || !AreAtOnePlace(a, b))
            return false;
        int together = CountTogether(a, b, observation);
        int turns = CountTurns(other, kept, observation);
        CountTurns(kept, other, observation);
        return together == 0 && turns >= MinTurns && other.LastObservation != observation
            && kept.Reports >= ReportsForEachOfAnother * other.Reports;
    }

    private static bool AreAtOnePlace(FusedTrack a, FusedTrack b)
    {
        (PositionFilter fa, PositionFilter fb) = (a.Filter, b.Filter);
        HorizontalCovariance total = fa.Covariance + fb.Covariance + a.SystematicTo(b);
        return total.MahalanobisSquared(fa.North - fb.North, fa.East - fb.East) <= MergeGate;
    }

    private static bool IsWithin(FusedTrack a, FusedTrack b, double metres)
    {
        (double north, double east) = (a.Filter.North - b.Filter.North, a.Filter.East - b.Filter.East);
        return (north * north) + (east * east) <= metres * metres;
    }

    private static bool IsInBoth(FusedTrack a, FusedTrack b, long observation)
        => a.LastObservation == observation && b.LastObservation == observation;

    private int CountTogether(FusedTrack a, FusedTrack b, long observation)
    {
        (int, int) pair = a.Id < b.Id ? (a.Id, b.Id) : (b.Id, a.Id);
        _together.TryGetValue(pair, out int times);
        if (IsInBoth(a, b, observation))
            _together[pair] = ++times;
        return times;
    }

    // By pictures of our own alone: reports of another vehicle are not of all that it sees.
    private int CountTurns(FusedTrack first, FusedTrack second, long observation)
    {
        _turns.TryGetValue((first.Id, second.Id), out (int Count, long Before) turns);
        if (second.LastInOwnPicture != observation || first.LastInOwnPicture == observation
            || first.LastInOwnPicture <= turns.Before)
            return turns.Count;
        _turns[(first.Id, second.Id)] = (turns.Count + 1, first.LastInOwnPicture);
        return turns.Count + 1;
    }
}
