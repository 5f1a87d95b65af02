using System;
using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Sample points of the ground that is to be searched, on a grid and on its border, and by how many legs each is
/// covered: a leg covers what is within a radius of it.
/// </summary>
internal sealed class CoverageSamples
{
    // Steps of the samples in parts of the radius; larger where there would be too many.
    private const double GridStep = 0.16;
    private const double BorderStep = 0.06;
    private const int MaxSamples = 100_000;
    private const double GoldenRatio = 0.6180339887;

    private static readonly double[] Depths = [0, 0.04, 0.09, 0.15, 0.22, 0.31, 0.42, 0.55];

    private readonly double _radius;
    private readonly double _fineness;
    private readonly PlanePoint _along;
    private readonly PlanePoint _right;
    private readonly List<(double U, double V)> _samples = [];
    private readonly List<int>?[] _buckets;
    private int[] _counts;
    private bool[] _isIgnored;
    private readonly double _minU;
    private readonly double _minV;
    private readonly int _rows;
    private readonly int _columns;

    /// <param name="region">The ground.</param>
    /// <param name="radius">Metres.</param>
    /// <param name="heading">Direction of most legs, radians: those are found fastest.</param>
    /// <param name="fineness">How much nearer to each other they are than usual.</param>
    public CoverageSamples(SearchRegion region, double radius, double heading, double fineness = 1)
    {
        _fineness = fineness;
        _radius = radius;
        _along = PlanePoint.Towards(heading);
        _right = new PlanePoint(-_along.East, _along.North);
        AddGrid(region);
        AddBorder(region.Outer, region);
        foreach (PlanePolygon keepOut in region.KeepOuts)
            AddBorder(keepOut, region);
        (_minU, _minV) = (double.PositiveInfinity, double.PositiveInfinity);
        double maxU = double.NegativeInfinity;
        double maxV = double.NegativeInfinity;
        foreach ((double u, double v) in _samples)
        {
            (_minU, _minV) = (Math.Min(_minU, u), Math.Min(_minV, v));
            (maxU, maxV) = (Math.Max(maxU, u), Math.Max(maxV, v));
        }

        _rows = Math.Max(1, (int)((maxU - _minU) / _radius) + 1);
        _columns = Math.Max(1, (int)((maxV - _minV) / _radius) + 1);
        _buckets = new List<int>?[_rows * _columns];
        for (int i = 0; i < _samples.Count; i++)
            (_buckets[BucketOf(_samples[i])] ??= []).Add(i);
        _counts = new int[_samples.Count];
        _isIgnored = new bool[_samples.Count];
        Clear();
    }

    /// <summary>How many samples have been looked at.</summary>
    public long Effort { get; private set; }

    /// <summary>How many samples no leg covers.</summary>
    public int Uncovered { get; private set; }

    /// <summary>Begins again, with no legs.</summary>
    public void Clear()
    {
        Uncovered = 0;
        for (int i = 0; i < _counts.Length; i++)
        {
            _counts[i] = _isIgnored[i] ? 1 : 0;
            Uncovered += 1 - _counts[i];
        }
    }

    /// <summary>More samples, which no leg covers.</summary>
    public void Add(List<PlanePoint> points)
    {
        foreach (PlanePoint p in points)
        {
            Add(p);
            (_buckets[BucketOf(_samples[_samples.Count - 1])] ??= []).Add(_samples.Count - 1);
        }

        Array.Resize(ref _counts, _samples.Count);
        Array.Resize(ref _isIgnored, _samples.Count);
        Uncovered += points.Count;
    }

    /// <summary>Takes what no leg covers now out of the samples: it cannot be covered.</summary>
    public void IgnoreUncovered()
    {
        for (int i = 0; i < _counts.Length; i++)
        {
            if (_counts[i] != 0)
                continue;
            (_isIgnored[i], _counts[i]) = (true, 1);
            Uncovered--;
        }
    }

    /// <summary>Adds a leg, or takes it away.</summary>
    /// <param name="a">Its start.</param>
    /// <param name="b">Its end.</param>
    /// <param name="by">1 or -1.</param>
    /// <param name="restOf">
    /// Where the leg before its start begins that it is cut off from: what that one covers does not change.
    /// </param>
    public void Change(PlanePoint a, PlanePoint b, int by, PlanePoint? restOf = null)
    {
        Leg rest = restOf is { } start ? LegOf(start, a) : default;
        Leg leg = LegOf(a, b);
        double radius2 = _radius * _radius;
        int fromRow = Row(Math.Min(leg.AU, leg.BU) - _radius, _minU, _rows);
        int toRow = Row(Math.Max(leg.AU, leg.BU) + _radius, _minU, _rows);
        int fromColumn = Row(Math.Min(leg.AV, leg.BV) - _radius, _minV, _columns);
        int toColumn = Row(Math.Max(leg.AV, leg.BV) + _radius, _minV, _columns);
        for (int row = fromRow; row <= toRow; row++)
        {
            for (int column = fromColumn; column <= toColumn; column++)
            {
                if (_buckets[(row * _columns) + column] is not { } bucket)
                    continue;
                Effort += bucket.Count;
                foreach (int i in bucket)
                {
                    (double u, double v) = _samples[i];
                    if (leg.Distance2(u, v) <= radius2 && (restOf is null || rest.Distance2(u, v) > radius2))
                        Count(i, by);
                }
            }
        }
    }

