using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Reporting.Html;

/// <summary>The tables of the page: decisions and events, health, managers, and how the run was started.</summary>
internal sealed class ReportTables(PageWriter page, FlightSummary data)
{
    private const int MaxEvents = 1_500;

    public void Write()
    {
        WriteEvents();
        WriteHealth();
        WriteManagers();
        WriteRun();
    }

    private void WriteEvents()
    {
        FlightEvent[] events = data.Events.Where(e => e.Kind != RabitLogKind.Run).ToArray();
        FlightEvent[] shown = events.Length <= MaxEvents
            ? events
            : events.Take(MaxEvents / 2).Concat(events.Skip(events.Length - (MaxEvents / 2))).ToArray();
        page.Open("section").Element("h2", "Decisions and events");
        page.Open("div", "class", "card scroll").Open("table", "class", "stacked");
        page.TableHead("#time", "by", "what");
        page.Open("tbody");
        foreach (FlightEvent e in shown)
            WriteEvent(e);
        page.Close().Close().Close();
        if (data.EventCount > shown.Length)
            page.Element(
                "p", $"{FlightText.Number(data.EventCount - shown.Length)} more are left out; --log FILE keeps all.",
                "class", "note");
        page.Close();
    }

    private void WriteEvent(FlightEvent e)
    {
        string kind = e.Kind switch
        {
            RabitLogKind.Fault => "fault",
            RabitLogKind.Manager when IsDecision(e) => "decision",
            RabitLogKind.Manager => string.Empty,
            _ => "quiet",
        };
        page.Open("tr", "class", kind);
        page.Element("td", FlightText.Number(e.Time.TotalSeconds, "0.00"), "class", "number")
            .Element("td", e.Source, "class", "source").Element("td", e.Text);
        page.Close();
    }

    // The orders that follow from a decision are many, and not to be in front of it.
    private static bool IsDecision(FlightEvent e)
        => e.Source == MissionControlManager.ManagerName && !e.Text.StartsWith("command ", StringComparison.Ordinal);

    private void WriteHealth()
    {
        page.Open("section").Element("h2", "Health and faults");
        page.Open("div", "class", "card scroll").Open("table", "class", "stacked");
        page.TableHead("#time", "level", "what", "asked for");
        page.Open("tbody");
        foreach (HealthChange change in data.Record.HealthChanges)
        {
            HealthReport report = change.Report;
            page.Open("tr", "class", "h-row-" + report.Level.ToString().ToLowerInvariant());
            page.Element("td", FlightText.Number(change.Time.TotalSeconds, "0.00"), "class", "number");
            page.Open("td", "class", "name").Element("b", report.Level.ToString(), "class", "level").Close();
            page.Element("td", report.Text ?? "nothing to report")
                .Element("td", Advice(report.Advice), "class", "name");
            page.Close();
        }

        page.Close().Close().Close().Close();
    }

    private void WriteManagers()
    {
        page.Open("section").Element("h2", "Managers").Open("div", "class", "card scroll").Open("table");
        page.TableHead("manager", "#runs", "#work, mean ms", "#longest ms", "#total s", "#faults", "ended");
        page.Open("tbody");
        foreach (ManagerSummary manager in data.Managers)
        {
            page.Open("tr", "class", manager.Faults > 0 ? "fault" : string.Empty)
                .Element("td", manager.Name, "class", "name");
            foreach (string figure in NumbersOf(manager))
                page.Element("td", figure, "class", "number");
            page.Element("td", manager.Outcome).Close();
            if (manager.FirstFault is { } fault)
                page.Open("tr", "class", "fault").Element("td", "first fault: " + fault, "colspan", "7").Close();
        }

        page.Close().Close().Close().Close();
    }

    private static IEnumerable<string> NumbersOf(ManagerSummary manager) =>
    [
        FlightText.Number(manager.Runs),
        FlightText.Number(manager.MeanWork.TotalMilliseconds, "0.000"),
        FlightText.Number(manager.LongestWork.TotalMilliseconds, "0.0"),
        FlightText.Number(manager.TotalWork.TotalSeconds, "0.00"),
        FlightText.Number(manager.Faults),
    ];

    private void WriteRun()
    {
        ImagingStatus imaging = data.Record.Imaging;
        page.Open("section").Element("h2", "Run").Open("div", "class", "card").Open("dl", "class", "run");
        page.Fact("command line", data.CommandLine);
        page.Fact("flown", data.Source);
        if (data.Seed is { } seed)
            page.Fact("seed", FlightText.Number(seed));
        page.Fact("ended by", data.StopReason);
        if (imaging.HasCamera)
        {
            page.Fact(
                "camera",
                $"{FlightText.Number(imaging.Frames)} pictures, {FlightText.Number(imaging.Observations)} searched, "
                + $"{FlightText.Number(imaging.FramesRefused)} refused, "
                + $"{FlightText.Number(imaging.FramesDropped)} lost, {FlightText.Number(imaging.Reports)} reports"
                + UnusableOf(imaging.Pictures)
                + (imaging.Fault is { } fault ? $", {fault}" : string.Empty));
        }

        page.Close().Close().Close();
    }

    // Which of them could not be used, and why: the most frequent cause first.
    private static string UnusableOf(PictureCounts pictures) => string.Concat(
        Enumerable.Range(1, (int)PictureQuality.MotionBlurred)
            .Select(q => (PictureQuality)q).Where(q => pictures.Of(q) > 0).OrderByDescending(q => pictures.Of(q))
            .Select(q => $", {FlightText.Number(pictures.Of(q))} {PictureQualityText.Of(q)}"));

    private static string Advice(HealthAdvice advice) => advice switch
    {
        HealthAdvice.None => "–",
        HealthAdvice.Hold => "hold",
        HealthAdvice.ReturnToLaunch => "return to launch",
        HealthAdvice.Land => "land",
        _ => advice.ToString(),
    };
}
