using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>The legs of the search, flown and remaining, and the coverage of the area.</summary>
internal sealed class SearchRoute
{
    // A leg has a direction as long as its ends are apart by more than the acceptance radius of each.
    private const double MinLegMetres = 5;

    // Of a square of the strip of a leg: as much may be missing of what another vehicle says it has seen.
    private const double MaxLeftFraction = 0.02;

    // For less the order is kept.
    private const double MinGainMetres = 5;

    private readonly FlightPlan _plan;
    private readonly double _spacingMetres;
    private readonly List<LaneSegment> _legs;
    private readonly List<SkippedLane> _skipped = [];
    private readonly List<SkippedLane> _skippedByOthers = [];
    private ImmutableArray<LaneSegment> _shownLegs;
    private ImmutableArray<SkippedLane> _shownSkipped;

    public SearchRoute(FlightPlan plan, double spacingMetres)
    {
        _plan = plan;
        _spacingMetres = spacingMetres;
        _legs = plan.Lanes.ToList();
        Coverage = new CoverageGrid(plan.Area, plan.KeepOuts);
    }

    public CoverageGrid Coverage { get; }

    /// <summary>How many legs there are, with those that are flown.</summary>
    public int Count => _legs.Count;

    /// <summary>All of them. Made again only when they have changed.</summary>
    public ImmutableArray<LaneSegment> Legs
        => _shownLegs.IsDefault ? _shownLegs = _legs.ToImmutableArray() : _shownLegs;

    /// <summary>How much of the leg to fly now has been flown.</summary>
    public double FlownMetresOfLeg { get; set; }

    /// <summary>
    /// How far the camera sees to each side of a leg; of legs beside each other those are left out that this makes
    /// needless. 0 where each is to be flown.
    /// </summary>
    public double SeenToEachSideMetres { get; set; }

    /// <summary>How many have been flown.</summary>
    public int Flown { get; private set; }

    /// <summary>How many of those that count as flown were left out at the operator's command.</summary>
    public int Skipped => _skipped.Count;

    /// <summary>Those. Made again only when there are more.</summary>
    public ImmutableArray<SkippedLane> SkippedLanes
        => !_shownSkipped.IsDefault && _shownSkipped.Length == _skipped.Count
            ? _shownSkipped
            : _shownSkipped = _skipped.ToImmutableArray();

    /// <summary>How often legs over what was missed were added.</summary>
    public int GapPasses { get; private set; }

    /// <summary>Observations whose corners are not those of a picture of the ground here.</summary>
    public long ObservationsRefused { get; private set; }

    /// <summary>The leg to fly now; null when all have been.</summary>
    public LaneSegment? Current => Flown < _legs.Count ? _legs[Flown] : null;

    /// <summary>The leg after that; null where there is none.</summary>
    public LaneSegment? Following => Flown + 1 < _legs.Count ? _legs[Flown + 1] : null;

    /// <summary>What is left to fly, metres.</summary>
    public double MetresLeft
    {
        get
        {
            double sum = -FlownMetresOfLeg;
            for (int i = Flown; i < _legs.Count; i++)
                sum += _legs[i].Length;
            return Math.Max(0, sum);
        }
    }

    /// <summary>How near the legs that remain come to a place; infinite where there are none.</summary>
    /// <param name="place">The place.</param>
    /// <param name="withCurrent">Whether the leg to fly now is one of them.</param>
    public double DistanceOfRest(PlanePoint place, bool withCurrent)
    {
        double least = double.PositiveInfinity;
        for (int i = Flown + (withCurrent ? 0 : 1); i < _legs.Count; i++)
            least = Math.Min(least, _legs[i].DistanceTo(place));
        return least;
    }

    /// <summary>How near what remains of the leg to fly now comes to a place.</summary>
    public double DistanceOfLeg(PlanePoint place)
    {
        LaneSegment leg = _legs[Flown];
        double part = Math.Max(0, Math.Min(1, FlownMetresOfLeg / leg.Length));
        return new LaneSegment(leg.Start + (part * (leg.End - leg.Start)), leg.End).DistanceTo(place);
    }

    public void FinishLeg()
    {
        Flown++;
        FlownMetresOfLeg = 0;
    }

    /// <summary>The leg to fly now is left out: neither it nor gaps of it are flown.</summary>
    public void SkipLeg()
    {
        if (Current is not { } leg)
            return;
        _skipped.Add(new SkippedLane(leg, _spacingMetres / 2));
        FinishLeg();
    }

