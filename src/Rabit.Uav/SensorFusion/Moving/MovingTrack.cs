using System;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>A track of the <see cref="MovingTracker"/>: mutable, used again for another target after its end.</summary>
internal sealed class MovingTrack(TrackerSettings settings)
{
    public DetectionHistory History;

    private readonly MotionFilter _expected = new();
    private ExpectedPlace _quiet;

    // The probability that there is a target, and it is out of sight; a part of the existence.
    private double _hidden;
    private bool _hasTwoModes;

    /// <summary>
    /// Whether it takes points of a scan; else it goes on with a track that begins where its target may be.
    /// </summary>
    public bool TakesPoints => !IsTooNew
        && !(IsOccluded && IsWiderThan(settings.MaxSigmaForAPointMetres, _expected.PositionCovariance));

    /// <summary>Number of the track; never used again.</summary>
    public int Id { get; private set; }

    public int Class { get; private set; }

    /// <summary>The number on the target; negative before one was read.</summary>
    public int Marker { get; private set; }

    /// <summary>What is known of its target beside where it is.</summary>
    public TargetDescription Description { get; } = new();

    /// <summary>All its points, in any order of arrival.</summary>
    public OutOfSequenceFilter Filter { get; } = new(settings.Window, settings.KeptPoints);

    /// <summary>The probability that there is a target.</summary>
    public double Existence { get; private set; }

    /// <summary>The probability that there is a target, and it is in sight.</summary>
    public double Visible => Existence - _hidden;

    /// <summary>
    /// Whether it is taken for one that is there, but out of sight behind or under something: it is predicted on, and
    /// goes on with the first point that may be its own.
    /// </summary>
    public bool IsOccluded { get; private set; }

    public bool IsConfirmed { get; private set; }

    /// <summary>Whether it is confirmed, and all its points are still kept.</summary>
    public bool IsYoung => IsConfirmed && !Filter.Before.IsStarted;

    /// <summary>Whether no report of it has come yet: only another vehicle knows of it.</summary>
    public bool IsOfOthers => Points == 0;

    public int Points { get; private set; }

    public int Misses { get; private set; }

    public TimeSpan FirstSeen { get; private set; }

    public TimeSpan LastSeen => Filter.Time;

    /// <summary>How uncertain its last point was by itself.</summary>
    public HorizontalCovariance LastPointCovariance { get; private set; }

    /// <summary>The probability of existence that it began with.</summary>
    public double StartExistence { get; private set; }

    /// <summary>
    /// Where it is expected in the present scan, before its points are taken in: in the mode that is least certain of
    /// it, so that nothing that any mode allows is out of the gate.
    /// </summary>
    public ExpectedPlace Widest { get; private set; }

    /// <summary>How likely the present scan misses it, if it exists.</summary>
    public double MissProbability { get; private set; }

    /// <summary>Whether the present scan is too old for it.</summary>
    public bool IsTooNew { get; private set; }

    public void Start(int id, in ScanPoint point, MotionModel model, double existence)
    {
        (Id, Class, Marker) = (id, point.Class, point.Marker);
        (Existence, StartExistence, _hidden) = (existence, existence, 0);
        (IsConfirmed, IsOccluded, Points, Misses) = (false, false, 1, 0);
        // What was expected of the target before, which may have been anywhere, is nothing of this one.
        (Widest, _quiet, _hasTwoModes) = (default, default, false);
        (MissProbability, IsTooNew) = (1, false);
        FirstSeen = point.Measurement.Time;
        LastPointCovariance = point.Measurement.Covariance;
        Description.Clear();
        History = default;
        History.Add(isHit: true);
        Filter.Start(model);
        Filter.Take(point.Measurement);
    }

    /// <summary>
    /// Starts with what another vehicle knows of a target; <see cref="GoOnFrom"/> follows. Reports confirm it, as they
    /// do any other.
    /// </summary>
    public void Start(int id, ForeignEstimate estimate, MotionModel model, double existence)
    {
        (Id, Class, Marker) = (id, estimate.Class, estimate.Marker);
        (Existence, StartExistence, _hidden) = (existence, existence, 0);
        (IsConfirmed, IsOccluded, Points, Misses) = (false, false, 0, 0);
        (Widest, _quiet, _hasTwoModes) = (default, default, false);
        (MissProbability, IsTooNew) = (1, false);
        FirstSeen = estimate.Time;
        LastPointCovariance = default;
        Description.Clear(estimate.Down);
        History = default;
        Filter.Start(model);
    }

    /// <summary>
    /// Goes on with a state that another vehicle has a part in. What was reported before it counts no more: it is in
    /// it already.
    /// </summary>
    public void GoOnFrom(
        ForeignEstimate estimate, MotionModel model, ReadOnlySpan<double> state, ReadOnlySpan<double> covariance,
        ReadOnlySpan<double> correlations)
    {
        Filter.GoOnFrom(model, estimate.Time, state, covariance, correlations);
        (Existence, _hidden, IsOccluded) = (Math.Max(Existence, settings.Confirm), 0, false);
        if (estimate.Marker >= 0)
            Marker = estimate.Marker;
    }

