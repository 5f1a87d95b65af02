using System;
using System.Linq;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>
/// Prints the checklist when it is complete, and again when the result of a line changes before the flight. One thread.
/// </summary>
internal sealed class PreflightPrinter(Action<string> print)
{
    private PreflightReport _printed = PreflightReport.None;

    public void Show(PreflightReport report)
    {
        if (!report.IsComplete || ReferenceEquals(report, _printed) || HaveSameResults(report, _printed))
            return;
        _printed = report;
        foreach (string line in PreflightText.LinesOf(report))
            print(line);
    }

    private static bool HaveSameResults(PreflightReport a, PreflightReport b)
        => a.IsComplete == b.IsComplete && a.Lines.Select(l => (l.Name, l.Result)).SequenceEqual(
            b.Lines.Select(l => (l.Name, l.Result)));
}
