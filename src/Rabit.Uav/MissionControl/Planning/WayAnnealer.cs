using System;
using System.Collections.Generic;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Changes a way at random and keeps what makes it shorter, and at first also what makes it little longer (threshold
/// accepting, Dueck and Scheuer 1990): corners are moved, left out and added, parts reversed and put elsewhere. Samples
/// that are not covered cost length, the more the later. Deterministic.
/// </summary>
internal sealed class WayAnnealer
{
    // In sweeps: what a change may cost, how far a corner is moved, and what a sample that is not covered costs.
    private const double FirstThreshold = 0.5;
    private const double FirstMove = 0.8;
    private const double LastMove = 0.03;
    private const double FirstPenalty = 0.25;
    private const double LastPenalty = 0.4;

    private const int MaxMoved = 3;

    private readonly SearchRegion _region;
    private readonly CoverageSamples _samples;
    private readonly double _sweep;
    private readonly PlanePoint? _from;
    private readonly List<PlanePoint> _way;
    private readonly List<(PlanePoint A, PlanePoint B)> _old = [];
    private readonly List<(PlanePoint A, PlanePoint B)> _new = [];
    private List<PlanePoint> _best;
    private double _bestCost = double.PositiveInfinity;
    private double _cost;
    private double _threshold;
    private double _penalty;
    private double _move;
    private ulong _state;

    private WayAnnealer(
        SearchRegion region, CoverageSamples samples, double sweep, List<PlanePoint> way, PlanePoint? from)
    {
        (_region, _samples, _sweep, _from) = (region, samples, sweep, from);
        _way = [.. way];
        _best = way;
        samples.Clear();
        for (int i = 0; i + 1 < way.Count; i++)
            samples.Change(way[i], way[i + 1], 1);
        for (int i = 0; i < way.Count; i++)
            _cost += Into(i) + (WayShortener.CornerCost * sweep);
    }

    /// <summary>Shortens a way.</summary>
    /// <param name="region">Where it may be.</param>
    /// <param name="samples">What it covers.</param>
    /// <param name="sweep">Width of what is seen.</param>
    /// <param name="way">Its corners.</param>
    /// <param name="from">Where the vehicle is; null where the way may begin anywhere.</param>
    /// <param name="first">1 where it is the first part of the work, less where it goes on, as is left of it.</param>
    /// <param name="last">What is then left.</param>
    /// <param name="maxEffort">How many samples may be looked at.</param>
    /// <param name="seed">Of the random numbers.</param>
    public static List<PlanePoint> Anneal(
        SearchRegion region, CoverageSamples samples, double sweep, List<PlanePoint> way, PlanePoint? from,
        double first, double last, long maxEffort, ulong seed)
    {
        if (way.Count < 3)
            return way;
        var annealer = new WayAnnealer(region, samples, sweep, way, from) { _state = seed };
        long begun = samples.Effort;
        for (int step = 0; samples.Effort - begun < maxEffort && step < maxEffort / 20; step++)
        {
            double done = Math.Max((samples.Effort - begun) / (double)maxEffort, step / (maxEffort / 20.0));
            annealer.Set(first + ((last - first) * done));
            annealer.Step();
        }

        return annealer._best;
    }

    private void Set(double left)
    {
        _threshold = FirstThreshold * _sweep * left * left * left;
        _penalty = _sweep * (LastPenalty + ((FirstPenalty - LastPenalty) * left));
        _move = _sweep * (LastMove + ((FirstMove - LastMove) * left * left));
    }

    private void Step()
    {
        double kind = Uniform();
        int at = (int)(Uniform() * _way.Count);
        if (kind < 0.45)
            Replace(at, 1, [_way[at] + Offset()]);
        else if (kind < 0.62)
            MoveLeg(at);
        else if (kind < 0.72)
            Replace(at, 1, []);
        else if (kind < 0.82)
            Insert(at);
        else if (kind < 0.91)
            ReversePart(at);
        else
            MovePart(at);
    }

    private void MoveLeg(int at)
    {
        if (at + 1 >= _way.Count)
            return;
        PlanePoint by = Offset();
        Replace(at, 2, [_way[at] + by, _way[at + 1] + by]);
    }

    private void Insert(int at)
    {
        double part = Uniform();
        PlanePoint place = at == 0 ? _way[0] : _way[at - 1] + (part * (_way[at] - _way[at - 1]));
        Replace(at, 0, [place + Offset()]);
    }

    private PlanePoint Offset()
    {
        double scale = Uniform();
        scale = _move * (0.1 + (0.9 * scale * scale)) * 2;
        return new PlanePoint(scale * (Uniform() - 0.5) * 2, scale * (Uniform() - 0.5) * 2);
    }

    private double Uniform()
    {
        _state += 0x9E3779B97F4A7C15;
        ulong mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
        mixed ^= mixed >> 31;
        return (mixed >> 11) * (1.0 / (1UL << 53));
    }

    private double Into(int i)
        => i > 0 ? _way[i - 1].DistanceTo(_way[i]) : _from is { } from ? from.DistanceTo(_way[0]) : 0;

    private void Replace(int at, int count, PlanePoint[] by)
    {
        if (_way.Count - count + by.Length < 2)
            return;
        foreach (PlanePoint p in by)
        {
            if (!_region.Outer.Contains(p) && !_region.IsFree(p))
                return;
        }

        _old.Clear();
        _new.Clear();
        int from = Math.Max(0, at - 1);
        int to = Math.Min(_way.Count - 1, at + count);
        for (int i = from; i < to; i++)
            _old.Add((_way[i], _way[i + 1]));
        PlanePoint? last = at > 0 ? _way[at - 1] : null;
        foreach (PlanePoint p in by)
        {
            if (last is { } a)
                _new.Add((a, p));
            last = p;
        }

        if (at + count < _way.Count && last is { } end)
            _new.Add((end, _way[at + count]));
        double more = WayShortener.CornerCost * _sweep * (by.Length - count);
        if (at == 0 && _from is { } start)
            more += start.DistanceTo(by.Length > 0 ? by[0] : _way[count]) - start.DistanceTo(_way[0]);
        if (!Accept(more))
            return;
        _way.RemoveRange(at, count);
        _way.InsertRange(at, by);
        Keep();
    }

    private void ReversePart(int i)
    {
        int k = (int)(Uniform() * _way.Count);
        (i, k) = (Math.Min(i, k), Math.Max(i, k));
        if (k - i < 1 || k - i >= _way.Count - 1)
            return;
        _old.Clear();
        _new.Clear();
        double more = 0;
        if (i > 0)
        {
            _old.Add((_way[i - 1], _way[i]));
            _new.Add((_way[i - 1], _way[k]));
        }
        else if (_from is { } from)
            more = from.DistanceTo(_way[k]) - from.DistanceTo(_way[0]);

        if (k + 1 < _way.Count)
        {
            _old.Add((_way[k], _way[k + 1]));
            _new.Add((_way[i], _way[k + 1]));
        }

        if (!Accept(more))
            return;
        _way.Reverse(i, k - i + 1);
        Keep();
    }

    private void MovePart(int i)
    {
        int size = 1 + (int)(Uniform() * MaxMoved);
        int to = (int)(Uniform() * (_way.Count + 1));
        if (i + size > _way.Count || (to >= i && to <= i + size) || i == 0 || to == 0)
            return;
        bool isReversed = Uniform() < 0.5;
        _old.Clear();
        _new.Clear();
        (PlanePoint first, PlanePoint last) = (_way[i], _way[i + size - 1]);
        if (isReversed)
            (first, last) = (last, first);
        _old.Add((_way[i - 1], _way[i]));
        if (i + size < _way.Count)
        {
            _old.Add((_way[i + size - 1], _way[i + size]));
            _new.Add((_way[i - 1], _way[i + size]));
        }

        _new.Add((_way[to - 1], first));
        if (to < _way.Count)
        {
            _old.Add((_way[to - 1], _way[to]));
            _new.Add((last, _way[to]));
        }

        if (!Accept(0))
            return;
        List<PlanePoint> part = _way.GetRange(i, size);
        if (isReversed)
            part.Reverse();
        _way.RemoveRange(i, size);
        _way.InsertRange(to > i ? to - size : to, part);
        Keep();
    }

    // Whether the new legs may take the place of the old ones; they have it then.
    private bool Accept(double more)
    {
        foreach ((PlanePoint a, PlanePoint b) in _new)
            more += a.DistanceTo(b);
        foreach ((PlanePoint a, PlanePoint b) in _old)
            more -= a.DistanceTo(b);
        double limit = _threshold * Uniform();
        if (more - (_penalty * _samples.Uncovered) > limit)
            return false;
        int uncovered = _samples.MoreUncovered(_old, _new, (limit - more) / _penalty);
        if (more + (_penalty * uncovered) > limit || !AreFree())
            return false;
        Change(_new, 1);
        Change(_old, -1);
        _cost += more;
        return true;
    }

    private bool AreFree()
    {
        foreach ((PlanePoint a, PlanePoint b) in _new)
        {
            if (!_region.IsFree(a) || !_region.IsFree(b) || (!_region.IsConvex && !_region.IsFree(a, b)))
                return false;
        }

        return true;
    }

    private void Change(List<(PlanePoint A, PlanePoint B)> legs, int by)
    {
        foreach ((PlanePoint a, PlanePoint b) in legs)
            _samples.Change(a, b, by);
    }

    private void Keep()
    {
        if (_samples.Uncovered > 0 || !(_cost < _bestCost - 1e-6))
            return;
        _bestCost = _cost;
        _best = [.. _way];
    }
}
