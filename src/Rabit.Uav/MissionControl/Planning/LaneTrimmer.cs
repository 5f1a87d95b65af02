using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Shortens a search without uncovering anything: lanes end where the ground before the border is covered without them,
/// by their own width, by their neighbours and by the transfers; lanes and corners that nothing needs are left out.
/// </summary>
internal sealed class LaneTrimmer
{
    private const int MaxPasses = 6;

    private readonly SearchRegion _region;
    private readonly CoverageSamples _samples;
    private readonly double _spacing;
    private readonly List<List<PlanePoint>> _lanes;
    private readonly List<List<PlanePoint>> _transfers = [];
    private bool _isBetter;

    private LaneTrimmer(
        SearchRegion region, CoverageSamples samples, double spacing, List<List<PlanePoint>> lanes)
    {
        (_region, _samples, _spacing, _lanes) = (region, samples, spacing, lanes);
        samples.Clear();
        foreach (List<PlanePoint> lane in lanes)
            Change(lane, 1);
        for (int i = 0; i + 1 < lanes.Count; i++)
        {
            _transfers.Add(Transfer(lanes[i], lanes[i + 1]) ?? [lanes[i][lanes[i].Count - 1], lanes[i + 1][0]]);
            Change(_transfers[i], 1);
        }
    }

    /// <summary>Shortens lanes, which are in order and in their directions.</summary>
    /// <returns>The corners of the whole way.</returns>
    public static List<PlanePoint> Trim(
        SearchRegion region, CoverageSamples samples, double spacing, List<List<PlanePoint>> lanes)
    {
        var trimmer = new LaneTrimmer(region, samples, spacing, lanes);
        for (int pass = 0; pass < MaxPasses; pass++)
        {
            trimmer._isBetter = false;
            trimmer.Pass();
            if (!trimmer._isBetter)
                break;
        }

        return trimmer.Way();
    }

    /// <summary>The corners of the way along lanes, which are in order and in their directions.</summary>
    public static List<PlanePoint> Join(SearchRegion region, List<List<PlanePoint>> lanes)
    {
        var way = new List<PlanePoint>(lanes[0]);
        for (int i = 1; i < lanes.Count; i++)
        {
            way.AddRange(region.PathBetween(way[way.Count - 1], lanes[i][0]) ?? []);
            way.AddRange(lanes[i]);
        }

        return way;
    }

    private void Pass()
    {
        for (int i = _lanes.Count - 1; i >= 0; i--)
            TryRemove(i);
        for (double part = 4; part > 0.03; part /= 2)
        {
            for (int i = 0; i < _lanes.Count; i++)
            {
                if (i + 1 < _lanes.Count)
                    TryTrim(i, part, i + 1, part);
                TryTrim(i, part, -1, 0);
                TryTrim(-1, 0, i, part);
                TryMove(i, part);
            }
        }
    }

    // Without the whole lane.
    private void TryRemove(int i)
    {
        if (_lanes.Count < 2)
            return;
        List<PlanePoint> lane = _lanes[i];
        Change(lane, -1);
        if (_samples.Uncovered > 0 && !IsBridged(i))
        {
            Change(lane, 1);
            return;
        }

        var old = new List<List<PlanePoint>>();
        if (i > 0)
            old.Add(_transfers[i - 1]);
        if (i < _transfers.Count)
            old.Add(_transfers[i]);
        bool needsBridge = i > 0 && i + 1 < _lanes.Count;
        List<PlanePoint>? bridge = needsBridge ? Transfer(_lanes[i - 1], _lanes[i + 1]) : null;
        if (needsBridge == (bridge is not null) && Replace(old, bridge is null ? [] : [bridge]))
        {
            _lanes.RemoveAt(i);
            _transfers.RemoveRange(Math.Max(0, i - 1), old.Count);
            if (bridge is not null)
                _transfers.Insert(i - 1, bridge);
            _isBetter = true;
        }
        else
            Change(lane, 1);
    }

    // Only a short lane may be replaced by the transfer past it.
    private bool IsBridged(int i) => i > 0 && i + 1 < _lanes.Count && Length(_lanes[i]) < 2 * _spacing;

    // The end of one lane and the start of another, which follow each other where both are given.
    private void TryTrim(int end, double endPart, int start, double startPart)
    {
        List<PlanePoint>? before = end >= 0 ? _lanes[end] : null;
        List<PlanePoint>? after = start >= 0 ? _lanes[start] : null;
        List<PlanePoint>? shortBefore = before is null ? null : Reversed(Cut(Reversed(before), endPart * _spacing));
        List<PlanePoint>? shortAfter = after is null ? null : Cut(after, startPart * _spacing);
        if ((before is not null && shortBefore is null) || (after is not null && shortAfter is null))
            return;
        int transfer = end >= 0 ? end : start - 1;
        bool hasTransfer = transfer >= 0 && transfer < _transfers.Count;
        List<PlanePoint> left = shortBefore ?? (hasTransfer ? _lanes[transfer] : []);
        List<PlanePoint> right = shortAfter ?? (hasTransfer ? _lanes[transfer + 1] : []);
        List<PlanePoint>? moved = hasTransfer ? Transfer(left, right) : null;
        if (hasTransfer && moved is null)
            return;
        double old = (before is null ? 0 : Length(before)) + (after is null ? 0 : Length(after))
            + (hasTransfer ? Length(_transfers[transfer]) : 0);
        double now = (shortBefore is null ? 0 : Length(shortBefore)) + (shortAfter is null ? 0 : Length(shortAfter))
            + (moved is null ? 0 : Length(moved));
        if (!(now < old - 1e-3))
            return;
        CutOff(before is null ? null : Reversed(before), shortBefore is null ? null : Reversed(shortBefore), -1);
        CutOff(after, shortAfter, -1);
        if (!Replace(hasTransfer ? [_transfers[transfer]] : [], moved is null ? [] : [moved]))
        {
            CutOff(after, shortAfter, 1);
            CutOff(before is null ? null : Reversed(before), shortBefore is null ? null : Reversed(shortBefore), 1);
            return;
        }

        if (shortBefore is not null)
            _lanes[end] = shortBefore;
        if (shortAfter is not null)
            _lanes[start] = shortAfter;
        if (moved is not null)
            _transfers[transfer] = moved;
        _isBetter = true;
    }

