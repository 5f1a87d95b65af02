using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// The tracks of the classes that move: makes scans of observations and reports, and messages of tracks. For one
/// thread.
/// </summary>
internal sealed class MovingTargets
{
    // A target that a picture shows is reported so often; the tracker is not sensitive to it.
    private const double DetectionProbability = 0.9;

    // Beyond this a picture does not show where it is any more.
    /// <summary>A track that is less certain than this, standard deviation along the worst axis, is lost.</summary>
    public const double LostSigmaMetres = 25;


    private readonly TargetClassName[] _classes;
    private readonly TargetMotion[] _motions;
    private readonly MovingTracker _tracker;
    private readonly FusionStatistics _statistics;
    private readonly HorizontalCovariance _registration;
    private readonly ScanPoint[] _points;
    private readonly double[] _covariance = new double[16];
    private readonly ForeignEstimate _estimate = new();

    public MovingTargets(SensorFusionOptions options, FusionStatistics statistics, Func<int> nextId)
    {
        KeyValuePair<TargetClassName, TargetMotion>[] moving = options.TargetMotions
            .Where(m => m.Value != TargetMotion.Standing)
            .OrderBy(m => m.Key.ToString(), StringComparer.Ordinal)
            .ToArray();
        _classes = moving.Select(m => m.Key).ToArray();
        _motions = moving.Select(m => m.Value).ToArray();
        _statistics = statistics;
        double variance = options.RegistrationSigmaMetres * options.RegistrationSigmaMetres;
        _registration = new HorizontalCovariance(variance, 0, variance);
        var settings = new TrackerSettings
        {
            MaxTracks = options.MaxTracks,
            Window = options.LateWindow,
            FootprintMarginMetres = options.FootprintMarginMetres,
        };
        _points = new ScanPoint[settings.MaxPoints];
        MotionModel[] models = _motions
            .Select(m => m == TargetMotion.Vehicle ? MotionModel.Vehicle : MotionModel.Walking).ToArray();
        _tracker = new MovingTracker(settings, models, nextId);
    }

    /// <summary>Whether a class moves.</summary>
    public bool Has(TargetClassName name) => Array.IndexOf(_classes, name) >= 0;

    /// <summary>Whether any track is confirmed, by reports.</summary>
    public bool HasConfirmed => _tracker.Tracks.Any(t => t.IsConfirmed);

    /// <summary>Whether there is any track.</summary>
    public bool HasTracks => _tracker.Tracks.Count > 0;

    /// <summary>Deletes all tracks.</summary>
    public void Clear()
    {
        _statistics.TracksDropped += _tracker.Tracks.Count;
        _tracker.Clear();
    }

    /// <summary>Takes the reports of one picture in.</summary>
    /// <param name="reports">Of moving classes, valid and each new.</param>
    /// <param name="source">The vehicle that took it.</param>
    /// <param name="time">When.</param>
    /// <param name="footprint">What it shows; unknown for pictures of other vehicles.</param>
    public void Update(List<LocatedReport> reports, byte source, TimeSpan time, in Footprint footprint)
    {
        int count = Math.Min(reports.Count, _points.Length);
        _statistics.ReportsWithoutRoom += reports.Count - count;
        for (int i = 0; i < count; i++)
            _points[i] = PointOf(reports[i]);
        (long used, long late) = (_tracker.PointsUsed, _tracker.PointsLate);
        (long started, long deleted) = (_tracker.TracksStarted, _tracker.TracksDeleted);
        (long twice, long crowded) = (_tracker.PointsTwice, _tracker.PointsWithoutRoom);
        long joined = _tracker.TracksJoined;
        var scan = new Scan(time, source, DetectionProbability)
        {
            Footprint = footprint,
            AreaSquareMetres = footprint.AreaSquareMetres,
        };
        _tracker.Update(scan, _points.AsSpan(0, count));
        _statistics.ReportsUsed += _tracker.PointsUsed - used;
        _statistics.ReportsLate += _tracker.PointsLate - late;
        _statistics.TracksStarted += _tracker.TracksStarted - started;
        _statistics.TracksDropped += _tracker.TracksDeleted - deleted;
        _statistics.TracksMerged += _tracker.TracksJoined - joined;
        _statistics.ReportsTwice += _tracker.PointsTwice - twice;
        _statistics.ReportsWithoutRoom += _tracker.PointsWithoutRoom - crowded;
        _statistics.TracksOccluded = _tracker.TracksOccluded;
        _statistics.TracksFoundAgain = _tracker.TracksFoundAgain;
        _statistics.TracksExchanged = _tracker.Meetings.Exchanges;
        _statistics.MeetingsWithoutRoom = _tracker.Meetings.WithoutRoom;
        _statistics.Refusals.Add(source, ReportFault.TooOld, _tracker.PointsLate - late);
        for (int i = 0; i < count; i++)
            TrackOf(i)?.Description.Add(reports[i]);
    }

    /// <summary>Takes what another vehicle knows of a target in.</summary>
    /// <param name="estimate">Of a class that moves, valid and new.</param>
    /// <param name="place">Where it is in the local frame.</param>
    /// <returns>Whether anything has changed.</returns>
    public bool Update(in TrackEstimate estimate, NedPosition place)
    {
        _estimate.Set(estimate, place, Array.IndexOf(_classes, estimate.Class), _registration);
        EstimateResult result = _tracker.Update(_estimate);
        _statistics.TracksStartedByEstimates = _tracker.TracksStartedByEstimates;
        switch (result)
        {
            case EstimateResult.Fused or EstimateResult.Started:
                _statistics.EstimatesUsed++;
                return true;
            case EstimateResult.NotNeeded:
                _statistics.EstimatesNotNeeded++;
                return false;
            case EstimateResult.Unusable:
                _statistics.EstimatesRefused++;
                _statistics.Refusals.Add(estimate.SourceSystemId, ReportFault.Covariance);
                return false;
            default:
                _statistics.EstimatesWithoutRoom++;
                return false;
        }
    }

