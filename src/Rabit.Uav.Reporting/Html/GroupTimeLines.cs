using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.Reporting.Html;

/// <summary>
/// Who did what over time: for each vehicle its phases and, below them, its share of the lanes or the target that it
/// validates; then height, area seen and radio of all of them in one chart each.
/// </summary>
internal sealed class GroupTimeLines(PageWriter page, GroupFlightSummary data)
{
    private const double ChartHeight = 84;
    private const double Gap = 12;
    private const int MaxPoints = 700;
    private const double RadioMeanSeconds = 5;

    private TimeAxis _axis = null!; // made before it is drawn
    private double _y = 22;

    public void Write()
    {
        FlightSample[] all = data.Vehicles.SelectMany(v => v.Flight.Record.Samples).ToArray();
        if (all.Length < 2)
            return;
        double start = data.Vehicles.Where(v => v.Flight.Record.Samples.Count > 0)
            .Min(v => Time(v, v.Flight.Record.Samples[0].Time));
        double end = Math.Max(start + 1, data.Vehicles.Max(EndOf));
        _axis = new TimeAxis(page, start, end);
        int charts = data.Vehicles.Any(v => v.Radio?.Samples.Count > 1) ? 3 : 2;
        double height = _y + (data.Vehicles.Count * ((2 * TimeAxis.BandHeight) + Gap)) + (charts * (ChartHeight + Gap));
        page.Open("section").Element("h2", "Roles over time").Open("figure", "class", "card times");
        page.Open("div", "class", "wide").Open(
            "svg", "viewBox", $"0 0 1000 {N(height)}", "id", "times", "role", "img", "aria-label",
            "What each vehicle did over time");
        _axis.Write(height);
        for (int i = 0; i < data.Vehicles.Count; i++)
            WriteVehicle(i);
        WriteChart("height", "m", 10, v => Heights(v));
        WriteChart("area seen", "%", 100, v => Coverages(v));
        if (charts == 3)
            WriteChart("radio", "kbit/s", 1, v => RadioRates(v));
        page.Close().Close();
        page.Element(
            "figcaption",
            "Minutes and seconds since the start of the run. Upper band: the phase of the mission. Lower band: the "
                + "lanes that are its share, or the target that it validates or follows for the group; the thin line "
                + "marks who divides the lanes.",
            "class", "readout");
        page.Close().Close();
    }

    private void WriteVehicle(int index)
    {
        GroupVehicleSummary vehicle = data.Vehicles[index];
        _axis.WriteLabel(
            GroupColours.Name(vehicle.SystemId), _y, 2 * TimeAxis.BandHeight, null,
            "name " + GroupColours.Class(index));
        IReadOnlyList<FlightSample> samples = vehicle.Flight.Record.Samples;
        foreach ((double from, double to, FlightSample sample) in Bands(
            samples, s => (int)s.Phase, s => Time(vehicle, s.Time), EndOf(vehicle)))
            _axis.WriteBand("band " + PhaseStyle.Class(sample.Phase), FlightText.Phase(sample.Phase), _y, from, to);
        _y += TimeAxis.BandHeight;
        IReadOnlyList<GroupRole> roles = vehicle.Flight.Record.GroupRoles;
        foreach ((double from, double to, GroupRole role) in Bands(
            roles, r => r with { Time = default, DividesLanes = false }, r => Time(vehicle, r.Time), EndOf(vehicle)))
        {
            string text = GroupRoleText.Of(role);
            if (text.Length > 0)
                _axis.WriteBand(role.ValidatedFinder != 0 ? "band p-revisit" : "band r-lanes", text, _y, from, to);
        }

        foreach ((double from, double to, GroupRole role) in Bands(
            roles, r => r.DividesLanes, r => Time(vehicle, r.Time), EndOf(vehicle)))
        {
            if (role.DividesLanes)
                _axis.WriteBand("divides", _y + TimeAxis.BandHeight, from, to, 3);
        }

        _y += TimeAxis.BandHeight + Gap;
    }

    private void WriteChart(
        string name, string unit, double minimum, Func<GroupVehicleSummary, IEnumerable<(double T, double Value)>> of)
    {
        (double T, double Value)[][] lines =
            [.. data.Vehicles.Select(v => of(v).Where(p => IsFinite(p.Value)).ToArray())];
        double top = TimeAxis.RoundUp(lines.SelectMany(l => l).Select(p => p.Value).Append(minimum).Max());
        _axis.WriteLabel(name, _y, ChartHeight, $"0 to {FlightText.Number(top)} {unit}");
        _axis.WriteFrame(_y, ChartHeight);
        for (int i = 0; i < lines.Length; i++)
        {
            if (lines[i].Length < 2)
                continue;
            IEnumerable<string> points = lines[i].Select(p => MapFrame.Point(
                (_axis.X(p.T), _y + ChartHeight - (Math.Max(0, Math.Min(top, p.Value)) / top * ChartHeight))));
            page.Empty(
                "polyline", "class", "line " + GroupColours.Class(i), "points", string.Join(" ", points));
        }

        _y += ChartHeight + Gap;
    }

    private static IEnumerable<(double T, double Value)> Heights(GroupVehicleSummary vehicle)
        => Thinned(vehicle).Where(s => s.HasPosition).Select(s => (Time(vehicle, s.Time), s.HeightAboveHomeMetres));

    private static IEnumerable<(double T, double Value)> Coverages(GroupVehicleSummary vehicle)
        => Thinned(vehicle).Select(s => (Time(vehicle, s.Time), s.Coverage * 100));

    private static IEnumerable<(double T, double Value)> RadioRates(GroupVehicleSummary vehicle)
    {
        IReadOnlyList<RadioSample> samples = vehicle.Radio?.Samples ?? [];
        int last = 0;
        for (int i = 1; i < samples.Count; i++)
        {
            double seconds = (samples[i].Time - samples[last].Time).TotalSeconds;
            if (seconds < RadioMeanSeconds)
                continue;
            yield return (
                samples[i].Time.TotalSeconds, (samples[i].BytesSent - samples[last].BytesSent) * 8 / 1000.0 / seconds);
            last = i;
        }
    }

    private static IEnumerable<FlightSample> Thinned(GroupVehicleSummary vehicle)
    {
        IReadOnlyList<FlightSample> samples = vehicle.Flight.Record.Samples;
        int stride = Math.Max(1, samples.Count / MaxPoints);
        return samples.Where((_, i) => i % stride == 0 || i == samples.Count - 1);
    }

    // Neighbours of one kind together.
    private static IEnumerable<(double From, double To, T Value)> Bands<T, TKind>(
        IReadOnlyList<T> values, Func<T, TKind> kind, Func<T, double> time, double end)
    {
        int first = 0;
        for (int i = 1; i <= values.Count; i++)
        {
            if (i < values.Count && EqualityComparer<TKind>.Default.Equals(kind(values[i]), kind(values[first])))
                continue;
            yield return (time(values[first]), i < values.Count ? time(values[i]) : end, values[first]);
            first = i;
        }
    }

    private static double Time(GroupVehicleSummary vehicle, TimeSpan time)
        => (vehicle.ClockOffset + time).TotalSeconds;

    private static double EndOf(GroupVehicleSummary vehicle)
        => vehicle.Flight.Record.Samples is { Count: > 0 } samples ? Time(vehicle, samples[samples.Count - 1].Time) : 0;

    private static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);

    private static string N(double value) => FlightText.Number(value, "0.##");
}
