using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>A track of the tracker, mutable.</summary>
internal sealed class FusedTrack
{
    private double _sizeSum;
    private int _sizes;
    private BestReports _best;
    private BearingMean _bearing;

    public FusedTrack(int id, in LocatedReport report, SensorFusionOptions options)
    {
        Id = id;
        Class = report.Report.Class;
        Filter = PlanarFilter.From(report.North, report.East, report.Report.Covariance, options.StartVelocitySigma);
        Time = report.Report.Time;
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

    public PlanarFilter Filter { get; private set; }

    /// <summary>The time of the filter: that of its newest report.</summary>
    public TimeSpan Time { get; private set; }

    public TimeSpan FirstSeen { get; private set; }

    public TimeSpan LastSeen => Time;

    public int Reports { get; private set; }

    public int Misses { get; set; }

    /// <summary>How many observations in a row showed its place and not it.</summary>
    public int MissesInARow { get; set; }

    public DetectionHistory History;

    /// <summary>The uncertainty that does not average out: the largest that a report came with.</summary>
    public HorizontalCovariance Systematic { get; private set; }

    /// <summary>Altitude of the ground it stands on, as the newest report says.</summary>
    public double Down { get; private set; }

    /// <summary>The vehicle that reported it last.</summary>
    public byte LastSource { get; private set; }

    /// <summary>The last observation that reported it, as the tracker counts them.</summary>
    public long LastObservation { get; set; }

    /// <summary>When a report of it last went out to others; null before the first.</summary>
    public TimeSpan? SharedTime { get; set; }

    public long BestPictureNumber => _best.PictureNumber;

    public int BestReportIndex => _best.ReportIndex;

    /// <summary>How uncertain it is: random and systematic part.</summary>
    public HorizontalCovariance Covariance => Filter.PositionCovariance + Systematic;

    /// <summary>
    /// Whether what has this class and marker may be the same target: an id that was not read excludes none.
    /// </summary>
    public bool MayBe(TargetClassName targetClass, int? markerId)
        => targetClass == Class && (markerId is null || MarkerId is null || markerId == MarkerId);

    /// <summary>The filter at a time; at its own time if that is later.</summary>
    public PlanarFilter FilterAt(TimeSpan time, double processNoise)
    {
        PlanarFilter filter = Filter;
        double seconds = (time - Time).TotalSeconds;
        if (seconds > 0)
            filter.Predict(seconds, processNoise);
        return filter;
    }

    /// <summary>Updates it by a report; one that is older than the newest counts for its own time.</summary>
    public void Update(in LocatedReport report, double processNoise)
    {
        double seconds = (report.Report.Time - Time).TotalSeconds;
        PlanarFilter filter = FilterAt(report.Report.Time, processNoise);
        filter.Update(report.North, report.East, report.Report.Covariance, Math.Max(0, -seconds));
        Filter = filter;
        if (seconds > 0)
            Time = report.Report.Time;
        Systematic = Larger(Systematic, report.Report.SystematicCovariance);
        Describe(report);
    }

    /// <summary>
    /// Merges another track of the same target into it. Each report is in one of the two, so that they are independent.
    /// </summary>
    public void Absorb(FusedTrack other, double processNoise)
    {
        TimeSpan time = other.Time > Time ? other.Time : Time;
        PlanarFilter filter = FilterAt(time, processNoise);
        PlanarFilter otherFilter = other.FilterAt(time, processNoise);
        filter.Update(otherFilter.North, otherFilter.East, otherFilter.PositionCovariance, 0);
        Filter = filter;
        Time = time;
        Systematic = Larger(Systematic, other.Systematic);
        MarkerId ??= other.MarkerId;
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
        Position = frame.ToGeodetic(new NedPosition(Filter.North, Filter.East, Down)),
        VelocityNed = new NedVector(Filter.NorthRate, Filter.EastRate, 0),
        Covariance = Covariance,
        Time = Time,
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
    /// The covariance of the difference of two tracks by systematic errors: those of one vehicle are partly the same in
    /// both, those of two are independent.
    /// </summary>
    public static HorizontalCovariance SystematicOf(FusedTrack a, FusedTrack b)
        => a.LastSource == b.LastSource ? Larger(a.Systematic, b.Systematic) : a.Systematic + b.Systematic;

    private void Describe(in LocatedReport report)
    {
        Reports++;
        MarkerId ??= report.Report.MarkerId;
        Down = report.Down;
        LastSource = report.Report.SourceSystemId;
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
