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
    private const double Left = 150;
    private const double Right = 990;
    private const double ChartHeight = 58;
    private const double BandHeight = 18;
    private const double Gap = 12;
    private const int MaxPoints = 700;
    private const int MaxBins = 240;

    private readonly IReadOnlyList<FlightSample> _samples = data.Record.Samples;
    private double _y = 22;
    private double _start;
    private double _end;

    public void Write()
    {
        if (_samples.Count < 2)
            return;
        _start = _samples[0].Time.TotalSeconds;
        _end = Math.Max(_start + 1, _samples[_samples.Count - 1].Time.TotalSeconds);
        double height = _y + (2 * (BandHeight + Gap)) + (5 * (ChartHeight + Gap)) + 34
            + (data.Record.Managers.Count * BandHeight) + 8;
        page.Open("section").Element("h2", "Time lines").Open("figure", "class", "card times");
        page.Open("div", "class", "wide").Open(
            "svg", "viewBox", $"0 0 1000 {N(height)}", "id", "times", "role", "img", "aria-label",
            "Time lines of the flight",
            "data-left", N(Left), "data-right", N(Right), "data-start", N(_start), "data-end", N(_end));
        WriteTimeAxis(height);
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

    private void WriteTimeAxis(double height)
    {
        double[] steps = [5, 10, 20, 30, 60, 120, 300, 600, 1800, 3600, 7200, 36_000];
        double step = steps.FirstOrDefault(s => (_end - _start) / s <= 12);
        if (step <= 0)
            step = (_end - _start) / 10;
        page.Open("g", "class", "axis");
        for (double t = Math.Ceiling(_start / step) * step; t <= _end; t += step)
        {
            page.Empty("line", "x1", N(X(t)), "x2", N(X(t)), "y1", "16", "y2", N(height - 4));
            page.Element(
                "text", FlightText.Clock(TimeSpan.FromSeconds(t)), "x", N(X(t)), "y", "11", "text-anchor", "middle");
        }

        page.Close();
    }

    private void WritePhases()
    {
        Label("phase", BandHeight);
        foreach ((double from, double to, FlightSample sample) in Bands(s => (int)s.Phase))
        {
            page.Open("g");
            page.Element("title", $"{FlightText.Phase(sample.Phase)}, {FlightText.Clock(TimeSpan.FromSeconds(from))} "
                + $"to {FlightText.Clock(TimeSpan.FromSeconds(to))}");
            Band("band " + PhaseStyle.Class(sample.Phase), from, to);
            if (X(to) - X(from) > 7.5 * FlightText.Phase(sample.Phase).Length)
                page.Element(
                    "text", FlightText.Phase(sample.Phase), "x", N((X(from) + X(to)) / 2), "y", N(_y + 13), "class",
                    "in-band", "text-anchor", "middle");
            page.Close();
        }

        _y += BandHeight + Gap;
    }

    private void WriteHealth()
    {
        Label("health", BandHeight);
        foreach ((double from, double to, FlightSample sample) in Bands(s => (int)s.Health))
        {
            page.Open("g")
                .Element("title", $"{sample.Health}, {FlightText.Clock(TimeSpan.FromSeconds(from))} to "
                    + $"{FlightText.Clock(TimeSpan.FromSeconds(to))}");
            Band("band h-" + sample.Health.ToString().ToLowerInvariant(), from, to);
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
            "text", "dashed: way home and reserve", "x", N(Right - 6), "y", N(_y + 12), "text-anchor", "end", "class",
            "hint");
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
            (X(p.T), _y + ChartHeight - (Math.Max(0, Math.Min(top, p.Value)) / top * ChartHeight)))));

    private void WriteChart(string name, string unit, Func<FlightSample, double> value, double minimum, string kind)
    {
        (double T, double Value)[] points = Points(value);
        double top = RoundUp(Math.Max(minimum, points.Select(p => p.Value).DefaultIfEmpty(0).Max()));
        double bottom = _y + ChartHeight;
        Label(name, ChartHeight, $"0 to {FlightText.Number(top)} {unit}");
        page.Empty(
            "rect", "class", "frame", "x", N(Left), "y", N(_y), "width", N(Right - Left), "height", N(ChartHeight));
        if (points.Length > 1)
        {
            string line = Line(points, top);
            page.Empty(
                "polygon", "class", "fill " + kind, "points",
                $"{N(X(points[0].T))},{N(bottom)} {line} {N(X(points[points.Length - 1].T))},{N(bottom)}");
            page.Empty("polyline", "class", "line " + kind, "points", line);
        }

        _y += ChartHeight + Gap;
    }

    private void WriteManagers()
    {
        if (data.Record.Managers.Count == 0)
            return;
        page.Element("text", "units of work, darker for more", "x", N(Left), "y", N(_y + 10), "class", "hint");
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
        Label(manager.Name, BandHeight, string.Empty);
        page.Open("g").Element("title", $"{manager.Name}: at most {FlightText.Number(max, "0.#")} a second");
        for (int index = 1; index < samples.Length; index++)
            WriteBin(samples[index - 1], samples[index], max);
        page.Close();
    }

    private void WriteBin(in ManagerSample from, in ManagerSample to, double max)
    {
        double rate = Rate(from, to);
        double x1 = X(from.Time.TotalSeconds);
        double width = Math.Max(0.5, X(to.Time.TotalSeconds) - x1);
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

    private void Label(string name, double height, string? range = null)
    {
        bool hasRange = !string.IsNullOrEmpty(range);
        page.Element(
            "text", name, "x", N(Left - 10), "y", N(_y + (height / 2) + (hasRange ? -2 : range is null ? 4 : 2)),
            "text-anchor", "end", "class", "name");
        if (hasRange)
            page.Element(
                "text", range!, "x", N(Left - 10), "y", N(_y + (height / 2) + 12), "text-anchor", "end", "class",
                "hint");
    }

    private void Band(string kind, double from, double to)
        => page.Empty(
            "rect", "class", kind, "x", N(X(from)), "y", N(_y), "width", N(Math.Max(0.5, X(to) - X(from))), "height",
            N(BandHeight));

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

    private double X(double seconds) => Left + ((seconds - _start) / (_end - _start) * (Right - Left));

    private static double RoundUp(double value)
    {
        double power = Math.Pow(10, Math.Floor(Math.Log10(value)));
        return new[] { 1, 1.5, 2, 3, 4, 5, 6, 8, 10 }.Select(f => f * power).First(v => v >= value * 0.999);
    }

    private static string N(double value) => FlightText.Number(value, "0.##");
}
