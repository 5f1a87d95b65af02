using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Html;

/// <summary>
/// How it went over time: phases, height, speed, battery, coverage, health, and what each manager did.
/// </summary>
internal sealed class ReportTimeLines(PageWriter page, FlightSummary data)
{
    private const double ChartHeight = 58;
    private const double BandHeight = TimeAxis.BandHeight;
    private const double Gap = 12;
    private const int MaxPoints = 700;
    private const int MaxBins = 240;

    private readonly IReadOnlyList<FlightSample> _samples = data.Record.Samples;
    private TimeAxis _axis = null!; // made before it is drawn
    private double _y = 22;

    public void Write()
    {
        if (_samples.Count < 2)
            return;
        double start = _samples[0].Time.TotalSeconds;
        double end = Math.Max(start + 1, _samples[_samples.Count - 1].Time.TotalSeconds);
        _axis = new TimeAxis(page, start, end);
        double height = _y + (2 * (BandHeight + Gap)) + (5 * (ChartHeight + Gap)) + 34
            + (data.Record.Managers.Count * BandHeight) + 8;
        page.Open("section").Element("h2", "Time lines").Open("figure", "class", "card times");
        page.Open("div", "class", "wide").Open(
            "svg", "viewBox", $"0 0 1000 {N(height)}", "id", "times", "role", "img", "aria-label",
            "Time lines of the flight",
            "data-left", N(TimeAxis.Left), "data-right", N(TimeAxis.Right),
            "data-start", N(start), "data-end", N(end));
        _axis.Write(height);
        WritePhases();
        WriteChart("height", "m", s => s.HasPosition ? s.HeightAboveHomeMetres : double.NaN, 10, "c-height");
        WriteChart("speed", "m/s", s => s.HasPosition ? s.GroundSpeed : double.NaN, 2, "c-speed");
        WriteChart("battery", "%", s => s.BatteryRemaining * 100, 100, "c-battery");
        WriteEnergy();
        WriteChart("coverage", "%", s => s.Coverage * 100, 100, "c-coverage");
        WriteHealth();
        WriteManagers();
        page.Empty("line", "id", "cursor", "class", "cursor", "x1", "-9", "x2", "-9", "y1", "16", "y2", N(height));
        page.Close().Close();
        page.Element(
            "figcaption", "Move over the time lines: the map shows where the vehicle was.", "id", "readout", "class",
            "readout");
        page.Close().Close();
    }

    private void WritePhases()
    {
        _axis.WriteLabel("phase", _y, BandHeight);
        foreach ((double from, double to, FlightSample sample) in Bands(s => (int)s.Phase))
        {
            _axis.WriteBand(
                "band " + PhaseStyle.Class(sample.Phase), FlightText.Phase(sample.Phase), _y, from, to);
        }

        _y += BandHeight + Gap;
    }

    private void WriteHealth()
    {
        _axis.WriteLabel("health", _y, BandHeight);
        foreach ((double from, double to, FlightSample sample) in Bands(s => (int)s.Health))
        {
            page.Open("g")
                .Element("title", $"{sample.Health}, {FlightText.Clock(TimeSpan.FromSeconds(from))} to "
                    + $"{FlightText.Clock(TimeSpan.FromSeconds(to))}");
            _axis.WriteBand("band h-" + sample.Health.ToString().ToLowerInvariant(), _y, from, to);
            page.Close();
        }

        _y += BandHeight + Gap;
    }

    // Where the two lines meet it has to return.
    private void WriteEnergy()
    {
        double top = _y;
        WriteChart("energy left", "%", s => s.ChargeLeft * 100, 100, "c-battery");
        _y = top;
        WriteLine(s => Math.Min(1, s.ChargeNeeded) * 100, 100, "line c-needed");
        page.Element(
            "text", "dashed: way home and reserve", "x", N(TimeAxis.Right - 6), "y", N(_y + 12),
            "text-anchor", "end", "class", "hint");
        _y += ChartHeight + Gap;
    }

    private void WriteLine(Func<FlightSample, double> value, double top, string kind)
    {
        (double T, double Value)[] points = Points(value);
        if (points.Length > 1)
            page.Empty("polyline", "class", kind, "points", Line(points, top));
    }

