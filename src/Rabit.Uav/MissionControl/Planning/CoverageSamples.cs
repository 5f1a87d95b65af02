using System;
using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Sample points of the ground that is to be searched, on a grid and on its border, and by how many legs each is
/// covered: a leg covers what is within a radius of it.
/// </summary>
internal sealed partial class CoverageSamples
{
    // Steps of the samples in parts of the radius; larger where there would be too many.
    private const double GridStep = 0.16;
    private const double BorderStep = 0.06;
    private const int MaxSamples = 100_000;
    private const double GoldenRatio = 0.6180339887;

    // Side of the cells by which samples are found, in parts of the radius.
    private const double CellSide = 0.5;

    private static readonly double[] Depths = [0, 0.04, 0.09, 0.15, 0.22, 0.31, 0.42, 0.55];

    private readonly double _radius;
    private readonly double _radius2;
    private readonly double _fineness;
    private readonly PlanePoint _along;
    private readonly PlanePoint _right;
    private readonly double _minU;
    private readonly double _minV;
    private readonly double _side;
    private readonly int _rows;
    private readonly int _columns;

    // Cell by cell: those of cell i begin at _starts[i].
    private (double U, double V)[] _samples;
    private int[] _starts = [];
    private int[] _counts;
    private bool[] _isIgnored;

    /// <param name="region">The ground.</param>
    /// <param name="radius">Metres.</param>
    /// <param name="heading">Direction of most legs, radians: those are found fastest.</param>
    /// <param name="fineness">How much nearer to each other they are than usual.</param>
    public CoverageSamples(SearchRegion region, double radius, double heading, double fineness = 1)
    {
        _fineness = fineness;
        _radius = radius;
        _radius2 = radius * radius;
        _along = PlanePoint.Towards(heading);
        _right = new PlanePoint(-_along.East, _along.North);
        var samples = new List<(double U, double V)>();
        AddGrid(region, samples);
        AddBorder(region.Outer, region, samples);
        foreach (PlanePolygon keepOut in region.KeepOuts)
            AddBorder(keepOut, region, samples);
        (_minU, _minV) = (double.PositiveInfinity, double.PositiveInfinity);
        double maxU = double.NegativeInfinity;
        double maxV = double.NegativeInfinity;
        foreach ((double u, double v) in samples)
        {
            (_minU, _minV) = (Math.Min(_minU, u), Math.Min(_minV, v));
            (maxU, maxV) = (Math.Max(maxU, u), Math.Max(maxV, v));
        }

        _side = CellSide * radius;
        _rows = Math.Max(1, (int)((maxU - _minU) / _side) + 1);
        _columns = Math.Max(1, (int)((maxV - _minV) / _side) + 1);
        _samples = samples.ToArray();
        _counts = new int[_samples.Length];
        _isIgnored = new bool[_samples.Length];
        Sort();
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
        int count = _samples.Length;
        Array.Resize(ref _samples, count + points.Count);
        Array.Resize(ref _counts, _samples.Length);
        Array.Resize(ref _isIgnored, _samples.Length);
        for (int i = 0; i < points.Count; i++)
            _samples[count + i] = (points[i].Dot(_along), points[i].Dot(_right));
        Uncovered += points.Count;
        Sort();
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
        for (int row = FirstRow(leg); row <= LastRow(leg); row++)
        {
            (int from, int to) = InRow(leg, row);
            Effort += to - from;
            for (int i = from; i < to; i++)
            {
                (double u, double v) = _samples[i];
                if (leg.Distance2(u, v) <= _radius2 && (restOf is null || rest.Distance2(u, v) > _radius2))
                    Count(i, by);
            }
        }
    }

