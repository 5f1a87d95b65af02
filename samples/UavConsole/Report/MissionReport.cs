using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;

namespace UavConsole;

/// <summary>Writes mission-report.html: one page that needs nothing else, for a person to look at after a flight.</summary>
internal sealed class MissionReport
{
    private const int MaxCursorPoints = 600;

    private readonly PageWriter _page = new();
    private readonly ReportData _data;
    private readonly MapFrame? _frame;

    private MissionReport(ReportData data)
    {
        _data = data;
        _frame = MapFrame.Of(data);
    }

    /// <summary>The whole page.</summary>
    public static string Write(ReportData data)
    {
        var report = new MissionReport(data);
        report.WritePage();
        return "<!DOCTYPE html>\n" + report._page;
    }

    private void WritePage()
    {
        _page.Open("html", "lang", "en", "xmlns", "http://www.w3.org/1999/xhtml");
        _page.Open("head").Empty("meta", "charset", "utf-8");
        _page.Empty("meta", "name", "viewport", "content", "width=device-width, initial-scale=1");
        _page.Empty("meta", "name", "color-scheme", "content", "light dark");
        _page.Element("title", Title);
        _page.Open("style").Raw(Resource("report.css")).Close().Close();
        _page.Open("body").Open("main");
        WriteHead();
        if (_data.Outcome is { } outcome)
            WriteTiles(outcome);
        if (_frame is not null)
            new ReportMap(_page, _data, _frame).Write();
        new ReportTargets(_page, _data).Write();
        new ReportTimeLines(_page, _data).Write();
        new ReportTables(_page, _data).Write();
        _page.Close();
        WriteScript();
        _page.Close().Close();
    }

    private string Title => _data.Outcome switch
    {
        null => "Flight report",
        { Plan.Name: { Length: > 0 } name } => "Mission report: " + name,
        _ => "Mission report",
    };

    private void WriteHead()
    {
        _page.Open("header").Element("p", "Rabit mission report", "class", "eyebrow");
        if (_data.Outcome is not { } outcome)
        {
            _page.Element("h1", "A flight that was observed").Element("p", _data.Source, "class", "lead").Close();
            return;
        }

        _page.Element("h1", outcome.Plan is { Name.Length: > 0 } plan ? plan.Name : "Mission");
        _page.Open("p", "class", "verdict " + (outcome.HasPassed ? "good" : "bad"))
            .Element("strong", outcome.HasPassed ? "Mission accomplished" : "Mission failed")
            .Text(" " + Verdict(outcome)).Close();
        if (outcome.Failures.Count > 1)
        {
            _page.Open("ul", "class", "failures");
            foreach (string failure in outcome.Failures)
                _page.Element("li", failure);
            _page.Close();
        }

        if (outcome.Aborted is { } aborted)
            _page.Element("p", "The search was given up before its end: " + aborted, "class", "aborted");
        _page.Element("p", _data.Source, "class", "lead").Close();
    }

    private static string Verdict(MissionOutcome outcome)
    {
        if (outcome.Failures.Count == 1)
            return outcome.Failures[0];
        if (outcome.Failures.Count > 1)
            return $"for {Figures.Of(outcome.Failures.Count)} reasons";
        string targets = outcome.Score is { } score ? $"{Figures.Of(score.Found)} of {Figures.Of(score.Targets.Count)} targets found, " : string.Empty;
        return targets + "landed at home";
    }

    private void WriteTiles(MissionOutcome outcome)
    {
        _page.Open("div", "class", "tiles");
        if (outcome.Score is { } score)
        {
            Tile("targets found", $"{Figures.Of(score.Found)} / {Figures.Of(score.Targets.Count)}", score.FalseTracks.Count == 0 ? "no false track" : $"{Figures.Of(score.FalseTracks.Count)} false");
            Tile("position error", $"{Figures.Of(score.RmseMetres, "0.00")} m", $"RMS; {Figures.Of(score.InEllipse)} of {Figures.Of(score.Found)} in their ellipse");
        }

        Tile("area covered", $"{Figures.Of(outcome.CoveragePercent, "0.0")} %", $"{Figures.Of(_data.Record.Mission.LanesFlown)} lanes flown");
        Tile("path flown", $"{Figures.Of(outcome.FlownMetres, "0")} m", outcome.OutsideFenceMetres > 0 ? $"{Figures.Of(outcome.OutsideFenceMetres, "0.0")} m outside the fence" : "inside the fence");
        Tile("flight time", Figures.Clock(outcome.FlightTime) + " min", "motors on");
        Tile("battery used", $"{Figures.Of(outcome.BatteryUsedPercent, "0")} %", "of its capacity");
        Tile("landed", outcome.HasLanded ? $"{Figures.Of(outcome.DistanceFromHomeMetres, "0.0")} m" : "no", "from home");
        _page.Close();
    }

    private void Tile(string name, string value, string note)
        => _page.Open("div", "class", "tile").Element("span", name).Element("b", value).Element("small", note).Close();

    private void WriteScript()
    {
        _page.Open("script", "type", "application/json", "id", "flight").Raw(CursorPoints()).Close();
        _page.Open("script").Raw(Resource("report.js")).Close();
    }

    // Numbers only: nothing from outside gets into the script.
    private string CursorPoints()
    {
        if (_frame is null)
            return "[]";
        FlightSample[] samples = _data.Record.Samples.Where(s => s.HasPosition).ToArray();
        int stride = Math.Max(1, samples.Length / MaxCursorPoints);
        IEnumerable<string> points = samples.Where((_, index) => index % stride == 0).Select(s =>
        {
            (double x, double y) = _frame.ToMap(s.Position);
            double[] values = [s.Time.TotalSeconds, x, y, s.HeightAboveHomeMetres, s.GroundSpeed, s.BatteryRemaining * 100, s.Coverage * 100];
            return "[" + string.Join(",", values.Select(v => double.IsNaN(v) || double.IsInfinity(v) ? "null" : Figures.Of(v, "0.#"))) + "]";
        });
        return "[" + string.Join(",", points) + "]";
    }

    private static string Resource(string name)
    {
        using Stream stream = typeof(MissionReport).Assembly.GetManifestResourceStream("UavConsole.Report." + name)!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd();
    }
}
