using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>A track of the tracker, mutable.</summary>
internal sealed class FusedTrack
{
    // About as long as a target stays in the pictures of one lane.
    private static readonly TimeSpan MaxPass = TimeSpan.FromSeconds(10);

    private PositionFilter _filter;
    private double _sizeSum;
    private int _sizes;
    private BestReports _best;
    private BearingMean _bearing;

    public FusedTrack(int id, in LocatedReport report)
    {
        Id = id;
        Class = report.Report.Class;
        _filter = new PositionFilter(report.North, report.East, report.Report.Covariance);
        LastSeen = report.Report.Time;
        FirstSeen = report.Report.Time;
        Systematic = report.Report.SystematicCovariance;
        Describe(report);
    }

    public int Id { get; }

    public TargetClassName Class { get; }

    /// <summary>The id of the printed marker that it is; null where none was read.</summary>
    public int? MarkerId { get; private set; }

    public TrackState State { get; set; }

    /// <summary>What the operator said about it, which the state follows.</summary>
    public TargetDecision Decision { get; private set; }

    /// <summary>Where it is, by its reports; how far all of them are off together is not in it.</summary>
    public PositionFilter Filter => _filter;

    public TimeSpan FirstSeen { get; private set; }

    public TimeSpan LastSeen { get; private set; }

    public int Reports { get; private set; }

    public int Misses { get; set; }

    /// <summary>How many observations in a row showed its place and not it.</summary>
    public int MissesInARow { get; set; }

    public DetectionHistory History;

    /// <summary>The uncertainty that does not average out: the largest that a report came with.</summary>
    public HorizontalCovariance Systematic { get; private set; }

    /// <summary>Altitude of the ground it stands on, as the newest report says.</summary>
    public double Down { get; private set; }

    /// <summary>Whether more than one vehicle has reported it.</summary>
    public bool HasSeveralSources => OnlySource is null;

    /// <summary>The vehicle that all reports are of; null when several have reported it.</summary>
    private byte? OnlySource { get; set; }

    /// <summary>The last observation that reported it, as the tracker counts them.</summary>
    public long LastObservation { get; set; }

    /// <summary>The last of these that was a picture of our own.</summary>
    public long LastInOwnPicture { get; set; }

    /// <summary>When a report of it last went out to others; null before the first.</summary>
    public TimeSpan? SharedTime { get; set; }

    public long BestPictureNumber => _best.PictureNumber;

    public int BestReportIndex => _best.ReportIndex;

    /// <summary>How uncertain it is: random and systematic part.</summary>
    public HorizontalCovariance Covariance => _filter.Covariance + Systematic;

    /// <summary>
    /// Whether what has this class and marker may be the same target: an id that was not read excludes none.
    /// </summary>
    public bool MayBe(TargetClassName targetClass, int? markerId)
        => targetClass == Class && (markerId is null || MarkerId is null || markerId == MarkerId);

    /// <summary>Updates it by a report, in whatever order they come.</summary>
    public void Update(in LocatedReport report)
    {
        _filter.Update(report.North, report.East, report.Report.Covariance);
        if (report.Report.Time > LastSeen)
            LastSeen = report.Report.Time;
        Systematic = Larger(Systematic, report.Report.SystematicCovariance);
        Describe(report);
    }

    /// <summary>
    /// Merges another track of the same target into it. Each report is in one of the two, so that they are independent.
    /// </summary>
    public void Absorb(FusedTrack other)
    {
        _filter.Update(other._filter.North, other._filter.East, other._filter.Covariance);
        LastSeen = other.LastSeen > LastSeen ? other.LastSeen : LastSeen;
        Systematic = Larger(Systematic, other.Systematic);
        MarkerId ??= other.MarkerId;
        if (OnlySource != other.OnlySource)
            OnlySource = null;
        FirstSeen = other.FirstSeen < FirstSeen ? other.FirstSeen : FirstSeen;
        Reports += other.Reports;
        _sizeSum += other._sizeSum;
        _sizes += other._sizes;
        _best.Add(other._best);
        _bearing.Add(other._bearing);
        if (Decision == TargetDecision.None && other.Decision != TargetDecision.None)
            Decide(other.Decision);
        else if (other.State == TrackState.Confirmed && Decision == TargetDecision.None)
            State = TrackState.Confirmed;
    }

    /// <summary>The operator's decision: from now on the state is by it alone.</summary>
    public void Decide(TargetDecision decision)
    {
        Decision = decision;
        State = decision == TargetDecision.Confirmed ? TrackState.Confirmed : TrackState.Rejected;
    }

    public TargetTrack ToMessage(in LocalNedFrame frame) => new()
    {
        Id = Id,
        State = State,
        Decision = Decision,
        Class = Class,
        MarkerId = MarkerId,
        Position = frame.ToGeodetic(new NedPosition(_filter.North, _filter.East, Down)),
        Covariance = Covariance,
        Time = LastSeen,
        FirstSeen = FirstSeen,
        LastSeen = LastSeen,
        Reports = Reports,
        Misses = Misses,
        SizeMetres = _sizeSum / _sizes,
        Bearing = _bearing.Value,
        BestPictureNumber = BestPictureNumber,
        BestReportIndex = BestReportIndex,
        OtherPictures = _best.Others,
    };

    /// <summary>
    /// The covariance of the difference to a report by systematic errors. They are common to what a vehicle reports in
    /// one pass. From one pass to the next a mount points the other way, and two vehicles have nothing in common.
    /// </summary>
    public HorizontalCovariance SystematicTo(in TargetReport report)
        => IsOnePass(report.SourceSystemId, report.Time, report.Time)
            ? report.SystematicCovariance
            : Systematic + report.SystematicCovariance;

    /// <summary>The same for two tracks.</summary>
    public HorizontalCovariance SystematicTo(FusedTrack other)
        => IsOnePass(other.OnlySource, other.FirstSeen, other.LastSeen)
            ? Larger(Systematic, other.Systematic)
            : Systematic + other.Systematic;

    private bool IsOnePass(byte? source, TimeSpan first, TimeSpan last)
        => source is not null && source == OnlySource
            && (last > LastSeen ? last : LastSeen) - (first < FirstSeen ? first : FirstSeen) <= MaxPass;

    private void Describe(in LocatedReport report)
    {
        Reports++;
        byte source = report.Report.SourceSystemId;
        OnlySource = Reports == 1 || OnlySource == source ? source : null;
        MarkerId ??= report.Report.MarkerId;
        Down = report.Down;
        _sizeSum += report.Report.SizeMetres;
        _sizes++;
        _bearing.Add(report.Report.Bearing);

        // Only pictures of our own can be shown.
        if (report.IsOwn)
            _best.Add(report.Report.Score, new TrackPicture(report.Report.PictureNumber, report.Report.Index));
    }

    private static HorizontalCovariance Larger(HorizontalCovariance a, HorizontalCovariance b)
        => a.NorthNorth + a.EastEast >= b.NorthNorth + b.EastEast ? a : b;
}
