using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Spectre.Console;

namespace UavConsole;

/// <summary>The pre-flight checklist on the screen, in the place of the map until the motors run.</summary>
internal static class ChecklistPane
{
    /// <summary>Draws it: what refuses the flight first, what passes last.</summary>
    /// <param name="report">The checklist, complete.</param>
    /// <param name="width">Columns that there are.</param>
    /// <param name="height">Lines that there are, at least 3.</param>
    /// <returns>As many lines of markup as there are, all of the width.</returns>
    public static IReadOnlyList<string> Draw(PreflightReport report, int width, int height)
    {
        PreflightLine[] lines = [.. report.Lines.OrderByDescending(Severity)];
        int shown = lines.Length < height ? lines.Length : height - 2;
        string verdict = report.Passes ? "passes" : "REFUSES THE FLIGHT";
        var drawn = new List<string> { Line("bold", "pre-flight checklist: " + verdict, width) };
        foreach (PreflightLine line in lines.Take(shown))
            drawn.Add(Line(Style(line), $"{PreflightText.ResultOf(line),-8} {line.Name}: {HowToSet(line)}", width));
        if (shown < lines.Length)
            drawn.Add(Line("grey", $"and {FlightText.Number(lines.Length - shown)} more lines", width));
        while (drawn.Count < height)
            drawn.Add(Line("default", string.Empty, width));
        return drawn;
    }

    private static string HowToSet(PreflightLine line)
        => line.HowToSet.Length > 0 ? $"{line.Value}; {line.HowToSet}" : line.Value;

    private static int Severity(PreflightLine line)
        => line.Refuses ? 3 : line.IsOverridden ? 2 : line.Result == PreflightResult.Pass ? 0 : 1;

    private static string Style(PreflightLine line) => Severity(line) switch
    {
        3 => "red",
        0 => "grey",
        _ => "yellow",
    };

    private static string Line(string style, string text, int width)
        => $"[{style}]{Markup.Escape(Text.Fit(FlightText.Printable(text), width))}[/]";
}
