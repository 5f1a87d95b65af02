using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>The map of a group: what all have seen, path and landing place of each vehicle, the targets.</summary>
internal sealed class GroupMap(PageWriter page, GroupFlightSummary data, MapFrame frame)
{
    private const int MaxPathPoints = 2_000;

    private readonly MapParts _parts = new(page, frame);

    public void Write()
    {
        SearchPlan? plan = data.Vehicles.Select(v => v.Flight.Record.Mission.Plan).FirstOrDefault(p => p is not null);
        CameraObservation[] seen = data.Vehicles.SelectMany(v => v.Flight.Record.Observations).ToArray();
        page.Open("figure", "class", "card map");
        page.Open(
            "svg", "viewBox", $"0 0 {FlightText.Number(MapFrame.Width)} {FlightText.Number(frame.Height, "0.#")}",
            "role", "img", "aria-label", "Map of the group, north is up", "id", "map");
        _parts.WriteSeenGround(seen);
        _parts.WritePlan(plan);
        for (int i = 0; i < data.Vehicles.Count; i++)
            WritePath(i);
        _parts.WriteTargets(data.BestInformed.Flight.Record.Tracks, data.Score);
        for (int i = 0; i < data.Vehicles.Count; i++)
            WriteStart(i);
        _parts.WriteScale();
        page.Close();
        page.Open("figcaption", "class", "legend");
        for (int i = 0; i < data.Vehicles.Count; i++)
            _parts.WriteKey("key line " + GroupColours.Class(i), GroupColours.Name(data.Vehicles[i].SystemId));
        _parts.WriteKeys(
            seen.Length > 0, plan, data.Score is not null,
            "lanes of the plan; what a vehicle sees from beside is not flown");
        page.Close().Close();
    }

    private void WritePath(int vehicle)
    {
        FlightSample[] samples = FlownBy(vehicle);
        int stride = Math.Max(1, samples.Length / MaxPathPoints);
        IEnumerable<GeodeticPosition> path = samples
            .Where((_, i) => i % stride == 0 || i == samples.Length - 1).Select(s => s.Position);
        if (samples.Length > 1)
            page.Empty("polyline", "class", "path " + GroupColours.Class(vehicle), "points", frame.Points(path));
    }

    // Where it took off, and lands.
    private void WriteStart(int vehicle)
    {
        if (FlownBy(vehicle) is not { Length: > 0 } samples)
            return;
        (double x, double y) = frame.ToMap(samples[0].Position);
        page.Open("g", "class", "home start " + GroupColours.Class(vehicle));
        page.Element("title", GroupColours.Name(data.Vehicles[vehicle].SystemId) + " took off here");
        page.Empty("circle", "cx", N(x), "cy", N(y), "r", "11");
        page.Element(
            "text", FlightText.Number((long)data.Vehicles[vehicle].SystemId), "x", N(x), "y", N(y + 5.5),
            "text-anchor", "middle");
        page.Close();
    }

    private FlightSample[] FlownBy(int vehicle)
        => data.Vehicles[vehicle].Flight.Record.Samples.Where(s => s.HasPosition).ToArray();

    private static string N(double value) => FlightText.Number(value, "0.#");
}