    // A lane that is only a place, towards the way past it.
    private void TryMove(int i, double part)
    {
        if (_lanes[i].Count > 1 || i == 0 || i + 1 >= _lanes.Count || part > 1)
            return;
        PlanePoint at = _lanes[i][0];
        List<PlanePoint> before = _transfers[i - 1];
        List<PlanePoint> after = _transfers[i];
        PlanePoint way = (0.5 * (before[before.Count - 2] + after[1])) - at;
        double step = Math.Min(part * _spacing, way.Length);
        if (step < 1e-3)
            return;
        var moved = new List<PlanePoint> { at + (step / way.Length * way) };
        if (!_region.IsFree(moved[0]))
            return;
        List<PlanePoint>? newBefore = Transfer(_lanes[i - 1], moved);
        List<PlanePoint>? newAfter = Transfer(moved, _lanes[i + 1]);
        if (newBefore is null || newAfter is null
            || !(Length(newBefore) + Length(newAfter) < Length(before) + Length(after) - 1e-3)
            || !Replace([_lanes[i], before, after], [moved, newBefore, newAfter]))
            return;
        (_lanes[i], _transfers[i - 1], _transfers[i]) = (moved, newBefore, newAfter);
        _isBetter = true;
    }

    private bool Replace(List<List<PlanePoint>> old, List<List<PlanePoint>> by)
    {
        foreach (List<PlanePoint> way in by)
            Change(way, 1);
        foreach (List<PlanePoint> way in old)
            Change(way, -1);
        if (_samples.Uncovered == 0)
            return true;
        foreach (List<PlanePoint> way in old)
            Change(way, 1);
        foreach (List<PlanePoint> way in by)
            Change(way, -1);
        return false;
    }

    // Null where there is no path.
    private List<PlanePoint>? Transfer(List<PlanePoint> from, List<PlanePoint> to)
    {
        PlanePoint a = from[from.Count - 1];
        PlanePoint b = to[0];
        if (_region.PathBetween(a, b) is not { } path)
            return null;
        path.Insert(0, a);
        path.Add(b);
        return path;
    }

    private void Change(List<PlanePoint> way, int by)
    {
        if (way.Count == 1)
            _samples.Change(way[0], way[0], by);
        for (int i = 0; i + 1 < way.Count; i++)
            _samples.Change(way[i], way[i + 1], by);
    }

    // What a lane covers with its cut-off start only.
    private void CutOff(List<PlanePoint>? lane, List<PlanePoint>? rest, int by)
    {
        if (lane is null || rest is null)
            return;
        int cut = rest.Count == 1 ? lane.Count - 1 : lane.Count - rest.Count;
        for (int i = 0; i < cut; i++)
            _samples.Change(lane[i], lane[i + 1], by);
        if (rest.Count > 1)
            _samples.Change(rest[0], lane[cut], by, rest[1]);
        else if (lane.Count > 1)
            _samples.Change(rest[0], rest[0], -by);
    }

    // A lane without the metres at its start; a place where nothing is left; null where it is one already.
    private static List<PlanePoint>? Cut(List<PlanePoint> lane, double metres)
    {
        if (lane.Count == 1)
            return null;
        for (int i = 0; i + 1 < lane.Count; i++)
        {
            double length = lane[i].DistanceTo(lane[i + 1]);
            if (metres < length - 1e-6)
            {
                List<PlanePoint> rest = lane.GetRange(i, lane.Count - i);
                rest[0] = lane[i] + (metres / length * (lane[i + 1] - lane[i]));
                return rest;
            }

            metres -= length;
        }

        return [lane[lane.Count - 1]];
    }

    private static List<PlanePoint> Reversed(List<PlanePoint>? lane)
        => lane is null ? null! : Enumerable.Reverse(lane).ToList();

    private static double Length(List<PlanePoint> way)
    {
        double sum = 0;
        for (int i = 0; i + 1 < way.Count; i++)
            sum += way[i].DistanceTo(way[i + 1]);
        return sum;
    }

    private List<PlanePoint> Way()
    {
        var way = new List<PlanePoint>();
        for (int i = 0; i < _lanes.Count; i++)
        {
            way.AddRange(_lanes[i]);
            if (i < _transfers.Count)
                way.AddRange(_transfers[i].GetRange(1, _transfers[i].Count - 2));
        }

        return way;
    }
}
