using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Order and direction in which lanes are flown: nearest neighbours first, then 2-opt and Or-opt moves while they make
/// the way shorter. Deterministic; the number of passes is bounded.
/// </summary>
internal sealed class LaneOrder
{
    private const int MaxPasses = 60;
    private const int MaxStarts = 6;
    private const int MaxMoved = 3;

    // More are flown to and fro as they are.
    private const int MaxOptimised = 500;

    private readonly double[,] _transfer;
    private readonly double[] _fromStart;
    private readonly int _count;
    private int[] _ends = [];

    // Ends 2i and 2i + 1 are those of lane i. A way is the list of the ends at which its lanes begin.
    private LaneOrder(SearchRegion region, IReadOnlyList<(PlanePoint A, PlanePoint B)> lanes, PlanePoint? from)
    {
        _count = lanes.Count;
        PlanePoint[] ends = lanes.SelectMany(l => new[] { l.A, l.B }).ToArray();
        int[][] nodes = ends.Select(e => region.NodesFrom(e)).ToArray();
        _transfer = new double[ends.Length, ends.Length];
        for (int i = 0; i < ends.Length; i++)
        {
            for (int j = i + 1; j < ends.Length; j++)
            {
                _transfer[i, j] = _transfer[j, i] = region.IsConvex
                    ? ends[i].DistanceTo(ends[j]) : region.Distance(ends[i], nodes[i], ends[j], nodes[j]);
            }
        }

        _fromStart = ends.Select(e => from is { } p ? p.DistanceTo(e) : 0).ToArray();
    }

    /// <summary>
    /// The lanes in order, and whether each is flown from its second end; null where a lane cannot be reached.
    /// </summary>
    /// <param name="region">Where the transfers run.</param>
    /// <param name="lanes">Their ends.</param>
    /// <param name="from">Where the vehicle is; null where the way may begin at any lane.</param>
    public static List<(int Lane, bool IsReversed)>? Find(
        SearchRegion region, IReadOnlyList<(PlanePoint A, PlanePoint B)> lanes, PlanePoint? from)
    {
        if (lanes.Count == 0)
            return [];
        if (lanes.Count > MaxOptimised)
            return Enumerable.Range(0, lanes.Count).Select(i => (i, i % 2 == 1)).ToList();
        var order = new LaneOrder(region, lanes, from);
        int[] starts = from is null ? order.Extremes(lanes) : [order.NearestToStart()];
        int[]? best = null;
        double least = double.PositiveInfinity;
        foreach (int start in starts)
        {
            order._ends = order.NearestNeighbours(start);
            order.Improve();
            double length = order.Length();
            if (length < least)
                (best, least) = ((int[])order._ends.Clone(), length);
        }

        return best?.Select(e => (e / 2, e % 2 == 1)).ToList();
    }

    private double Length()
    {
        double sum = _fromStart[_ends[0]];
        for (int i = 0; i + 1 < _count; i++)
            sum += _transfer[_ends[i] ^ 1, _ends[i + 1]];
        return sum;
    }

    private int NearestToStart()
        => Enumerable.Range(0, 2 * _count).OrderBy(e => _fromStart[e]).First();

    private int[] Extremes(IReadOnlyList<(PlanePoint A, PlanePoint B)> lanes)
    {
        int last = (2 * _count) - 1;
        PlanePoint At(int end) => end % 2 == 0 ? lanes[end / 2].A : lanes[end / 2].B;
        int[] all = Enumerable.Range(0, last + 1).ToArray();
        return new[]
        {
            0, 1, last - 1, last, all.OrderBy(e => At(e).North).First(), all.OrderBy(e => At(e).East).First(),
        }.Distinct().Take(MaxStarts).ToArray();
    }

    private int[] NearestNeighbours(int start)
    {
        var way = new int[_count];
        var isUsed = new bool[_count];
        way[0] = start;
        isUsed[start / 2] = true;
        for (int i = 1; i < _count; i++)
        {
            int at = way[i - 1] ^ 1;
            int best = -1;
            for (int e = 0; e < 2 * _count; e++)
            {
                if (!isUsed[e / 2] && (best < 0 || _transfer[at, e] < _transfer[at, best]))
                    best = e;
            }

            way[i] = best;
            isUsed[best / 2] = true;
        }

        return way;
    }

    private void Improve()
    {
        for (int pass = 0; pass < MaxPasses; pass++)
        {
            if (!ReversePart() & !MovePart())
                return;
        }
    }

    // Transfer into position i, after whichever end the way leaves before it.
    private double Into(int before, int end) => before < 0 ? _fromStart[end] : _transfer[before ^ 1, end];

    private double OutOf(int end, int next) => next < 0 ? 0 : _transfer[end ^ 1, next];

    private int At(int i) => i >= 0 && i < _count ? _ends[i] : -1;

    // 2-opt: positions i to k in the other direction.
    private bool ReversePart()
    {
        bool isBetter = false;
        for (int i = 0; i < _count; i++)
        {
            for (int k = i; k < _count; k++)
            {
                double now = Into(At(i - 1), _ends[i]) + OutOf(_ends[k], At(k + 1));
                double then = Into(At(i - 1), _ends[k] ^ 1) + OutOf(_ends[i] ^ 1, At(k + 1));
                if (!(then < now - 1e-6))
                    continue;
                Array.Reverse(_ends, i, k - i + 1);
                for (int j = i; j <= k; j++)
                    _ends[j] ^= 1;
                isBetter = true;
            }
        }

        return isBetter;
    }

    // Or-opt: up to three lanes to another place, in either direction.
    private bool MovePart()
    {
        bool isBetter = false;
        for (int size = 1; size <= MaxMoved; size++)
        {
            for (int i = 0; i + size <= _count; i++)
                isBetter |= TryMove(i, size);
        }

        return isBetter;
    }

    private bool TryMove(int i, int size)
    {
        int first = _ends[i];
        int last = _ends[i + size - 1];
        int before = At(i - 1);
        int after = At(i + size);
        double bridge = after < 0 ? 0 : Into(before, after);
        double gain = Into(before, first) + OutOf(last, after) - bridge;
        double best = 1e-6;
        int bestAt = -1;
        bool isReversed = false;
        for (int j = 0; j <= _count; j++)
        {
            if (j >= i && j <= i + size)
                continue;
            int p = At(j - 1);
            int n = At(j);
            double old = n < 0 ? 0 : Into(p, n);
            double forwards = gain + old - Into(p, first) - OutOf(last, n);
            double backwards = gain + old - Into(p, last ^ 1) - OutOf(first ^ 1, n);
            if (Math.Max(forwards, backwards) > best)
                (best, bestAt, isReversed) = (Math.Max(forwards, backwards), j, backwards > forwards);
        }

        if (bestAt < 0)
            return false;
        Move(i, size, bestAt, isReversed);
        return true;
    }

    private void Move(int i, int size, int to, bool isReversed)
    {
        var rest = _ends.ToList();
        List<int> part = rest.GetRange(i, size);
        rest.RemoveRange(i, size);
        if (isReversed)
            part = Enumerable.Reverse(part).Select(e => e ^ 1).ToList();
        rest.InsertRange(to > i ? to - size : to, part);
        _ends = rest.ToArray();
    }
}
