using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Uav.Reporting.Html;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Writes the report of a flight: one page of HTML that needs neither network nor other files, with the map, the
/// targets, time lines of the flight and of the managers, decisions, health and faults.
/// </summary>
/// <example>
/// <code>
/// using StreamWriter file = File.CreateText("mission-report.html");
/// HtmlReport.Write(file, summary);
/// </code>
/// </example>
public sealed class HtmlReport
{
    private const int MaxCursorPoints = 600;

    private readonly PageWriter _page = new();
    private readonly ReportShell _shell;
    private readonly FlightSummary _summary;
    private readonly MapFrame? _frame;

    private HtmlReport(FlightSummary summary)
    {
        _summary = summary;
        _shell = new ReportShell(_page);
        _frame = MapFrame.Of(summary);
    }

    /// <summary>Writes the whole page.</summary>
    /// <param name="output">Where to; it is neither flushed nor closed. Its encoding must be UTF-8.</param>
    /// <param name="summary">What to report.</param>
    public static void Write(TextWriter output, FlightSummary summary)
    {
        if (output is null)
            throw new ArgumentNullException(nameof(output));
        var report = new HtmlReport(summary ?? throw new ArgumentNullException(nameof(summary)));
        report.WritePage();
        output.Write(report._shell.ToString());
    }

    private void WritePage()
    {
        _shell.Begin(Title);
        WriteHead();
        if (_summary.Mission is { } mission)
            WriteTiles(mission);
        if (_frame is not null)
            new ReportMap(_page, _summary, _frame).Write();
        new ReportTargets(_page, _summary).Write();
        new ReportTimeLines(_page, _summary).Write();
        new ReportTables(_page, _summary).Write();
        _shell.End(CursorPoints());
    }

    private string Title => _summary.Mission switch
    {
        null => "Flight report",
        { Plan.Name: { Length: > 0 } name } => "Mission report: " + name,
        _ => "Mission report",
    };

    private void WriteHead()
    {
        _page.Open("header").Element("p", "Rabit mission report", "class", "eyebrow");
        if (_summary.Mission is not { } mission)
        {
            _page.Element("h1", "A flight that was observed").Element("p", _summary.Source, "class", "lead");
            new ReportFacts(_page, _summary).Write();
            _page.Close();
            return;
        }

        _page.Element("h1", mission.Plan is { Name.Length: > 0 } plan ? plan.Name : "Mission");
        _page.Open("p", "class", "verdict " + (mission.HasPassed ? "good" : "bad"))
            .Element("strong", mission.HasPassed ? "Mission accomplished" : "Mission failed")
            .Text(" " + ResultText(mission)).Close();
        if (mission.Failures.Count > 1)
        {
            _page.Open("ul", "class", "failures");
            foreach (string failure in mission.Failures)
                _page.Element("li", failure);
            _page.Close();
        }

        foreach (string headline in mission.Remarks)
            _page.Element("p", headline, "class", "nothing");
        if (mission.Aborted is { } aborted)
            _page.Element("p", "The search was given up before its end: " + aborted, "class", "aborted");
        _page.Element("p", _summary.Source, "class", "lead");
        new ReportFacts(_page, _summary).Write();
        _page.Close();
    }

    private static string ResultText(MissionSummary mission)
    {
        if (mission.Failures.Count == 1)
            return mission.Failures[0];
        if (mission.Failures.Count > 1)
            return $"for {FlightText.Number(mission.Failures.Count)} reasons";
        string targets = mission.Score is { } score
            ? $"{FlightText.Number(score.Found)} of {FlightText.Number(score.Targets.Count)} targets found, "
            : string.Empty;
        return targets + "landed at home";
    }

    private void WriteTiles(MissionSummary mission)
    {
        _page.Open("div", "class", "tiles");
        if (mission.Score is { } score)
        {
            _shell.Tile(
                "targets found", $"{FlightText.Number(score.Found)} / {FlightText.Number(score.Targets.Count)}",
                (score.FalseTracks.Count == 0
                    ? "no false track"
                    : $"{FlightText.Number(score.FalseTracks.Count)} false")
                    + FlightText.RejectedTracks(score) + FlightText.IdentitySwitches(score));
            _shell.Tile(
                "position error",
                double.IsNaN(score.RmseMetres) ? "none" : $"{FlightText.Number(score.RmseMetres, "0.00")} m",
                $"RMS; {FlightText.Number(score.InEllipse)} of {FlightText.Number(score.Found)} in their ellipse");
        }

        string lanes = mission.LanesFlown == 1 ? "1 lane" : FlightText.Number(mission.LanesFlown) + " lanes";
        _shell.Tile(
            "area covered", $"{FlightText.Number(mission.CoveragePercent, "0.0")} %",
            mission.RequiredCoveragePercent > 0
                ? $"{FlightText.Number(mission.RequiredCoveragePercent, "0.#")} % required, {lanes} flown"
                : lanes + " flown");
        _shell.Tile("path flown", $"{FlightText.Number(mission.FlownMetres, "0")} m", mission.OutsideFenceMetres > 0
            ? $"{FlightText.Number(mission.OutsideFenceMetres, "0.0")} m outside the fence"
            : "inside the fence");
        _shell.Tile("flight time", FlightText.Clock(mission.FlightTime) + " min", "motors on");
        _shell.Tile("battery used", $"{FlightText.Number(mission.BatteryUsedPercent, "0")} %", mission.Energy.IsKnown
            ? $"of its capacity; {FlightText.Number(mission.Energy.ChargeLeft * 100, "0")} % are left by the energy model"
            : "of its capacity");
        _shell.Tile(
            "landed", mission.HasLanded ? $"{FlightText.Number(mission.DistanceFromHomeMetres, "0.0")} m" : "no",
            LandingNote(mission));
        _page.Close();
    }

    // What Mission Control says of its last phase goes by the position of the vehicle, also in a simulation.
    private string LandingNote(MissionSummary mission)
        => !mission.HasLanded ? (_summary.Record.Mission.Result.HasFlown ? "it is in the air" : "it did not fly")
            : mission.Score?.DistanceFromHomeMetres is null ? "from home, by its own position"
            : "from home in truth; what Mission Control says goes by its own position";

    // Numbers only: nothing from outside gets into the script.
    private string CursorPoints()
    {
        if (_frame is null)
            return "[]";
        FlightSample[] samples = _summary.Record.Samples.Where(s => s.HasPosition).ToArray();
        int stride = Math.Max(1, samples.Length / MaxCursorPoints);
        IEnumerable<string> points = samples.Where((_, index) => index % stride == 0).Select(s =>
        {
            (double x, double y) = _frame.ToMap(s.Position);
            double[] values =
            [
                s.Time.TotalSeconds, x, y, s.HeightAboveHomeMetres, s.GroundSpeed, s.BatteryRemaining * 100,
                s.Coverage * 100
            ];
            return "[" + string.Join(",", values.Select(
                v => double.IsNaN(v) || double.IsInfinity(v) ? "null" : FlightText.Number(v, "0.#"))) + "]";
        });
        return "[" + string.Join(",", points) + "]";
    }
}
