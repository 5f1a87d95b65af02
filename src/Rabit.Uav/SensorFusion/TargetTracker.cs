using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// The tracks: one look at a time, its reports are given to the tracks that they fit best, all at once; what fits none starts a
/// track; what should have been reported and was not is a miss.
/// </summary>
internal sealed class TargetTracker(SensorFusionOptions options, FusionStatistics books)
{
    // Above any cost within the gate: a report goes without a track only when none is left for it.
    private const double MissCost = 1e6;

    private readonly List<FusedTrack> _tracks = [];
    private readonly Assignment _assignment = new();
    private readonly TrackMerger _merger = new();
    private int _lastId;
    private long _lookCount;

    /// <summary>The tracks, by id.</summary>
    public IReadOnlyList<FusedTrack> Tracks => _tracks;

    /// <summary>Whether any track is believed, or was.</summary>
    public bool HasBeenSure { get; private set; }

    /// <summary>Gives up all tracks; ids go on.</summary>
    public void Clear()
    {
        books.TracksDropped += _tracks.Count;
        foreach (FusedTrack track in _tracks)
            _merger.Forget(track.Id);
        _tracks.Clear();
    }

    /// <summary>Takes in what one look reported.</summary>
    /// <param name="reports">All reports of the look, sound and each new.</param>
    /// <param name="time">When it looked.</param>
    /// <param name="footprint">What it showed; unknown where only the reports are.</param>
    /// <param name="updated">For each report, the track that it is in now; null where it has none.</param>
    /// <returns>Whether anything changed.</returns>
    public bool Take(IReadOnlyList<LocatedReport> reports, TimeSpan time, in Footprint footprint, List<FusedTrack?> updated)
    {
        _lookCount++;
        int before = _tracks.Count;
        Pair(reports);
        updated.Clear();
        bool isChanged = false;
        for (int i = 0; i < reports.Count; i++)
        {
            int column = _assignment.ColumnOf(i);
            FusedTrack? track = column >= 0 ? Update(_tracks[column], reports[i]) : Start(reports[i], time);
            isChanged |= track is not null;
            updated.Add(track);
        }

        for (int i = 0; i < before; i++)
            isChanged |= CountMiss(_tracks[i], time, footprint);
        return isChanged | DropTentative(time) | Merge(updated);
    }

    private void Pair(IReadOnlyList<LocatedReport> reports)
    {
        _assignment.Begin(reports.Count, _tracks.Count, MissCost);
        for (int r = 0; r < reports.Count; r++)
        {
            for (int t = 0; t < _tracks.Count; t++)
            {
                if (_tracks[t].Colour != reports[r].Report.Colour)
                    continue;
                Innovation innovation = Compare(_tracks[t], reports[r]);
                if (innovation.DistanceSquared <= options.Gate)
                    _assignment.Allow(r, t, innovation.Cost);
            }
        }

        _assignment.Solve();
    }

    // What is common to all reports of a vehicle does not cancel between two headings, and not at all between two vehicles.
    private Innovation Compare(FusedTrack track, in LocatedReport report)
    {
        TargetReport said = report.Report;
        double lag = Math.Max(0, (track.Time - said.Time).TotalSeconds);
        Innovation innovation = track.FilterAt(said.Time, options.ProcessNoise)
            .Expect(report.North, report.East, said.Covariance, lag)
            .Wider(said.SystematicCovariance);
        return track.LastSource == said.SourceSystemId ? innovation : innovation.Wider(track.Common);
    }

    private FusedTrack? Update(FusedTrack track, in LocatedReport report)
    {
        if (track.Time - report.Report.Time > options.LateWindow)
        {
            books.ReportsLate++;
            return null;
        }

        track.Take(report, options.ProcessNoise);
        track.History.Add(isHit: true);
        track.MissesInARow = 0;
        track.LastObservation = _lookCount;
        books.ReportsUsed++;
        Judge(track);
        return track;
    }

    private FusedTrack? Start(in LocatedReport report, TimeSpan time)
    {
        if (time - report.Report.Time > options.LateWindow)
        {
            books.ReportsLate++;
            return null;
        }

        if (_tracks.Count >= options.MaxTracks)
        {
            books.ReportsWithoutRoom++;
            return null;
        }

        var track = new FusedTrack(++_lastId, report, options) { LastObservation = _lookCount };
        track.History.Add(isHit: true);
        _tracks.Add(track);
        books.TracksStarted++;
        Judge(track);
        return track;
    }

    private void Judge(FusedTrack track)
    {
        if (track.State == TrackState.Confirmed || track.History.HitsInLast(options.ConfirmOutOf) < options.ConfirmHits)
            return;
        track.State = TrackState.Confirmed;
        HasBeenSure = true;
    }

    private bool CountMiss(FusedTrack track, TimeSpan time, in Footprint footprint)
    {
        if (track.LastObservation == _lookCount || !footprint.IsKnown)
            return false;
        PlanarFilter there = track.FilterAt(time, options.ProcessNoise);
        HorizontalCovariance total = there.PositionCovariance + track.Common;
        double margin = options.FootprintMarginMetres + (2 * Math.Sqrt(Math.Max(total.NorthNorth, total.EastEast)));
        if (!footprint.Contains(there.North, there.East, margin))
            return false;
        track.Misses++;
        track.MissesInARow++;
        track.History.Add(isHit: false);
        if (track.State == TrackState.Confirmed && track.MissesInARow >= options.LostAfterMisses)
            track.State = TrackState.Lost;
        return true;
    }

    private bool DropTentative(TimeSpan time)
    {
        int dropped = 0;
        for (int i = _tracks.Count - 1; i >= 0; i--)
        {
            if (!IsHopeless(_tracks[i], time))
                continue;
            _merger.Forget(_tracks[i].Id);
            _tracks.RemoveAt(i);
            dropped++;
        }

        books.TracksDropped += dropped;
        return dropped > 0;
    }

    // Missed so often that the looks that were cannot confirm it any more, or not seen for long.
    private bool IsHopeless(FusedTrack track, TimeSpan time)
        => track.State == TrackState.Tentative
            && (track.History.MissesInLast(options.ConfirmOutOf) > options.ConfirmOutOf - options.ConfirmHits
                || time - track.LastSeen > options.TentativeLifetime);

    private bool Merge(List<FusedTrack?> updated)
    {
        int merged = _merger.Merge(_tracks, _lookCount, options.ProcessNoise, updated);
        books.TracksMerged += merged;
        return merged > 0;
    }
}