    /// <summary>Whether legs can be replaced by others without uncovering anything.</summary>
    public bool CanReplace(List<PlanePoint> old, List<PlanePoint> by)
    {
        Leg[] oldLegs = LegsOf(old);
        Leg[] newLegs = LegsOf(by);
        double radius2 = _radius * _radius;
        foreach (Leg leg in oldLegs)
        {
            int toRow = Row(Math.Max(leg.AU, leg.BU) + _radius, _minU, _rows);
            int toColumn = Row(Math.Max(leg.AV, leg.BV) + _radius, _minV, _columns);
            int fromColumn = Row(Math.Min(leg.AV, leg.BV) - _radius, _minV, _columns);
            for (int row = Row(Math.Min(leg.AU, leg.BU) - _radius, _minU, _rows); row <= toRow; row++)
            {
                for (int column = fromColumn; column <= toColumn; column++)
                {
                    if (_buckets[(row * _columns) + column] is not { } bucket)
                        continue;
                    Effort += bucket.Count;
                    foreach (int i in bucket)
                    {
                        if (_counts[i] <= oldLegs.Length && IsUncovered(i, oldLegs, newLegs, radius2))
                            return false;
                    }
                }
            }
        }

        return true;
    }

    /// <summary>The samples that no leg covers.</summary>
    public IEnumerable<PlanePoint> UncoveredPoints()
    {
        for (int i = 0; i < _counts.Length; i++)
        {
            if (_counts[i] == 0)
                yield return (_samples[i].U * _along) + (_samples[i].V * _right);
        }
    }

    private bool IsUncovered(int sample, Leg[] oldLegs, Leg[] newLegs, double radius2)
    {
        (double u, double v) = _samples[sample];
        int old = 0;
        foreach (Leg leg in oldLegs)
            old += leg.Distance2(u, v) <= radius2 ? 1 : 0;
        if (old == 0 || _counts[sample] > old)
            return false;
        foreach (Leg leg in newLegs)
        {
            if (leg.Distance2(u, v) <= radius2)
                return false;
        }

        return true;
    }

    private Leg[] LegsOf(List<PlanePoint> way)
    {
        var legs = new Leg[Math.Max(0, way.Count - 1)];
        for (int i = 0; i < legs.Length; i++)
            legs[i] = LegOf(way[i], way[i + 1]);
        return legs;
    }

    private Leg LegOf(PlanePoint a, PlanePoint b)
        => new(a.Dot(_along), a.Dot(_right), b.Dot(_along), b.Dot(_right));

    private void Count(int sample, int by)
    {
        int before = _counts[sample];
        _counts[sample] = before + by;
        if (before == 0)
            Uncovered--;
        else if (before + by == 0)
            Uncovered++;
    }

    private static int Row(double at, double min, double size, int count)
        => Math.Max(0, Math.Min(count - 1, (int)Math.Floor((at - min) / size)));

    private int Row(double at, double min, int count) => Row(at, min, _radius, count);

    private int BucketOf((double U, double V) s) => (Row(s.U, _minU, _rows) * _columns) + Row(s.V, _minV, _columns);

    private void AddGrid(SearchRegion region)
    {
        double north = double.NegativeInfinity;
        double east = double.NegativeInfinity;
        double south = double.PositiveInfinity;
        double west = double.PositiveInfinity;
        foreach (PlanePoint c in region.Outer.Corners)
        {
            (south, north) = (Math.Min(south, c.North), Math.Max(north, c.North));
            (west, east) = (Math.Min(west, c.East), Math.Max(east, c.East));
        }

        // The additive recurrence by the powers of the plastic number: spread evenly, and in no direction in rows,
        // between which a gap along a lane would not be seen.
        const double StepNorth = 0.7548776662466927;
        const double StepEast = 0.5698402909980532;
        double step = Math.Max(GridStep * _radius, Math.Sqrt(region.Outer.Area / MaxSamples)) / _fineness;
        int count = (int)Math.Ceiling((north - south) * (east - west) / step / step);
        for (int i = 1; i <= count; i++)
        {
            var p = new PlanePoint(
                south + ((north - south) * (i * StepNorth % 1)), west + ((east - west) * (i * StepEast % 1)));
            if (region.Contains(p))
                Add(p);
        }
    }

    // Rows along the border, the nearer to it the denser: there the ways end.
    private void AddBorder(PlanePolygon border, SearchRegion region)
    {
        double side = ReferenceEquals(border, region.Outer) ? Math.PI : 0;
        for (int i = 0; i < border.Corners.Count; i++)
        {
            PlanePoint edge = border.After(i) - border.Corners[i];
            PlanePoint inwards = PlanePoint.Towards(border.NormalBefore((i + 1) % border.Corners.Count, 0) + side);
            int steps = (int)Math.Ceiling(edge.Length / (BorderStep * _radius / _fineness));
            for (int row = 0; row < Depths.Length; row++)
            {
                for (int k = 0; k < steps; k++)
                {
                    double at = (k + (row * GoldenRatio % 1)) / steps;
                    PlanePoint p = border.Corners[i] + (at * edge) + (Depths[row] * _radius * inwards);
                    bool isOnBorder = row == 0
                        && (ReferenceEquals(border, region.Outer) || region.Outer.Contains(p));
                    if (isOnBorder || (row > 0 && region.Contains(p)))
                        Add(p);
                }
            }
        }
    }

    private void Add(PlanePoint p) => _samples.Add((p.Dot(_along), p.Dot(_right)));

    private readonly struct Leg(double au, double av, double bu, double bv)
    {
        public double AU { get; } = au;

        public double AV { get; } = av;

        public double BU { get; } = bu;

        public double BV { get; } = bv;

        public double Distance2(double u, double v)
        {
            double du = BU - AU;
            double dv = BV - AV;
            double length2 = (du * du) + (dv * dv);
            double t = length2 > 0 ? (((u - AU) * du) + ((v - AV) * dv)) / length2 : 0;
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            double x = u - AU - (t * du);
            double y = v - AV - (t * dv);
            return (x * x) + (y * y);
        }
    }
}