    /// <summary>Whether legs can be replaced by others without uncovering anything.</summary>
    public bool CanReplace(List<PlanePoint> old, List<PlanePoint> by)
    {
        Leg[] oldLegs = LegsOf(old);
        Leg[] newLegs = LegsOf(by);
        foreach (Leg leg in oldLegs)
        {
            for (int row = FirstRow(leg); row <= LastRow(leg); row++)
            {
                (int from, int to) = InRow(leg, row);
                Effort += to - from;
                for (int i = from; i < to; i++)
                {
                    if (_counts[i] <= oldLegs.Length && IsUncovered(i, oldLegs, newLegs))
                        return false;
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

    private bool IsUncovered(int sample, Leg[] oldLegs, Leg[] newLegs)
    {
        (double u, double v) = _samples[sample];
        int old = 0;
        foreach (Leg leg in oldLegs)
            old += leg.Distance2(u, v) <= _radius2 ? 1 : 0;
        if (old == 0 || _counts[sample] > old)
            return false;
        foreach (Leg leg in newLegs)
        {
            if (leg.Distance2(u, v) <= _radius2)
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

    private int FirstRow(in Leg leg) => Index(Math.Min(leg.AU, leg.BU) - _radius - _minU, _rows);

    private int LastRow(in Leg leg) => Index(Math.Max(leg.AU, leg.BU) + _radius - _minU, _rows);

    private int Index(double at, int count) => Math.Max(0, Math.Min(count - 1, (int)Math.Floor(at / _side)));

    // The samples of a row that may be covered: next to the part of the leg that is within a radius of the row.
    private (int From, int To) InRow(in Leg leg, int row)
    {
        double du = leg.BU - leg.AU;
        double first = 0;
        double last = 1;
        if (Math.Abs(du) > 1e-9)
        {
            double t0 = (_minU + (row * _side) - _radius - leg.AU) / du;
            double t1 = (_minU + ((row + 1) * _side) + _radius - leg.AU) / du;
            first = Math.Max(0, Math.Min(t0, t1));
            last = Math.Min(1, Math.Max(t0, t1));
        }

        // The outermost rows hold what rounding puts beyond them.
        if (first > last)
            (first, last) = (0, 1);
        double va = leg.AV + (first * (leg.BV - leg.AV));
        double vb = leg.AV + (last * (leg.BV - leg.AV));
        int from = Index(Math.Min(va, vb) - _radius - _minV, _columns);
        int to = Index(Math.Max(va, vb) + _radius - _minV, _columns);
        return (_starts[(row * _columns) + from], _starts[(row * _columns) + to + 1]);
    }

    private void Sort()
    {
        var cells = new int[_samples.Length];
        var starts = new int[(_rows * _columns) + 1];
        for (int i = 0; i < cells.Length; i++)
        {
            (double u, double v) = _samples[i];
            cells[i] = (Index(u - _minU, _rows) * _columns) + Index(v - _minV, _columns);
            starts[cells[i] + 1]++;
        }

        for (int i = 1; i < starts.Length; i++)
            starts[i] += starts[i - 1];
        _starts = (int[])starts.Clone();
        var samples = new (double U, double V)[cells.Length];
        var counts = new int[cells.Length];
        var isIgnored = new bool[cells.Length];
        for (int i = 0; i < cells.Length; i++)
        {
            int at = starts[cells[i]]++;
            (samples[at], counts[at], isIgnored[at]) = (_samples[i], _counts[i], _isIgnored[i]);
        }

        (_samples, _counts, _isIgnored) = (samples, counts, isIgnored);
    }

    private void AddGrid(SearchRegion region, List<(double U, double V)> samples)
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
                samples.Add((p.Dot(_along), p.Dot(_right)));
        }
    }

    // Rows along the border, the nearer to it the denser: there the ways end.
    private void AddBorder(PlanePolygon border, SearchRegion region, List<(double U, double V)> samples)
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
                        samples.Add((p.Dot(_along), p.Dot(_right)));
                }
            }
        }
    }

    private readonly struct Leg
    {
        private readonly double _du;
        private readonly double _dv;
        private readonly double _inverse2;

        public Leg(double au, double av, double bu, double bv)
        {
            (AU, AV, BU, BV) = (au, av, bu, bv);
            (_du, _dv) = (bu - au, bv - av);
            double length2 = (_du * _du) + (_dv * _dv);
            _inverse2 = length2 > 0 ? 1 / length2 : 0;
        }

        public double AU { get; }

        public double AV { get; }

        public double BU { get; }

        public double BV { get; }

        public double Distance2(double u, double v)
        {
            double x = u - AU;
            double y = v - AV;
            double t = ((x * _du) + (y * _dv)) * _inverse2;
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            x -= t * _du;
            y -= t * _dv;
            return (x * x) + (y * y);
        }
    }
}