    /// <summary>Goes to the time of a scan, in which the target may have gone.</summary>
    /// <param name="scan">The scan.</param>
    /// <param name="registration">The registration error of its source.</param>
    /// <param name="step">What may have become of the target since the scan before.</param>
    public void Expect(in Scan scan, HorizontalCovariance registration, in ExistenceStep step)
    {
        (Existence, _hidden) = (step.Survival * Existence, step.Survival * _hidden);
        IsTooNew = Filter.IsTooOld(scan.Time);
        if (IsTooNew)
            return;
        Filter.PredictTo(scan.Time, _expected);
        int slot = Filter.Slots.Find(scan.Source);
        HorizontalCovariance known = slot >= 0 ? Filter.Slots[slot] : registration;
        _hasTwoModes = _expected.Modes == 2;
        _quiet = _expected.Expect(0, slot, known);
        Widest = _hasTwoModes ? _expected.Expect(1, slot, known) : _quiet;
        bool isShown = IsShownBy(scan);
        MissProbability = isShown ? 1 - scan.DetectionProbability : 1;
        if (isShown && IsConfirmed && Points >= settings.EstablishedPoints)
            _hidden += (step.Hides * Visible) - (step.Appears * _hidden);
    }

    /// <summary>Whether class and number of a point are not those of another target.</summary>
    public bool MayBe(in ScanPoint point)
        => point.Class == Class && (point.Marker < 0 || Marker < 0 || point.Marker == Marker);

    /// <summary>
    /// Whether a point of the present scan is too old for it, and where its target may have been: then that is no new
    /// one.
    /// </summary>
    public bool HasMissed(in ScanPoint point)
    {
        if (!IsTooNew || !MayBe(point))
            return false;
        TrackMeasurement measurement = point.Measurement;
        Filter.PredictTo(measurement.Time, _expected);
        int slot = Filter.Slots.Find(measurement.Key.Source);
        HorizontalCovariance known = slot >= 0 ? Filter.Slots[slot] : measurement.Registration;
        for (int mode = 0; mode < _expected.Modes; mode++)
        {
            if (_expected.Expect(mode, slot, known).Compare(measurement).DistanceSquared <= settings.Gate)
                return true;
        }

        return false;
    }

    /// <summary>How likely the present scan has a point of the target at a place, per square metre.</summary>
    public double Likelihood(in TrackMeasurement measurement)
    {
        double widest = Widest.Weight * Widest.Compare(measurement).Likelihood;
        return _hasTwoModes ? widest + (_quiet.Weight * _quiet.Compare(measurement).Likelihood) : widest;
    }

    /// <summary>
    /// Takes a point of the present scan in. One that is not its target's would be seen as well if that is hidden.
    /// </summary>
    /// <param name="point">The point.</param>
    /// <param name="likelihood">Of the scan, with the target against without it.</param>
    public TakeResult Hit(in ScanPoint point, double likelihood)
    {
        TakeResult result = Filter.Take(point.Measurement);
        if (result != TakeResult.Used)
            return result;
        Points++;
        LastPointCovariance = point.Measurement.Covariance;
        History.Add(isHit: true);
        Weigh(likelihood);
        IsOccluded &= _hidden > settings.OccludedRatio * Visible;
        if (point.Marker >= 0)
            Marker = point.Marker;
        if (point.Measurement.Time < FirstSeen)
            FirstSeen = point.Measurement.Time;
        IsConfirmed |= Existence >= settings.Confirm
            && History.HitsInLast(settings.ConfirmOutOf) >= settings.ConfirmHits;
        return result;
    }

    /// <summary>Goes on with a track that began later and is of the same target.</summary>
    public void GoOnAs(MovingTrack later)
    {
        foreach (TrackMeasurement measurement in later.Filter.Kept)
            Filter.Take(measurement);
        (Existence, _hidden, IsOccluded) = (later.Existence, later._hidden, later.IsOccluded);
        (History, LastPointCovariance) = (later.History, later.LastPointCovariance);
        Description.GoOnAs(later.Description);
        Points += later.Points;
        Misses += later.Misses;
        if (later.Marker >= 0)
            Marker = later.Marker;
    }

    /// <summary>Has no point in the present scan; a miss only where that shows its place.</summary>
    public void Miss()
    {
        if (IsTooNew || MissProbability >= 1)
            return;
        Misses++;
        History.Add(isHit: false);
        Weigh(MissProbability);
        IsOccluded |= _hidden > settings.OccludedRatio * Visible;
    }

    /// <summary>Whether it is to be deleted.</summary>
    public bool IsOver(TimeSpan now)
    {
        if (Existence < (IsConfirmed ? settings.Delete : settings.DeleteTentative * StartExistence))
            return true;
        if (!IsConfirmed && now - LastSeen > (IsOfOthers ? settings.MaxOccluded : settings.TentativeLifetime))
            return true;
        if (IsTooNew)
            return false;
        if (IsOccluded && (now - LastSeen > settings.MaxOccluded
            || IsWiderThan(settings.MaxOccludedSigmaMetres, _expected.PositionCovariance)))
            return true;
        return IsWiderThan(settings.MaxSigmaMetres, Widest.Covariance);
    }

    private bool IsShownBy(in Scan scan)
    {
        if (scan.ShowsAll)
            return true;
        if (!scan.Footprint.IsKnown)
            return false;
        double sigma = Math.Sqrt(Math.Max(Widest.Covariance.NorthNorth, Widest.Covariance.EastEast));
        double margin = settings.FootprintMarginMetres + (2 * sigma);
        return scan.Footprint.Contains(Widest.North, Widest.East, margin);
    }

    private static bool IsWiderThan(double sigmaMetres, HorizontalCovariance covariance)
        => Math.Max(covariance.NorthNorth, covariance.EastEast) > sigmaMetres * sigmaMetres;

    private void Weigh(double likelihood)
    {
        double visible = Visible * likelihood;
        double sum = 1 - Existence + _hidden + visible;
        (Existence, _hidden) = ((_hidden + visible) / sum, _hidden / sum);
    }
}
