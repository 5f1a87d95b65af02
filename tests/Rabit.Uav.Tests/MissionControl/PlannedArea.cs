using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Tests.Shared;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>An area and the way that is planned over it.</summary>
internal sealed class PlannedArea
{
    public const int Samples = 4000;

    private const double ClearanceMetres = 10;

    private readonly IReadOnlyList<PlanePolygon> _holes;
    private readonly Lazy<SearchWay?> _way;

    public PlannedArea(
        int id, string kind, PlanePolygon outer, IReadOnlyList<PlanePolygon> holes, double sweep,
        bool isQuick = false)
    {
        (Id, Kind, Outer, _holes, Sweep) = (id, kind, outer, holes, sweep);
        _way = new Lazy<SearchWay?>(
            () => SearchPlanner.Plan(outer, holes, ClearanceMetres, sweep, heading: null, from: null, isQuick));
    }

    public int Id { get; }

    public string Kind { get; }

    public PlanePolygon Outer { get; }

    public double Sweep { get; }

    public SearchWay? Way => _way.Value;

    /// <summary>
    /// Length of the way over what no way can be shorter than; of a sliver that is also its length but for a sweep.
    /// </summary>
    public double Ratio => Way!.Length / Math.Max(
        (Outer.Area - _holes.Sum(h => h.Area)) / Sweep,
        Kind == "sliver" ? Outer.Corners.Max(a => Outer.Corners.Max(b => a.DistanceTo(b))) - Sweep : 0);

    public static IEnumerable<PlannedArea> All(bool isQuick = false)
    {
        using JsonDocument data = TestData.Autonomy("search-areas.json");
        foreach (JsonElement e in data.RootElement.EnumerateArray())
        {
            yield return new PlannedArea(
                e.GetProperty("id").GetInt32(), e.GetProperty("kind").GetString()!, Ring(e.GetProperty("outer_ne")),
                e.GetProperty("holes_ne").EnumerateArray().Select(Ring).ToArray(),
                e.GetProperty("sweep_width_m").GetDouble(), isQuick);
        }
    }

    /// <summary>How many of the samples are not covered, and how far the farthest is, in half sweeps.</summary>
    public (int Count, double Farthest) Uncovered(SeededNumbers random)
    {
        double north = Outer.Corners.Max(c => c.North);
        double south = Outer.Corners.Min(c => c.North);
        double east = Outer.Corners.Max(c => c.East);
        double west = Outer.Corners.Min(c => c.East);
        (int count, double farthest) = (0, 0);
        for (int samples = 0; samples < Samples;)
        {
            var p = new PlanePoint(random.Uniform(south, north), random.Uniform(west, east));
            if (!Outer.Contains(p) || _holes.Any(h => h.Contains(p)))
                continue;
            samples++;
            double distance = Legs().Min(l => PlanePolygon.DistanceToSegment(p, l.Start, l.End)) / (Sweep / 2);
            farthest = Math.Max(farthest, distance);
            count += distance > 1 ? 1 : 0;
        }

        return (count, farthest);
    }

    public double HoleDistance()
        => _holes.Count == 0 ? double.PositiveInfinity
            : _holes.Min(h => Legs().Min(l => h.DistanceTo(l.Start, l.End)));

    /// <summary>How deep in the area the way is where it is least so; below zero outside.</summary>
    public double MinDepth() => Legs().Min(l => Enumerable.Range(0, 21)
        .Min(k => Outer.SignedDistance(l.Start + (k / 20.0 * (l.End - l.Start)))));

    private static PlanePolygon Ring(JsonElement ring)
        => new(ring.EnumerateArray().Select(c => new PlanePoint(c[0].GetDouble(), c[1].GetDouble())));

    private IEnumerable<LaneSegment> Legs()
        => Enumerable.Range(0, Way!.Corners.Count - 1).Select(i => new LaneSegment(Way.Corners[i], Way.Corners[i + 1]));
}
