using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace UavConsole;

/// <summary>The files that a run writes: summary, report, log.</summary>
internal sealed class RunFiles : IDisposable
{
    private const int MaxNameLength = 40;

    private RunFiles(OutputFile? summary, OutputFile? report, OutputFile? log)
    {
        Summary = summary;
        Report = report;
        Log = log;
    }

    /// <summary>Null where none is wanted.</summary>
    public OutputFile? Summary { get; }

    /// <summary>Null where none is wanted.</summary>
    public OutputFile? Report { get; }

    /// <summary>Null where none is wanted.</summary>
    public OutputFile? Log { get; }

    /// <param name="options">What was asked for.</param>
    /// <param name="mission">The name of the mission that is flown; null for none.</param>
    /// <exception cref="ArgumentException">
    /// One cannot be written, or two are the same; a mission, a truth or a key that was read is never written to.
    /// </exception>
    public static RunFiles Open(ConsoleOptions options, string? mission)
    {
        string? report = options.ReportFile ?? (mission is null ? null : DefaultReport(mission));
        CheckTheyDiffer(
        [
            ("--mission", options.MissionFile), ("--truth", options.TruthFile), ("--sign-key", options.SignKeyFile),
            ("--progress", options.Operator.ProgressFile), ("--originals", options.Preflight.OriginalsFile),
            ("--summary", options.SummaryFile), ("--report", report), ("--log", options.LogFile),
        ]);
        OutputFile? summaryFile = null;
        OutputFile? reportFile = null;
        try
        {
            summaryFile = OutputFile.Open("--summary", options.SummaryFile, options.Links);
            reportFile = OutputFile.Open("--report", report, options.Links);
            return new RunFiles(summaryFile, reportFile, OutputFile.Open("--log", options.LogFile, options.Links));
        }
        catch (ArgumentException)
        {
            summaryFile?.Dispose();
            reportFile?.Dispose();
            throw;
        }
    }

    public void Dispose()
    {
        Summary?.Dispose();
        Report?.Dispose();
        Log?.Dispose();
    }

    // Where the report of a mission goes when nothing else is asked for: beside the user, with mission and date, so
    // that no flight overwrites the last one's.
    private static string DefaultReport(string mission)
    {
        char[] name = mission.ToLowerInvariant().Select(c => c is >= 'a' and <= 'z' or >= '0' and <= '9' ? c : '-')
            .Take(MaxNameLength).ToArray();
        string date = DateTime.UtcNow.ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture);
        return $"{new string(name).Trim('-')}-{date}-report.html".TrimStart('-');
    }

    private static void CheckTheyDiffer(IReadOnlyList<(string Option, string? Path)> files)
    {
        IGrouping<string, (string Option, string? Path)>? same = files
            .Where(f => !string.IsNullOrEmpty(f.Path) && !f.Path!.StartsWith("/dev/", StringComparison.Ordinal))
            .GroupBy(f => Path.GetFullPath(f.Path!), StringComparer.Ordinal)
            .FirstOrDefault(g => g.Count() > 1);
        if (same is not null)
            throw new ArgumentException(
                $"{string.Join(" and ", same.Select(f => f.Option))} are the same file {same.First().Path}.",
                nameof(files));
    }
}
