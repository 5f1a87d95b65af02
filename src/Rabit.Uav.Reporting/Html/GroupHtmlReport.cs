using System;
using System.IO;
using System.Linq;
using Rabit.Uav.Reporting.Html;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Writes the report of a group: one page of HTML that needs neither network nor other files, with the paths of all
/// vehicles on one map, the targets and who validated them, roles over time, the use of the radio and the decisions.
/// </summary>
/// <example>
/// <code>
/// var group = new GroupFlightSummary([new GroupVehicleSummary(1, new FlightSummary(recorder.Record))]);
/// using StreamWriter file = File.CreateText("group-report.html");
/// GroupHtmlReport.Write(file, group);
/// </code>
/// </example>
public sealed class GroupHtmlReport
{
    private readonly PageWriter _page = new();
    private readonly ReportShell _shell;
    private readonly GroupFlightSummary _group;

    private GroupHtmlReport(GroupFlightSummary group) => (_group, _shell) = (group, new ReportShell(_page));

    /// <summary>Writes the whole page.</summary>
    /// <param name="output">Where to; it is neither flushed nor closed. Its encoding must be UTF-8.</param>
    /// <param name="group">What to report.</param>
    public static void Write(TextWriter output, GroupFlightSummary group)
    {
        if (output is null)
            throw new ArgumentNullException(nameof(output));
        var report = new GroupHtmlReport(group ?? throw new ArgumentNullException(nameof(group)));
        report.WritePage();
        output.Write(report._shell.ToString());
    }

    private void WritePage()
    {
        _shell.Begin("Group report" + (_group.Name.Length > 0 ? ": " + _group.Name : string.Empty));
        WriteHead();
        WriteTiles();
        if (MapFrame.Of(_group.Vehicles.Select(v => v.Flight).ToArray()) is { } frame)
            new GroupMap(_page, _group, frame).Write();
        var tables = new GroupTables(_page, _group);
        tables.WriteVehicles();
        new GroupTargets(_page, _group).Write();
        new GroupTimeLines(_page, _group).Write();
        tables.WriteDecisions();
        tables.WriteRun();
        _shell.End("[]");
    }

    private void WriteHead()
    {
        _page.Open("header").Element("p", "Rabit group report", "class", "eyebrow");
        _page.Element("h1", _group.Name.Length > 0 ? _group.Name : "Mission of a group");
        string result = _group.Failures.Count switch
        {
            0 => $"by {N(_group.Vehicles.Count)} vehicles",
            1 => _group.Failures[0],
            _ => $"for {N(_group.Failures.Count)} reasons",
        };
        _page.Open("p", "class", "verdict " + (_group.HasPassed ? "good" : "bad"))
            .Element("strong", _group.HasPassed ? "Mission accomplished" : "Mission failed").Text(" " + result).Close();
        string[] lines = [.. _group.Failures.Count > 1 ? _group.Failures : [], .. _group.Remarks];
        if (lines.Length > 0)
        {
            _page.Open("ul", "class", "failures");
            foreach (string line in lines)
                _page.Element("li", line);
            _page.Close();
        }

        _page.Element("p", _group.Source, "class", "lead").Close();
    }

    private void WriteTiles()
    {
        _page.Open("div", "class", "tiles");
        if (_group.Score is { } score)
        {
            _shell.Tile(
                "targets found", $"{N(score.Found)} / {N(score.Targets.Count)}",
                (score.FalseTracks.Count == 0 ? "no false track" : $"{N(score.FalseTracks.Count)} false")
                    + FlightText.RejectedTracks(score) + FlightText.IdentitySwitches(score));
            _shell.Tile(
                "position error",
                double.IsNaN(score.RmseMetres) ? "none" : $"{FlightText.Number(score.RmseMetres, "0.00")} m",
                $"RMS; {N(score.InEllipse)} of {N(score.Found)} in their ellipse");
        }

        _shell.Tile(
            "validated", $"{N(_group.Confirmed)} / {N(_group.Validations.Count)}",
            "confirmed by a second vehicle, of those announced");
        _shell.Tile("area covered", $"{FlightText.Number(_group.Coverage * 100, "0.0")} %", "by all together");
        _shell.Tile("time", FlightText.Clock(_group.FlightTime) + " min", "first take-off to last landing");
        _shell.Tile(
            "paths flown",
            $"{FlightText.Number(_group.Vehicles.Sum(v => v.Flight.Record.FlownMetres), "0")} m", "of all vehicles");
        double most = _group.Vehicles.Select(v => v.Radio?.KilobitsPerSecond ?? double.NaN)
            .Where(r => !double.IsNaN(r)).DefaultIfEmpty(double.NaN).Max();
        if (!double.IsNaN(most))
            _shell.Tile("radio, kbit/s", FlightText.Number(most, "0.00"), "the most that one sent, on average");
        _page.Close();
    }

    private static string N(long number) => FlightText.Number(number);
}
