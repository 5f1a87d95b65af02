using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>
/// The part of the ground that the map shows: north is up, and the drawing is <see cref="Width"/> units wide.
/// </summary>
internal sealed class MapFrame
{
    /// <summary>Units from left to right.</summary>
    public const double Width = 1000;

    private const double MarginMetres = 12;

    private readonly LocalNedFrame _frame;

    private MapFrame(LocalNedFrame frame, double west, double north, double unitsPerMetre, double height)
    {
        _frame = frame;
        (WestMetres, NorthMetres, UnitsPerMetre, Height) = (west, north, unitsPerMetre, height);
    }

    /// <summary>The left edge, metres east of home.</summary>
    public double WestMetres { get; }

    /// <summary>The upper edge, metres north of home.</summary>
    public double NorthMetres { get; }

    public double UnitsPerMetre { get; }

    /// <summary>Units from top to bottom.</summary>
    public double Height { get; }

    /// <returns>Null where there is nothing to show.</returns>
    public static MapFrame? Of(FlightSummary data) => Of([data]);

    /// <returns>One for all of them; null where there is nothing to show.</returns>
    public static MapFrame? Of(IReadOnlyCollection<FlightSummary> flights)
    {
        List<GeodeticPosition> places = flights.SelectMany(Places).ToList();
        if (places.Count == 0)
            return null;
        SearchPlan? plan = flights.Select(f => f.Record.Mission.Plan).FirstOrDefault(p => p is not null);
        var frame = LocalNedFrame.IgnoringGeoid(plan?.Home ?? places[0]);
        NedPosition[] points = places.Select(frame.ToNed).ToArray();
        double west = points.Min(p => p.East) - MarginMetres;
        double east = points.Max(p => p.East) + MarginMetres;
        double south = points.Min(p => p.North) - MarginMetres;
        double north = points.Max(p => p.North) + MarginMetres;

        // Neither a long thin strip nor a tower.
        Widen(ref west, ref east, (north - south) * 1.1);
        Widen(ref south, ref north, (east - west) * 0.45);
        double unitsPerMetre = Width / (east - west);
        return new MapFrame(frame, west, north, unitsPerMetre, (north - south) * unitsPerMetre);
    }

    /// <summary>Metres from home.</summary>
    public NedPosition ToNed(GeodeticPosition position) => _frame.ToNed(position);

    public (double X, double Y) ToMap(GeodeticPosition position) => ToMap(_frame.ToNed(position));

    public (double X, double Y) ToMap(NedPosition ned)
        => ((ned.East - WestMetres) * UnitsPerMetre, (NorthMetres - ned.North) * UnitsPerMetre);

    /// <summary>"x,y x,y ..." for SVG.</summary>
    public string Points(IEnumerable<GeodeticPosition> positions)
        => string.Join(" ", positions.Select(p => Point(ToMap(p))));

    public static string Point((double X, double Y) point)
        => FlightText.Number(point.X, "0.#") + "," + FlightText.Number(point.Y, "0.#");

    private static List<GeodeticPosition> Places(FlightSummary data)
    {
        var places = new List<GeodeticPosition>();
        if (data.Record.Mission.Plan is { } plan)
        {
            places.AddRange(plan.Area);
            places.AddRange(plan.Fence);
            places.Add(plan.Home);
        }

        places.AddRange(data.Record.Samples.Where(s => s.HasPosition).Select(s => s.Position));
        places.AddRange(data.Record.Tracks.Tracks.Select(t => t.Position));
        if (data.Mission?.Score is { } score)
            places.AddRange(score.Targets.Select(t => t.Position));
        return places;
    }

    private static void Widen(ref double low, ref double high, double minimum)
    {
        double missing = Math.Max(0, minimum - (high - low)) / 2;
        (low, high) = (low - missing, high + missing);
    }
}