    /// <summary>Deletes tracks that no report has confirmed, and of which no vehicle has known since.</summary>
    /// <returns>Whether there were any.</returns>
    public bool DeleteUnconfirmedOfOthers(TimeSpan since)
    {
        int deleted = _tracker.DeleteUnconfirmedOfOthers(since);
        _statistics.TracksDropped += deleted;
        return deleted > 0;
    }

    /// <summary>
    /// What we know of the targets that we have seen ourselves, for other vehicles; without those that the operator has
    /// rejected.
    /// </summary>
    /// <param name="frame">The local frame.</param>
    /// <param name="since">Older ones are of no use.</param>
    public IEnumerable<TrackEstimate> Estimates(LocalNedFrame frame, TimeSpan since)
    {
        foreach (MovingTrack track in _tracker.Tracks)
        {
            TargetDescription description = track.Description;
            if (track.IsConfirmed && description is { LastOwnPicture: >= 0, Decision: not TargetDecision.Rejected }
                && track.LastSeen >= since)
                yield return EstimateOf(track, frame);
        }
    }

    private TrackEstimate EstimateOf(MovingTrack track, in LocalNedFrame frame)
    {
        MotionFilter filter = track.Filter.Current;
        filter.CopyCovarianceTo(_covariance);
        double[] p = _covariance;
        return new TrackEstimate
        {
            TrackId = track.Id,
            PictureNumber = track.Description.LastOwnPicture,
            Time = track.LastSeen,
            Position = frame.ToGeodetic(new NedPosition(filter.North, filter.East, track.Description.Down)),
            VelocityNed = new NedVector(filter.NorthRate, filter.EastRate, 0),
            Covariance = new HorizontalCovariance(p[0], p[2], p[10]),
            VelocityCovariance = new HorizontalCovariance(p[5], p[7], p[15]),
            NorthWithNorthRate = p[1],
            NorthWithEastRate = p[3],
            EastWithNorthRate = p[6],
            EastWithEastRate = p[11],
            Class = _classes[track.Class],
            MarkerId = track.Marker < 0 ? null : track.Marker,
        };
    }

    /// <summary>The track of a report of the last picture; null for none.</summary>
    public MovingTrack? TrackOf(int report) => report < _points.Length ? _tracker.TrackOfPoint(report) : null;

    /// <summary>Keeps the operator's decision on a track.</summary>
    /// <returns>Whether there is such a track.</returns>
    public bool Decide(in TrackDecision decision)
    {
        foreach (MovingTrack track in _tracker.Tracks)
        {
            if (track.Id != decision.TrackId || decision.Decision == TargetDecision.None)
                continue;
            track.Description.Decision = decision.Decision;
            return true;
        }

        return false;
    }

    /// <summary>The tracks as messages.</summary>
    public IEnumerable<TargetTrack> ToMessages(LocalNedFrame frame)
    {
        foreach (MovingTrack track in _tracker.Tracks)
            yield return ToMessage(track, frame);
    }

    private TargetTrack ToMessage(MovingTrack track, in LocalNedFrame frame)
    {
        MotionFilter filter = track.Filter.Current;
        filter.CopyCovarianceTo(_covariance);
        double[] p = _covariance;
        TargetDescription description = track.Description;
        return new TargetTrack
        {
            Id = track.Id,
            State = StateOf(track),
            Decision = description.Decision,
            Class = _classes[track.Class],
            MarkerId = track.Marker < 0 ? null : track.Marker,
            Motion = _motions[track.Class],
            Position = frame.ToGeodetic(new NedPosition(filter.North, filter.East, description.Down)),
            VelocityNed = new NedVector(filter.NorthRate, filter.EastRate, 0),
            Covariance = new HorizontalCovariance(p[0], p[2], p[10]),
            VelocityCovariance = new HorizontalCovariance(p[5], p[7], p[15]),
            Time = track.LastSeen,
            FirstSeen = track.FirstSeen,
            LastSeen = track.LastSeen,
            Reports = track.Points,
            Misses = track.Misses,
            SizeMetres = description.SizeMetres,
            Bearing = description.Bearing,
            BestPictureNumber = description.BestPictureNumber,
            BestReportIndex = description.BestReportIndex,
            OtherPictures = description.OtherPictures,
        };
    }

    private static TrackState StateOf(MovingTrack track)
    {
        switch (track.Description.Decision)
        {
            case TargetDecision.Confirmed:
                return TrackState.Confirmed;
            case TargetDecision.Rejected:
                return TrackState.Rejected;
        }

        if (!track.IsConfirmed)
            return TrackState.Tentative;
        HorizontalCovariance c = track.Widest.Covariance;
        bool isLost = track.Existence < 0.5
            || track.IsOccluded
            || Math.Max(c.NorthNorth, c.EastEast) > LostSigmaMetres * LostSigmaMetres;
        return isLost ? TrackState.Lost : TrackState.Confirmed;
    }

    private ScanPoint PointOf(in LocatedReport located)
    {
        TargetReport report = located.Report;
        HorizontalCovariance systematic = report.SystematicCovariance;
        bool isStated = systematic.NorthNorth > 0 && systematic.EastEast > 0;
        return new ScanPoint(
            new TrackMeasurement(
                new ReportKey(report.SourceSystemId, report.PictureNumber, report.Index),
                report.Time,
                located.North,
                located.East,
                report.Covariance,
                isStated ? systematic : _registration),
            Array.IndexOf(_classes, report.Class),
            report.MarkerId ?? -1);
    }
}
