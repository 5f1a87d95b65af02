using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// The tracks. The reports of one observation are assigned to them all at once; a report that fits none starts a track;
/// a track that should have been reported and was not counts a miss.
/// </summary>
internal sealed class TargetTracker(SensorFusionOptions options, FusionStatistics statistics, Func<int> nextId)
{
    // Above any cost within the gate: a report goes without a track only when none is left for it.
    private const double MissCost = 1e6;

    // So long at least a track has not been reported that makes room for another one.
    private static readonly TimeSpan MinUnseen = TimeSpan.FromSeconds(3);

    private readonly List<FusedTrack> _tracks = [];
    private readonly Assignment _assignment = new();
    private readonly TrackMerger _merger = new();
    private readonly bool[] _isAssigned = new bool[options.MaxTracks];
    private long _observationCount;

    /// <summary>The tracks, by id.</summary>
    public IReadOnlyList<FusedTrack> Tracks => _tracks;

    /// <summary>Whether any track is confirmed, or was.</summary>
    public bool HasConfirmed { get; private set; }

    /// <summary>Deletes all tracks; ids go on.</summary>
    public void Clear()
    {
        statistics.TracksDropped += _tracks.Count;
        foreach (FusedTrack track in _tracks)
            _merger.Forget(track.Id);
        _tracks.Clear();
    }

    /// <summary>Keeps the operator's decision on a track.</summary>
    /// <returns>Whether there is such a track.</returns>
    public bool Decide(in TrackDecision decision)
    {
        int id = decision.TrackId;
        if (decision.Decision == TargetDecision.None || _tracks.Find(t => t.Id == id) is not { } track)
            return false;
        track.Decide(decision.Decision);
        HasConfirmed |= track.State == TrackState.Confirmed;
        return true;
    }

    /// <summary>Updates the tracks by one observation.</summary>
    /// <param name="reports">All its reports, valid and each new.</param>
    /// <param name="time">Its time.</param>
    /// <param name="footprint">What it shows; unknown for reports of another vehicle.</param>
    /// <param name="updated">For each report, the track that it is in now; null where it has none.</param>
    /// <returns>Whether anything changed.</returns>
    public bool Update(
        IReadOnlyList<LocatedReport> reports, TimeSpan time, in Footprint footprint, List<FusedTrack?> updated)
    {
        _observationCount++;
        Pair(reports);
        bool isChanged = MakeRoom(reports, time);
        if (isChanged)
            Pair(reports);
        int before = _tracks.Count;
        updated.Clear();
        for (int i = 0; i < reports.Count; i++)
        {
            int column = _assignment.ColumnOf(i);
            FusedTrack? track = column >= 0 ? Update(_tracks[column], reports[i]) : Start(reports[i], time);
            isChanged |= track is not null;
            if (track is not null && footprint.IsKnown)
                track.LastInOwnPicture = _observationCount;
            updated.Add(track);
        }

        for (int i = 0; i < before; i++)
            isChanged |= CountMiss(_tracks[i], footprint);
        return isChanged | DeleteTentative(time) | Merge(updated);
    }

    private void Pair(IReadOnlyList<LocatedReport> reports)
    {
        _assignment.Begin(reports.Count, _tracks.Count, MissCost);
        for (int r = 0; r < reports.Count; r++)
        {
            for (int t = 0; t < _tracks.Count; t++)
            {
                if (!_tracks[t].MayBe(reports[r].Report.Class, reports[r].Report.MarkerId))
                    continue;
                Innovation innovation = Compare(_tracks[t], reports[r]);
                if (innovation.DistanceSquared <= options.Gate)
                    _assignment.Allow(r, t, innovation.Cost);
            }
        }

        _assignment.Solve();
    }

    // Clutter would fill the room within a minute, and keep out every target that comes after it.
    private bool MakeRoom(IReadOnlyList<LocatedReport> reports, TimeSpan time)
    {
        int missing = _tracks.Count - options.MaxTracks;
        Array.Clear(_isAssigned, 0, _isAssigned.Length);
        for (int i = 0; i < reports.Count; i++)
        {
            int column = _assignment.ColumnOf(i);
            if (column >= 0)
                _isAssigned[column] = true;
            else if (!IsLate(reports[i], time))
                missing++;
        }

        int removed = 0;
        bool isLost = false;
        for (; missing > 0 && !isLost && FindLeast(time) is var least and >= 0; missing--, removed++)
        {
            // Of those that were confirmed once, one at most: a picture full of clutter is not to delete them all.
            isLost = _tracks[least].State == TrackState.Lost;
            _isAssigned.AsSpan(least + 1).CopyTo(_isAssigned.AsSpan(least));
            Remove(least);
        }

        statistics.TracksDropped += removed;
        return removed > 0;
    }