    /// <summary>Another vehicle of the group leaves this out at the operator's command: so do we.</summary>
    /// <returns>Whether the leg to fly now goes on over it.</returns>
    public bool LeaveOut(SkippedLane skipped)
    {
        _skippedByOthers.Add(skipped);
        if (Current is not { } leg)
            return false;
        double flown = Math.Max(0, Math.Min(1, FlownMetresOfLeg / leg.Length));
        return IsSkipped(leg.Start + ((1 + flown) / 2 * (leg.End - leg.Start)));
    }

    /// <summary>The leg to fly now is left: what was flown of it is cut off.</summary>
    /// <param name="overlapMetres">How much of what was flown is flown again.</param>
    public void InterruptLeg(double overlapMetres)
    {
        if (Current is not { } leg)
            return;
        double cut = Math.Min(FlownMetresOfLeg - overlapMetres, leg.Length - MinLegMetres);
        FlownMetresOfLeg = 0;
        if (!(cut > 0))
            return;
        _legs[Flown] = new LaneSegment(leg.Start + (cut / leg.Length * (leg.End - leg.Start)), leg.End);
        _shownLegs = default;
    }

    /// <summary>Continues where an earlier flight ended.</summary>
    /// <param name="progress">Its legs are those of the plan.</param>
    /// <param name="home">Where the home of that flight is now.</param>
    /// <param name="overlapMetres">How much of what was flown of the last leg is flown again.</param>
    public void Resume(MissionProgress progress, PlanePoint home, double overlapMetres)
    {
        (Flown, FlownMetresOfLeg, GapPasses) = (progress.LanesFlown, progress.FlownMetresOfLeg, progress.GapPasses);
        InterruptLeg(overlapMetres);
        Coverage.Mark(progress.Cells, home);
        _skipped.AddRange(progress.Skipped.Select(s => s with
        {
            Leg = new LaneSegment(s.Leg.Start + home, s.Leg.End + home),
        }));
    }

    /// <summary>
    /// Goes on from the route of another plan: what was flown, seen and left out on it stays so; what was flown of its
    /// present leg counts by what was seen.
    /// </summary>
    public void GoOnFrom(SearchRoute earlier)
    {
        _legs.InsertRange(0, earlier._legs.Take(earlier.Flown));
        Flown = earlier.Flown;
        _skipped.AddRange(earlier._skipped);
        _skippedByOthers.AddRange(earlier._skippedByOthers);
        Coverage.Mark(earlier.Coverage.ToCells(CoverageCells.None), default);
        _shownLegs = default;
    }

    /// <summary>What is left to fly are these legs, but for what was seen next to them already.</summary>
    /// <param name="legs">The legs.</param>
    /// <param name="overlapMetres">How much of what was seen is flown over again.</param>
    /// <param name="from">Where the vehicle is.</param>
    public void SetRest(IReadOnlyList<LaneSegment> legs, double overlapMetres, PlanePoint from)
    {
        _legs.RemoveRange(Flown, _legs.Count - Flown);
        _legs.AddRange(legs);
        (FlownMetresOfLeg, GapPasses) = (0, 0);
        LeaveOutSeen(overlapMetres);
        Reorder(from);
    }

    /// <summary>Leaves out the parts of the legs next to which everything was seen already.</summary>
    /// <param name="overlapMetres">How much of what was seen is flown over again.</param>
    public void LeaveOutSeen(double overlapMetres)
    {
        for (int i = _legs.Count - 1; i >= Flown; i--)
        {
            LaneSegment leg = _legs[i];
            _legs.RemoveAt(i);
            _legs.InsertRange(i, UnseenOf(leg, overlapMetres));
        }

        ThinOut();
        _shownLegs = default;
    }

    private void ThinOut()
    {
        if (LaneThinning.LanesPerPass(SeenToEachSideMetres, _spacingMetres) < 2)
            return;
        List<LaneSegment> kept = LaneThinning.Thin(
            _legs.GetRange(Flown, _legs.Count - Flown), _plan.HeadingRadians + (Math.PI / 2), _spacingMetres / 2,
            SeenToEachSideMetres, Coverage.CellMetres, p => Coverage.IsUnseen(p) && !IsSkipped(p));
        _legs.RemoveRange(Flown, _legs.Count - Flown);
        _legs.AddRange(kept);
    }

