using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Shortens a way without uncovering anything: its corners are left out or moved as long as that makes it shorter
/// (pattern search). The effort is bounded.
/// </summary>
internal sealed class WayShortener
{
    private const int MaxPasses = 12;
    private const int Directions = 12;

    // In parts of the spacing: each corner is a stop.
    public const double CornerCost = 0.05;
    private const double MinGain = 0.005;

    private readonly SearchRegion _region;
    private readonly CoverageSamples _samples;
    private readonly double _spacing;
    private readonly long _maxEffort;
    private readonly List<PlanePoint> _way;

    private WayShortener(
        SearchRegion region, CoverageSamples samples, double spacing, List<PlanePoint> way, long maxEffort)
    {
        (_region, _samples, _spacing, _way) = (region, samples, spacing, way);
        _maxEffort = samples.Effort + maxEffort;
        samples.Clear();
        for (int i = 0; i + 1 < way.Count; i++)
            samples.Change(way[i], way[i + 1], 1);
        if (way.Count == 1)
            samples.Change(way[0], way[0], 1);
    }

    private bool IsExhausted => _samples.Effort > _maxEffort;

    /// <summary>Shortens a way that covers all samples.</summary>
    public static List<PlanePoint> Shorten(
        SearchRegion region, CoverageSamples samples, double spacing, List<PlanePoint> way, long maxEffort)
    {
        var shortener = new WayShortener(region, samples, spacing, way, maxEffort);
        for (int pass = 0; pass < MaxPasses && !shortener.IsExhausted; pass++)
        {
            bool isBetter = shortener.LeaveOut();
            for (double part = 1; part > 0.05; part /= 2)
                isBetter |= shortener.Move(part * spacing);
            if (!isBetter)
                break;
        }

        return shortener._way;
    }

    private bool LeaveOut()
    {
        bool isBetter = false;
        for (int size = 3; size >= 1; size--)
        {
            for (int i = _way.Count - size; i >= 0 && !IsExhausted; i--)
            {
                if (_way.Count > size + 1)
                    isBetter |= TryReplace(i, size, []);
            }
        }

        return isBetter;
    }

    private bool Move(double step)
    {
        bool isBetter = false;
        for (int i = 0; i < _way.Count && !IsExhausted; i++)
        {
            foreach (PlanePoint by in Moves(i, step))
            {
                if (TryReplace(i, 1, [_way[i] + by])
                    || (i + 1 < _way.Count && TryReplace(i, 2, [_way[i] + by, _way[i + 1] + by])))
                {
                    isBetter = true;
                    break;
                }
            }
        }

        return isBetter;
    }

    private IEnumerable<PlanePoint> Moves(int i, double step)
    {
        PlanePoint at = _way[i];
        if (i > 0 && _way[i - 1].DistanceTo(at) > step)
            yield return step / _way[i - 1].DistanceTo(at) * (_way[i - 1] - at);
        if (i + 1 < _way.Count && _way[i + 1].DistanceTo(at) > step)
            yield return step / _way[i + 1].DistanceTo(at) * (_way[i + 1] - at);
        for (int k = 0; k < Directions; k++)
            yield return step * PlanePoint.Towards(2 * Math.PI * k / Directions);
    }

    private bool TryReplace(int at, int count, PlanePoint[] by)
    {
        int from = Math.Max(0, at - 1);
        int to = Math.Min(_way.Count - 1, at + count);
        List<PlanePoint> old = _way.GetRange(from, to - from + 1);
        var now = new List<PlanePoint>(by);
        if (at > 0)
            now.Insert(0, _way[at - 1]);
        if (at + count < _way.Count)
            now.Add(_way[at + count]);
        double gain = Length(old) - Length(now) + (CornerCost * _spacing * (old.Count - now.Count));
        if (!(gain > MinGain * _spacing) || !_samples.CanReplace(old, now) || !IsFree(now))
            return false;
        Change(now, 1);
        Change(old, -1);
        _way.RemoveRange(from, old.Count);
        _way.InsertRange(from, now);
        return true;
    }

    private bool IsFree(List<PlanePoint> way)
    {
        for (int i = 0; i < way.Count; i++)
        {
            if (!_region.IsFree(way[i]) || (i > 0 && !_region.IsFree(way[i - 1], way[i])))
                return false;
        }

        return true;
    }

    private void Change(List<PlanePoint> way, int by)
    {
        // The end of a longer way belongs to the legs that it keeps.
        if (way.Count == 1 && _way.Count == 1)
            _samples.Change(way[0], way[0], by);
        for (int i = 0; i + 1 < way.Count; i++)
            _samples.Change(way[i], way[i + 1], by);
    }

    /// <summary>Length of a way, with the straight way to its start and what its corners cost, metres.</summary>
    public static double Cost(List<PlanePoint> way, double spacing, PlanePoint? from)
        => Length(way) + (from is { } start ? start.DistanceTo(way[0]) : 0) + (CornerCost * spacing * way.Count);

    /// <summary>Length of a way, metres.</summary>
    public static double Length(List<PlanePoint> way)
    {
        double sum = 0;
        for (int i = 0; i + 1 < way.Count; i++)
            sum += way[i].DistanceTo(way[i + 1]);
        return sum;
    }
}
