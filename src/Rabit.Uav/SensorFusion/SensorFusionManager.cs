using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion.Moving;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Makes tracks of the reports of our own camera and of other vehicles: which reports are of one target, where it is,
/// how certain that is. An observation that shows the place of a target without reporting it counts as a miss; one that
/// does not show it does not.
/// </summary>
public sealed partial class SensorFusionManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "sensor fusion";

    private const int QueueCapacity = 500;

    // So many reports have an identity that is remembered.
    private const int RememberedReports = 4096;

    // From here on a flat frame is not accurate enough.
    private const double FarAwayMetres = 20_000;

    private static readonly TimeSpan SharePeriod = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan GroupingPeriod = TimeSpan.FromMilliseconds(100);
    private static readonly TimeSpan Idle = TimeSpan.FromSeconds(1);

    private readonly SensorFusionOptions _options;
    private readonly QueueReceiver<CameraObservation> _observations;
    private readonly QueueReceiver<Envelope<TargetReport>> _foreignReports;
    private readonly QueueReceiver<TrackDecision> _decisions;
    private readonly QueueSender<Envelope<TargetReport>>? _outgoing;
    private readonly MessagePublisher<TrackList> _tracks;
    private readonly FusionStatistics _statistics = new();
    private readonly ForeignReportGroups _groups;
    private readonly SeenReports _seen = new(RememberedReports);
    private readonly TargetTracker _tracker;

    // Null where no class moves.
    private readonly MovingTargets? _moving;
    private readonly CameraClockMonitor _cameraClock = new();
    private readonly List<LocatedReport> _located = [];
    private readonly List<LocatedReport> _locatedMoving = [];
    private readonly List<FusedTrack?> _updated = [];
    private SensorFusionCounters _counters = new();
    private LocalNedFrame? _frame;
    private TimeSpan _newest;
    private int _lastTrackId;
    private bool _isChanged;

    /// <summary>Makes the manager.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public SensorFusionManager(SensorFusionOptions options)
        : base(ManagerName)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(nameof(options));
        _groups = new ForeignReportGroups(_statistics);
        _tracker = new TargetTracker(_options, _statistics, NextTrackId);
        if (_options.TargetMotions.Values.Any(m => m != TargetMotion.Standing))
            _moving = new MovingTargets(_options, _statistics, NextTrackId);
        _observations = Receive<CameraObservation>(MessageNames.CameraObservations, QueueCapacity);
        _foreignReports = Receive<Envelope<TargetReport>>(MessageNames.TargetReports, QueueCapacity);
        _decisions = Receive<TrackDecision>(MessageNames.TrackDecisions);
        if (_options.SharesReports)
            _outgoing = Send<Envelope<TargetReport>>(MessageNames.OutgoingTargetReports);
        if (_options.SharesTracks)
        {
            _foreignEstimates = Receive<Envelope<TrackEstimate>>(MessageNames.TrackEstimates, QueueCapacity);
            _outgoingEstimates = Send<Envelope<TrackEstimate>>(MessageNames.OutgoingTrackEstimates);
        }

        _tracks = Publish(MessageNames.Tracks, TrackList.None);
        WakeUpDelay = Idle;
    }

    /// <summary>The counters as of the last unit of work. Any thread.</summary>
    public SensorFusionCounters Counters => Volatile.Read(ref _counters);

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        TimeSpan now = Now;

        bool hasNews = PopForeignReports(now) | PopForeignEstimates(now);
        while (_decisions.TryPop(out TrackDecision decision))
            _isChanged |= _tracker.Decide(decision) || _moving?.Decide(decision) == true;
        while (_observations.TryPop(out CameraObservation observation))
        {
            Update(observation, now);
            hasNews = true;
        }

        while (_groups.TakeSince(now - _options.ReportGroupingDelay) is { } group)
        {
            Update(group, now);
            hasNews = true;
        }

        ShareEstimates(now);
        hasNews |= _isChanged;
        if (_isChanged)
            PostTracks();
        if (hasNews)
            Volatile.Write(ref _counters, _statistics.Close());
        WakeUpDelay = _groups.HasWaiting ? GroupingPeriod : Idle;
    }

    private bool PopForeignReports(TimeSpan now)
    {
        bool hasSome = false;
        while (_foreignReports.TryPop(out Envelope<TargetReport> envelope))
        {
            if (IsUsable(envelope.Content, now))
                _groups.Add(envelope.Content, now);
            hasSome = true;
        }

        return hasSome;
    }

    private bool IsUsable(in TargetReport report, TimeSpan now)
    {
        ReportFault fault = ReportCheck.FaultOf(report, now);
        if (fault != ReportFault.None)
            Refuse(report, fault);
        else if (!_seen.Add(new ReportKey(report.SourceSystemId, report.PictureNumber, report.Index)))
            _statistics.ReportsTwice++;
        else
            return true;
        return false;
    }

    private void Update(in CameraObservation observation, TimeSpan now)
    {
        foreach (TargetReport report in observation.Reports)
        {
            if (IsUsable(report, now))
                Locate(report, isOwn: true);
        }

        bool isValid = ReportCheck.IsValid(observation, now);
        if (isValid)
            _statistics.Observations++;
        else
            _statistics.ObservationsRefused++;
        Footprint footprint = isValid && _frame is { } frame ? Footprint.Of(observation, frame) : default;
        if (observation.Reports.Length > 0 || footprint.IsKnown)
            Track(isValid ? observation.Time : now, footprint);
        TrackMoving(observation.SourceSystemId, isValid ? observation.Time : now, footprint);
        Share();
        foreach (LocatedReport report in _located)
            _cameraClock.Add(report);
        _isChanged |= _cameraClock.Update();
        _located.Clear();
        _locatedMoving.Clear();
    }

    private void Update(ReportGroup group, TimeSpan now)
    {
        foreach (TargetReport report in group.Reports)
            Locate(report, isOwn: false);
        Track(now, footprint: default);
        TrackMoving(group.Source, group.Reports[0].Time, footprint: default);
        _located.Clear();
        _locatedMoving.Clear();
        _groups.GiveBack(group);
    }

    private void Locate(in TargetReport report, bool isOwn)
    {
        if (_located.Count + _locatedMoving.Count == 0)
            Anchor(report.Position);
        NedPosition place = _frame!.Value.ToNed(report.Position);
        if (IsFarAway(place))
            Refuse(report, ReportFault.Position);
        else if (_moving?.Has(report.Class) == true)
            _locatedMoving.Add(new LocatedReport(report, place, isOwn));
        else
            _located.Add(new LocatedReport(report, place, isOwn));
    }

    private void Refuse(in TargetReport report, ReportFault fault)
    {
        _statistics.ReportsRefused++;
        _statistics.Refusals.Add(report.SourceSystemId, fault);
    }

    private int NextTrackId() => ++_lastTrackId;

    private void Track(TimeSpan time, in Footprint footprint)
    {
        if (_tracker.Update(_located, time, footprint, _updated))
            NoteChange(time);
    }

    // A look that shows none of them counts, too: what it should have shown is missed.
    private void TrackMoving(byte source, TimeSpan time, in Footprint footprint)
    {
        if (_moving is null || (_locatedMoving.Count == 0 && !(footprint.IsKnown && _moving.HasTracks)))
            return;
        _moving.Update(_locatedMoving, source, time, footprint);
        NoteChange(time);
    }

    // The first report is the origin. As long as nothing is confirmed, one from far away moves it: the first may have
    // been wrong.
    private void Anchor(GeodeticPosition first)
    {
        bool hasConfirmed = _tracker.HasConfirmed || _moving?.HasConfirmed == true;
        if (_frame is { } frame && (hasConfirmed || !IsFarAway(frame.ToNed(first))))
            return;
        if (_tracker.Tracks.Count > 0 || _moving?.HasTracks == true)
        {
            _tracker.Clear();
            _moving?.Clear();
            _isChanged = true;
        }

        _cameraClock.Clear();

        _frame = LocalNedFrame.IgnoringGeoid(first);
    }

    private static bool IsFarAway(NedPosition place)
        => !(Math.Abs(place.North) < FarAwayMetres && Math.Abs(place.East) < FarAwayMetres);

    private void Share()
    {
        if (_outgoing is null)
            return;
        for (int i = 0; i < _located.Count; i++)
        {
            if (_updated[i] is not { State: TrackState.Confirmed } track || !_located[i].IsOwn)
                continue;
            TargetReport report = _located[i].Report;
            if (track.SharedTime is { } last && report.Time - last < SharePeriod)
                continue;

            // A full queue counts that itself.
            _ = _outgoing.Push(new Envelope<TargetReport> { Content = report });
            track.SharedTime = report.Time;
        }

        for (int i = 0; i < _locatedMoving.Count; i++)
        {
            if (_moving!.TrackOf(i) is not { IsConfirmed: true } track || !_locatedMoving[i].IsOwn)
                continue;
            TargetReport report = _locatedMoving[i].Report;
            if (track.Description.SharedTime is { } last && report.Time - last < SharePeriod)
                continue;
            _ = _outgoing.Push(new Envelope<TargetReport> { Content = report });
            track.Description.SharedTime = report.Time;
        }
    }

    private void PostTracks()
    {
        _isChanged = false;
        if (_frame is not { } frame)
            return;
        IEnumerable<TargetTrack> tracks = _tracker.Tracks.Select(t => t.ToMessage(frame));
        if (_moving is not null)
            tracks = tracks.Concat(_moving.ToMessages(frame)).OrderBy(t => t.Id);
        _tracks.Value = new TrackList(_newest, tracks)
        {
            CameraClock = _cameraClock.Estimate,
        };
        _tracks.PostStamped(_newest);
    }
}
