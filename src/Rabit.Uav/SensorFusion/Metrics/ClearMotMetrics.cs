using System;
using System.Collections.Generic;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Metrics;

/// <summary>
/// CLEAR-MOT: how often tracks miss a target, are of none, or exchange theirs, over the times of a run (Bernardin,
/// Stiefelhagen: "Evaluating Multiple Object Tracking Performance", 2008). Distances are horizontal. For one thread.
/// </summary>
/// <example>
/// <code>
/// var metrics = new ClearMotMetrics(thresholdMetres: 10);
/// metrics.Add([1, 2], [new(0, 0, 0), new(50, 0, 0)], [7], [new(1, 0, 0)]);   // one of the two is missed
/// Console.WriteLine(metrics.Mota);                                           // 0.5
/// </code>
/// </example>
public sealed class ClearMotMetrics
{
    private readonly double _threshold;
    private readonly Assignment _assignment = new();
    private readonly List<int> _freeTruth = [];
    private readonly List<int> _freeTracks = [];
    private Dictionary<int, int> _before = [];
    private Dictionary<int, int> _now = [];
    private double _distances;

    /// <summary>Makes metrics without any times yet.</summary>
    /// <param name="thresholdMetres">From this distance on a track is not of a target; above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">The threshold is out of its range.</exception>
    public ClearMotMetrics(double thresholdMetres)
    {
        if (!(thresholdMetres > 0 && thresholdMetres <= 1e6))
            throw new ArgumentOutOfRangeException(
                nameof(thresholdMetres), thresholdMetres, "The threshold must be above 0 and at most 1e6 m.");
        _threshold = thresholdMetres;
    }

    /// <summary>How many targets there were, summed over the times.</summary>
    public long TruthStates { get; private set; }

    /// <summary>How many pairs of a target and a track there were.</summary>
    public long Matches { get; private set; }

    /// <summary>How often a target had no track.</summary>
    public long Misses => TruthStates - Matches;

    /// <summary>How often a track was of no target.</summary>
    public long FalsePositives { get; private set; }

    /// <summary>How often a target had another track than at the time before.</summary>
    public long IdSwitches { get; private set; }

    /// <summary>1 less misses, false positives and switches by target; not a number before the first target.</summary>
    public double Mota => 1 - ((double)(Misses + FalsePositives + IdSwitches) / TruthStates);

    /// <summary>Mean distance of the pairs, metres; not a number before the first.</summary>
    public double Motp => _distances / Matches;

    /// <summary>Counts one time. Times follow each other; none may be left out.</summary>
    /// <param name="truthIds">Which target each place is of; each once.</param>
    /// <param name="truth">Where the targets are.</param>
    /// <param name="trackIds">Which track each place is of; each once.</param>
    /// <param name="tracks">Where the tracks are.</param>
    /// <exception cref="ArgumentException">There is not one number for each place, or one twice.</exception>
    public void Add(
        ReadOnlySpan<int> truthIds,
        ReadOnlySpan<NedPosition> truth,
        ReadOnlySpan<int> trackIds,
        ReadOnlySpan<NedPosition> tracks)
    {
        Check(truthIds, truth.Length, nameof(truthIds));
        Check(trackIds, tracks.Length, nameof(trackIds));
        _now.Clear();
        TakeAll(_freeTruth, truth.Length);
        TakeAll(_freeTracks, tracks.Length);
        Keep(truthIds, truth, trackIds, tracks);
        PairTheRest(truthIds, truth, trackIds, tracks);
        foreach (KeyValuePair<int, int> pair in _now)
        {
            if (_before.TryGetValue(pair.Key, out int earlier) && earlier != pair.Value)
                IdSwitches++;
        }

        TruthStates += truth.Length;
        Matches += _now.Count;
        FalsePositives += tracks.Length - _now.Count;
        (_before, _now) = (_now, _before);
    }

    // A pair of the time before stays one as long as it is near enough, whatever is nearer.
    private void Keep(
        ReadOnlySpan<int> truthIds,
        ReadOnlySpan<NedPosition> truth,
        ReadOnlySpan<int> trackIds,
        ReadOnlySpan<NedPosition> tracks)
    {
        for (int i = _freeTruth.Count - 1; i >= 0; i--)
        {
            int t = _freeTruth[i];
            if (!_before.TryGetValue(truthIds[t], out int id))
                continue;
            int track = trackIds.IndexOf(id);
            if (track < 0 || !Take(truthIds[t], truth[t], id, tracks[track]))
                continue;
            _freeTruth.RemoveAt(i);
            _freeTracks.Remove(track);
        }
    }

    private void PairTheRest(
        ReadOnlySpan<int> truthIds,
        ReadOnlySpan<NedPosition> truth,
        ReadOnlySpan<int> trackIds,
        ReadOnlySpan<NedPosition> tracks)
    {
        // As many pairs as there can be: going without costs more than any distance on earth.
        _assignment.Begin(_freeTruth.Count, _freeTracks.Count, 1e9);
        for (int i = 0; i < _freeTruth.Count; i++)
        {
            for (int j = 0; j < _freeTracks.Count; j++)
                _assignment.Allow(i, j, truth[_freeTruth[i]].HorizontalDistanceTo(tracks[_freeTracks[j]]));
        }

        _assignment.Solve();
        for (int i = 0; i < _freeTruth.Count; i++)
        {
            int j = _assignment.ColumnOf(i);
            if (j < 0)
                continue;
            (int t, int track) = (_freeTruth[i], _freeTracks[j]);
            _ = Take(truthIds[t], truth[t], trackIds[track], tracks[track]);
        }
    }

    private bool Take(int truthId, NedPosition truth, int trackId, NedPosition track)
    {
        double distance = truth.HorizontalDistanceTo(track);
        if (!(distance < _threshold))
            return false;
        _now.Add(truthId, trackId);
        _distances += distance;
        return true;
    }

    private static void TakeAll(List<int> list, int count)
    {
        list.Clear();
        for (int i = 0; i < count; i++)
            list.Add(i);
    }

    private static void Check(ReadOnlySpan<int> ids, int places, string parameter)
    {
        if (ids.Length != places)
            throw new ArgumentException("There must be one number for each place.", parameter);
        for (int i = 1; i < ids.Length; i++)
        {
            if (ids.Slice(0, i).IndexOf(ids[i]) >= 0)
                throw new ArgumentException("Number " + ids[i] + " is there twice.", parameter);
        }
    }
}