    private (double T, double Value)[] Points(Func<FlightSample, double> value)
    {
        int stride = Math.Max(1, _samples.Count / MaxPoints);
        return _samples
            .Where((_, index) => index % stride == 0 || index == _samples.Count - 1)
            .Select(s => (s.Time.TotalSeconds, value(s)))
            .Where(p => !double.IsNaN(p.Item2) && !double.IsInfinity(p.Item2))
            .ToArray();
    }

    private string Line((double T, double Value)[] points, double top)
        => string.Join(" ", points.Select(p => MapFrame.Point(
            (_axis.X(p.T), _y + ChartHeight - (Math.Max(0, Math.Min(top, p.Value)) / top * ChartHeight)))));

    private void WriteChart(string name, string unit, Func<FlightSample, double> value, double minimum, string kind)
    {
        (double T, double Value)[] points = Points(value);
        double top = TimeAxis.RoundUp(Math.Max(minimum, points.Select(p => p.Value).DefaultIfEmpty(0).Max()));
        double bottom = _y + ChartHeight;
        _axis.WriteLabel(name, _y, ChartHeight, $"0 to {FlightText.Number(top)} {unit}");
        _axis.WriteFrame(_y, ChartHeight);
        if (points.Length > 1)
        {
            string line = Line(points, top);
            page.Empty(
                "polygon", "class", "fill " + kind, "points",
                $"{N(_axis.X(points[0].T))},{N(bottom)} {line} {N(_axis.X(points[points.Length - 1].T))},{N(bottom)}");
            page.Empty("polyline", "class", "line " + kind, "points", line);
        }

        _y += ChartHeight + Gap;
    }

    private void WriteManagers()
    {
        if (data.Record.Managers.Count == 0)
            return;
        page.Element(
            "text", "units of work, darker for more", "x", N(TimeAxis.Left), "y", N(_y + 10), "class", "hint");
        _y += 18;
        foreach (ManagerTimeLine manager in data.Record.Managers)
        {
            WriteManager(manager);
            _y += BandHeight;
        }
    }

    private void WriteManager(ManagerTimeLine manager)
    {
        ManagerSample[] samples = manager.Samples.ToArray();
        int stride = Math.Max(1, (samples.Length + MaxBins - 1) / MaxBins);
        samples = samples.Where((_, index) => index % stride == 0 || index == samples.Length - 1).ToArray();
        double max = 0;
        for (int index = 1; index < samples.Length; index++)
            max = Math.Max(max, Rate(samples[index - 1], samples[index]));
        _axis.WriteLabel(manager.Name, _y, BandHeight, string.Empty);
        page.Open("g").Element("title", $"{manager.Name}: at most {FlightText.Number(max, "0.#")} a second");
        for (int index = 1; index < samples.Length; index++)
            WriteBin(samples[index - 1], samples[index], max);
        page.Close();
    }

    private void WriteBin(in ManagerSample from, in ManagerSample to, double max)
    {
        double rate = Rate(from, to);
        double x1 = _axis.X(from.Time.TotalSeconds);
        double width = Math.Max(0.5, _axis.X(to.Time.TotalSeconds) - x1);
        bool isFaulty = to.Faults > from.Faults
            || to.State is ManagerState.Faulted or ManagerState.Restarting or ManagerState.Hanging;
        if (rate <= 0 && !isFaulty)
            return;
        page.Empty(
            "rect", "class", isFaulty ? "bin fault" : "bin", "x", N(x1), "y", N(_y + 1), "width", N(width), "height",
            N(BandHeight - 4), "opacity", isFaulty ? "1" : FlightText.Number(0.12 + (0.78 * rate / max), "0.##"));
    }

    private static double Rate(in ManagerSample from, in ManagerSample to)
        => to.Time > from.Time ? Math.Max(0, to.Runs - from.Runs) / (to.Time - from.Time).TotalSeconds : 0;

    private IEnumerable<(double From, double To, FlightSample Sample)> Bands(Func<FlightSample, int> kind)
    {
        int first = 0;
        for (int index = 1; index <= _samples.Count; index++)
        {
            if (index < _samples.Count && kind(_samples[index]) == kind(_samples[first]))
                continue;
            double to = _samples[Math.Min(index, _samples.Count - 1)].Time.TotalSeconds;
            yield return (_samples[first].Time.TotalSeconds, to, _samples[first]);
            first = index;
        }
    }

    private static string N(double value) => FlightText.Number(value, "0.##");
}
