using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>The checklist as lines of text.</summary>
internal static class PreflightText
{
    public static IEnumerable<string> LinesOf(PreflightReport report)
    {
        yield return "pre-flight checklist";
        int width = report.Lines.Select(l => l.Name.Length).DefaultIfEmpty(0).Max();
        foreach (PreflightLine line in report.Lines)
        {
            string howToSet = line.HowToSet.Length > 0 ? "; " + line.HowToSet : string.Empty;
            yield return string.Format(
                CultureInfo.InvariantCulture, "  {0,-8} {1} {2}{3}", ResultOf(line), line.Name.PadRight(width),
                FlightText.Printable(line.Value), howToSet);
        }

        if (report.WhenComputerFails.Length > 0)
            yield return "if this computer fails in flight: " + report.WhenComputerFails;
    }

    /// <summary>The result of a line in a word.</summary>
    public static string ResultOf(PreflightLine line)
        => line.IsOverridden ? "override" : line.Result.ToString().ToLowerInvariant();
}