    private IEnumerable<LaneSegment> UnseenOf(LaneSegment leg, double overlapMetres)
    {
        PlanePoint along = (1 / leg.Length) * (leg.End - leg.Start);
        var right = new PlanePoint(-along.East, along.North);
        var rows = new List<(double At, int Cells)>();
        double half = _spacingMetres / 2;
        double step = Coverage.CellMetres;
        for (double at = 0; at <= leg.Length; at += step)
        {
            int cells = 0;
            for (double side = -half + (step / 2); side < half; side += step)
            {
                PlanePoint cell = leg.Start + (at * along) + (side * right);
                cells += Coverage.IsUnseen(cell) && !IsSkipped(cell) ? 1 : 0;
            }

            if (cells > 0)
                rows.Add((at, cells));
        }

        foreach ((double from, double to) in LanePlanner.Join(rows.Select(r => (r.At, r.At)), gap: 2 * _spacingMetres))
        {
            // A few cells that were missed are not worth the way.
            double squareMetres = step * step * rows.Where(r => r.At >= from && r.At <= to).Sum(r => r.Cells);
            if (squareMetres <= MaxLeftFraction * _spacingMetres * _spacingMetres)
                continue;
            double first = Math.Max(0, from - overlapMetres);
            double last = Math.Min(leg.Length, Math.Max(to + overlapMetres, first + MinLegMetres));
            yield return new LaneSegment(leg.Start + (first * along), leg.Start + (last * along));
        }
    }

    /// <summary>
    /// Chooses order and direction of the legs that remain again, where that makes the way from here shorter.
    /// </summary>
    public void Reorder(PlanePoint from)
    {
        List<LaneSegment> rest = _legs.GetRange(Flown, _legs.Count - Flown);
        if (rest.Count == 0 || FlownMetresOfLeg > 0)
            return;
        IReadOnlyList<LaneSegment> ordered = _plan.Ordered(rest, from);
        if (!(FlightPlan.WayAlong(ordered, from) < FlightPlan.WayAlong(rest, from) - MinGainMetres))
            return;
        _legs.RemoveRange(Flown, rest.Count);
        _legs.AddRange(ordered);
        _shownLegs = default;
    }

    /// <summary>Adds legs over what has not been seen.</summary>
    /// <param name="from">Where the vehicle is.</param>
    /// <param name="isOurs">Whether a place is ours to see; null where all are.</param>
    /// <returns>How many.</returns>
    public int AddGapLegs(PlanePoint from, Func<PlanePoint, bool>? isOurs = null)
    {
        List<LaneSegment> legs = GapPlanner.Plan(
            Coverage.Unseen().Where(c => !IsSkipped(c) && isOurs?.Invoke(c) != false),
            Coverage.CellMetres, _spacingMetres, _plan.HeadingRadians, from);
        _legs.AddRange(legs);
        _shownLegs = default;
        GapPasses++;
        return legs.Count;
    }

    /// <summary>Marks the ground that a picture showed.</summary>
    public void Mark(in CameraObservation observation)
    {
        PlanePoint a = ToPlane(observation.TopLeft);
        PlanePoint b = ToPlane(observation.TopRight);
        PlanePoint c = ToPlane(observation.BottomRight);
        PlanePoint d = ToPlane(observation.BottomLeft);
        if (IsPicture(a, b, c, d))
            Coverage.Mark(a, b, c, d);
        else
            ObservationsRefused++;
    }

    // The operator may have seen something in the way of it.
    private bool IsSkipped(PlanePoint cell)
        => IsBesideOneOf(_skipped, cell) || IsBesideOneOf(_skippedByOthers, cell);

    // Called for every cell: without a delegate.
    private bool IsBesideOneOf(List<SkippedLane> skipped, PlanePoint cell)
    {
        foreach (SkippedLane lane in skipped)
        {
            if (lane.Leg.DistanceTo(cell) <= lane.HalfMetres + Coverage.CellMetres)
                return true;
        }

        return false;
    }

    // Convex, and of a size that is possible from the heights of a mission; comparisons with NaN are false.
    private static bool IsPicture(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d)
    {
        const double MaxSideMetres = 2000;
        double first = (b - a).Cross(c - b);
        bool isConvex = first * (c - b).Cross(d - c) > 0 && first * (d - c).Cross(a - d) > 0
            && first * (a - d).Cross(b - a) > 0;
        return isConvex && (b - a).Length < MaxSideMetres && (c - b).Length < MaxSideMetres
            && (d - c).Length < MaxSideMetres && (a - d).Length < MaxSideMetres;
    }

    private PlanePoint ToPlane(GeodeticPosition position)
    {
        NedPosition ned = _plan.Frame.ToNed(position);
        return new PlanePoint(ned.North, ned.East);
    }
}