    // The track that has not been reported for the longest, of those that were never confirmed; else of those that are
    // lost. None that the operator has decided on, or that was reported just now. Below zero where there is none.
    private int FindLeast(TimeSpan time)
    {
        int least = -1;
        for (int i = 0; i < _tracks.Count; i++)
        {
            FusedTrack track = _tracks[i];
            bool isFree = !_isAssigned[i] && track.Decision == TargetDecision.None
                && time - track.LastSeen >= MinUnseen && track.State is TrackState.Tentative or TrackState.Lost;
            if (isFree && (least < 0 || IsLess(track, _tracks[least])))
                least = i;
        }

        return least;
    }

    private static bool IsLess(FusedTrack track, FusedTrack than)
        => (track.State == than.State)
            ? track.LastSeen < than.LastSeen
            : track.State == TrackState.Tentative;

    private void Remove(int index)
    {
        _merger.Forget(_tracks[index].Id);
        _tracks.RemoveAt(index);
    }

    private static Innovation Compare(FusedTrack track, in LocatedReport report)
        => track.Filter.Expect(
            report.North, report.East, report.Report.Covariance + track.SystematicTo(report.Report));

    private FusedTrack? Update(FusedTrack track, in LocatedReport report)
    {
        if (track.LastSeen - report.Report.Time > options.LateWindow)
        {
            statistics.ReportsLate++;
            return null;
        }

        track.Update(report);
        track.History.Add(isHit: true);
        track.MissesInARow = 0;
        track.LastObservation = _observationCount;
        statistics.ReportsUsed++;
        Confirm(track);
        return track;
    }

    private FusedTrack? Start(in LocatedReport report, TimeSpan time)
    {
        if (IsLate(report, time))
        {
            statistics.ReportsLate++;
            return null;
        }

        if (_tracks.Count >= options.MaxTracks)
        {
            statistics.ReportsWithoutRoom++;
            return null;
        }

        var track = new FusedTrack(nextId(), report) { LastObservation = _observationCount };
        track.History.Add(isHit: true);
        _tracks.Add(track);
        statistics.TracksStarted++;
        Confirm(track);
        return track;
    }

    // It starts no track.
    private bool IsLate(in LocatedReport report, TimeSpan time) => time - report.Report.Time > options.LateWindow;

    private void Confirm(FusedTrack track)
    {
        if (track.Decision != TargetDecision.None)
            return;
        if (track.State == TrackState.Confirmed || track.History.HitsInLast(options.ConfirmOutOf) < options.ConfirmHits)
            return;
        track.State = TrackState.Confirmed;
        HasConfirmed = true;
    }

    private bool CountMiss(FusedTrack track, in Footprint footprint)
    {
        if (track.LastObservation == _observationCount || !footprint.IsKnown)
            return false;
        HorizontalCovariance total = track.Covariance;
        double margin = options.FootprintMarginMetres + (2 * Math.Sqrt(Math.Max(total.NorthNorth, total.EastEast)));
        if (!footprint.Contains(track.Filter.North, track.Filter.East, margin))
            return false;
        track.Misses++;
        track.MissesInARow++;
        track.History.Add(isHit: false);
        bool isDecided = track.Decision != TargetDecision.None;
        if (!isDecided && track.State == TrackState.Confirmed && track.MissesInARow >= options.LostAfterMisses)
            track.State = TrackState.Lost;
        return true;
    }

    private bool DeleteTentative(TimeSpan time)
    {
        int dropped = 0;
        for (int i = _tracks.Count - 1; i >= 0; i--)
        {
            if (!IsToBeDeleted(_tracks[i], time))
                continue;
            Remove(i);
            dropped++;
        }

        statistics.TracksDropped += dropped;
        return dropped > 0;
    }

    // Missed so often that the remembered observations cannot confirm it any more, or not reported for long.
    private bool IsToBeDeleted(FusedTrack track, TimeSpan time)
        => track.State == TrackState.Tentative
            && (track.History.MissesInLast(options.ConfirmOutOf) > options.ConfirmOutOf - options.ConfirmHits
                || time - track.LastSeen > options.TentativeLifetime);

    private bool Merge(List<FusedTrack?> updated)
    {
        int merged = _merger.Merge(_tracks, _observationCount, updated);
        statistics.TracksMerged += merged;
        return merged > 0;
    }
}
