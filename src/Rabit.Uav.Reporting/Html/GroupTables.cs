using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Reporting.Html;

/// <summary>The tables of the page of a group: its vehicles, the decisions of all of them, and the run.</summary>
internal sealed class GroupTables(PageWriter page, GroupFlightSummary data)
{
    private const int MaxDecisions = 1_500;
    private const int HashDigitsShown = 16;

    public void WriteVehicles()
    {
        page.Open("section").Element("h2", "Vehicles").Open("div", "class", "card scroll").Open("table");
        page.TableHead(
            "vehicle", "ended, by its own position", "#lanes", "#flown m", "#motors on", "#battery", "#announced",
            "#validated", "#radio kbit/s", "#lost", "report");
        page.Open("tbody");
        for (int i = 0; i < data.Vehicles.Count; i++)
            WriteVehicle(i);
        page.Close().Close().Close();
        page.Element(
            "p",
            "Announced: targets that it asked the others to validate. Validated: those of others that it had a result "
                + "for. Radio: the mean of what it sent, with framing and heartbeat; lost: receptions by others that failed.",
            "class", "note");
        page.Close();
    }

    public void WriteDecisions()
    {
        (TimeSpan Time, int Vehicle, string Text)[] decisions = data.Vehicles
            .SelectMany((v, i) => v.Flight.Events.Where(IsShown).Select(e => (v.ClockOffset + e.Time, i, e.Text)))
            .OrderBy(d => d.Item1).ThenBy(d => d.i).ToArray();
        page.Open("section").Element("h2", "Decisions of all vehicles").Element(
            "p", "Times are seconds since the start of the run; places are those that were known then.", "class",
            "note");
        page.Open("div", "class", "card scroll").Open("table", "class", "stacked");
        page.TableHead("#time, s", "by", "what");
        page.Open("tbody");
        foreach ((TimeSpan time, int vehicle, string text) in decisions.Take(MaxDecisions))
        {
            page.Open("tr").Element("td", FlightText.Number(time.TotalSeconds, "0.00"), "class", "number");
            page.Open("td", "class", "source");
            GroupColours.WriteName(page, vehicle, data.Vehicles[vehicle].SystemId);
            page.Close().Element("td", text).Close();
        }

        page.Close().Close().Close();
        if (decisions.Length > MaxDecisions)
            page.Element(
                "p", $"{FlightText.Number((long)decisions.Length - MaxDecisions)} more are left out.", "class", "note");
        page.Close();
    }

    public void WriteRun()
    {
        page.Open("section").Element("h2", "Run").Open("div", "class", "card").Open("dl", "class", "run");
        page.Fact("command line", data.CommandLine);
        page.Fact("flown", data.Source);
        string operators = EachOnce(f => f.OperatorName);
        page.Fact("operator", operators.Length > 0 ? operators : "not named");
        string missions = EachOnce(MissionFileOf);
        if (missions.Length > 0)
            page.Fact("mission file", missions);
        if (data.Seed is { } seed)
            page.Fact("seed", FlightText.Number(seed));
        page.Fact("ended by", EachOnce(f => f.StopReason));
        page.Close().Close().Close();
    }

    private string EachOnce(Func<FlightSummary, string> textOf) => string.Join(
        "; ", data.Vehicles.Select(v => textOf(v.Flight)).Where(t => t.Length > 0).Distinct(StringComparer.Ordinal));

    // The whole hash is in the report of the vehicle.
    private static string MissionFileOf(FlightSummary flight) => flight.MissionFileSha256.Length > HashDigitsShown
        ? $"{flight.MissionFile}, SHA-256 {flight.MissionFileSha256.Substring(0, HashDigitsShown)}…"
        : flight.MissionFile;

    private void WriteVehicle(int index)
    {
        GroupVehicleSummary vehicle = data.Vehicles[index];
        page.Open("tr").Open("td", "class", "name");
        GroupColours.WriteName(page, index, vehicle.SystemId);
        page.Close();
        MissionSummary? mission = vehicle.Flight.Mission;
        page.Element("td", mission?.Text ?? (mission is null ? "no mission" : FlightText.Phase(mission.Phase)));
        foreach (string figure in FiguresOf(vehicle, mission))
            page.Element("td", figure, "class", "number");
        page.Open("td", "class", "name");
        if (vehicle.ReportFile.Length > 0)
            page.Element("a", "its report", "href", Address(vehicle.ReportFile));
        page.Close().Close();
    }

    private IEnumerable<string> FiguresOf(GroupVehicleSummary vehicle, MissionSummary? mission) =>
    [
        FlightText.Number((long)(mission?.LanesFlown ?? 0)),
        FlightText.Number(mission?.FlownMetres ?? double.NaN, "0"),
        mission is null ? "–" : FlightText.Clock(mission.FlightTime),
        FlightText.Number(mission?.BatteryUsedPercent ?? double.NaN, "0") + " %",
        FlightText.Number((long)data.Validations.Count(t => t.Finder == vehicle.SystemId)),
        FlightText.Number((long)data.Validations.Count(
            t => t.Validator == vehicle.SystemId && t.State == ValidationState.Closed && !t.IsRejectedByOperator)),
        FlightText.Number(vehicle.Radio?.KilobitsPerSecond ?? double.NaN, "0.00"),
        FlightText.Number((vehicle.Radio?.LossFraction ?? double.NaN) * 100, "0.0") + " %",
    ];

    // The orders that follow from a decision are in the report of the vehicle.
    private static bool IsShown(FlightEvent e)
        => e.Kind == RabitLogKind.Fault || (e.Kind == RabitLogKind.Manager
            && e.Source == MissionControlManager.ManagerName
            && !e.Text.StartsWith("command ", StringComparison.Ordinal));

    // A path on this side: never an address with a scheme.
    private static string Address(string file) => string.Join("/", file.Split('/').Select(Uri.EscapeDataString));
}
