using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Makes tracks of the reports of our own camera and of other vehicles: which reports are of one target, where it stands, how sure
/// that is. A camera that looked where a target should be and did not see it counts too; one that looked elsewhere does not.
/// </summary>
public sealed class SensorFusionManager : RabitManager
{
    /// <summary>The name of the manager.</summary>
    public const string ManagerName = "sensor fusion";

    private const int QueueCapacity = 500;

    // From here on a flat frame is no place to add up positions in.
    private const double FarAwayMetres = 20_000;

    private static readonly TimeSpan SharePeriod = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan WithReportsWaiting = TimeSpan.FromMilliseconds(100);
    private static readonly TimeSpan Idle = TimeSpan.FromSeconds(1);

    private readonly SensorFusionOptions _options;
    private readonly QueueReceiver<TargetReport> _reports;
    private readonly QueueReceiver<CameraObservation> _looks;
    private readonly QueueSender<Envelope<TargetReport>>? _outgoing;
    private readonly MessagePublisher<TrackList> _tracks;
    private readonly FusionStatistics _books = new();
    private readonly LookAssembler _assembler;
    private readonly TargetTracker _tracker;
    private readonly List<CameraObservation> _arrivedLooks = [];
    private readonly List<LocatedReport> _located = [];
    private readonly List<FusedTrack?> _updated = [];
    private SensorFusionCounters _counters = new();
    private LocalNedFrame? _frame;
    private TimeSpan _newest;
    private bool _isChanged;

    /// <summary>Makes the manager.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public SensorFusionManager(SensorFusionOptions options)
        : base(ManagerName)
    {
        _options = (options ?? throw new ArgumentNullException(nameof(options))).ValidatedCopy(nameof(options));
        _assembler = new LookAssembler(_books);
        _tracker = new TargetTracker(_options, _books);
        _reports = Receive<TargetReport>(MessageNames.TargetReports, QueueCapacity);
        _looks = Receive<CameraObservation>(MessageNames.Looks, QueueCapacity);
        if (_options.SharesReports)
            _outgoing = Send<Envelope<TargetReport>>(MessageNames.OutgoingTargetReports);
        _tracks = Publish(MessageNames.Tracks, TrackList.None);
        WakeUpDelay = Idle;
    }

    /// <summary>The books as of the last unit of work. Any thread.</summary>
    public SensorFusionCounters Counters => Volatile.Read(ref _counters);

    /// <inheritdoc/>
    protected override void ExecuteUnitOfWork()
    {
        TimeSpan now = Now;

        // The looks first: whatever was reported of them is in the other queue by then.
        bool hasNews = PopLooks();
        hasNews |= PopReports(now);
        foreach (CameraObservation look in _arrivedLooks)
            Take(look, now);
        while (_assembler.TakeWaitingSince(now - _options.HoldWithoutLook) is { } group)
        {
            Take(group, isOwn: false, time: now, footprint: default);
            hasNews = true;
        }

        if (_isChanged)
            PostTracks();
        if (hasNews)
            Volatile.Write(ref _counters, _books.Close());
        WakeUpDelay = _assembler.HasWaiting ? WithReportsWaiting : Idle;
    }

    private bool PopLooks()
    {
        _arrivedLooks.Clear();
        while (_looks.TryPop(out CameraObservation look))
            _arrivedLooks.Add(look);
        return _arrivedLooks.Count > 0;
    }

    private bool PopReports(TimeSpan now)
    {
        bool hasSome = false;
        while (_reports.TryPop(out TargetReport report))
        {
            _assembler.Add(report, now);
            hasSome = true;
        }

        return hasSome;
    }

    private void Take(in CameraObservation look, TimeSpan now)
    {
        LookGroup? group = _assembler.Take(look.SourceSystemId, look.Number);
        bool isSound = ReportCheck.IsSound(look, now);
        if (!isSound)
            _books.ObservationsRefused++;
        bool isComplete = look.Reports <= (group?.Arrived ?? 0);
        if (isSound && !isComplete)
            _books.LooksIncomplete++;
        if (isSound)
            _books.Looks++;

        if (group is not null)
            Anchor(group);
        Footprint footprint = isSound && isComplete && _frame is { } frame ? Footprint.Of(look, frame) : default;
        if (group is not null)
            Take(group, isOwn: true, time: isSound ? look.Time : now, footprint);
        else if (footprint.IsKnown)
            Track(look.Time, footprint);
    }

    private void Take(LookGroup group, bool isOwn, TimeSpan time, in Footprint footprint)
    {
        Anchor(group);
        foreach (TargetReport report in group.Reports)
        {
            NedPosition place = _frame!.Value.ToNed(report.Position);
            if (IsFarAway(place))
                _books.ReportsRefused++;
            else
                _located.Add(new LocatedReport(report, place, isOwn));
        }

        Track(time, footprint);
        Share();
        _located.Clear();
        _assembler.GiveBack(group);
    }

    private void Track(TimeSpan time, in Footprint footprint)
    {
        if (!_tracker.Take(_located, time, footprint, _updated))
            return;
        _isChanged = true;
        if (time > _newest)
            _newest = time;
    }

    // The first report says where we are. As long as nothing is believed, one from far away says so anew: the first may have been wrong.
    private void Anchor(LookGroup group)
    {
        if (group.Reports.Count == 0)
            return;
        GeodeticPosition first = group.Reports[0].Position;
        if (_frame is { } frame && (_tracker.HasBeenSure || !IsFarAway(frame.ToNed(first))))
            return;
        if (_tracker.Tracks.Count > 0)
        {
            _tracker.Clear();
            _isChanged = true;
        }

        _frame = LocalNedFrame.IgnoringGeoid(first);
    }

    private static bool IsFarAway(NedPosition place) => !(Math.Abs(place.North) < FarAwayMetres && Math.Abs(place.East) < FarAwayMetres);

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

            // A full queue says so in its own books.
            _outgoing.Push(new Envelope<TargetReport> { Content = report });
            track.SharedTime = report.Time;
        }
    }

    private void PostTracks()
    {
        _isChanged = false;
        if (_frame is not { } frame)
            return;
        _tracks.Value = new TrackList(_newest, _tracker.Tracks.Select(t => t.ToMessage(frame)));
        _tracks.PostStamped(_newest);
    }
}
