using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace UavConsole;

/// <summary>The files that a run writes: summary, report, log, exports.</summary>
internal sealed class RunFiles : IDisposable
{
    private const int MaxNameLength = 40;

    private RunFiles(
        OutputPath? summary, IEnumerable<OutputPath> reports, OutputPath? log, IEnumerable<OutputPath> exports)
    {
        Summary = summary is null ? null : new WholeFile(summary);
        Reports = [.. reports.Select(r => new WholeFile(r))];
        Log = log is null ? null : new LogFile(log);
        Exports = [.. exports.Select(e => new WholeFile(e))];
    }

    /// <summary>Null where none is wanted.</summary>
    public WholeFile? Summary { get; }

    /// <summary>Null where none is wanted.</summary>
    public WholeFile? Report => Reports.Count > 0 ? Reports[0] : null;

    /// <summary>
    /// The one of the only vehicle; of several vehicles that of the group and then one for each of them, unless it goes
    /// to a device. None where none is wanted.
    /// </summary>
    public IReadOnlyList<WholeFile> Reports { get; }

    /// <summary>Null where none is wanted.</summary>
    public LogFile? Log { get; }

    /// <summary>Files for maps and tables.</summary>
    public IReadOnlyList<WholeFile> Exports { get; }

    /// <param name="options">What was asked for.</param>
    /// <param name="mission">The name of the mission that is flown; null for none.</param>
    /// <exception cref="ArgumentException">
    /// One cannot be written, or two are the same; a mission, a truth or a key that was read is never written to.
    /// </exception>
    public static RunFiles Open(ConsoleOptions options, string? mission)
    {
        string[] reports = ReportsOf(
            options.ReportFile ?? (mission is null ? null : DefaultReport(mission)), options.Vehicles).ToArray();
        CheckTheyDiffer(
        [
            ("--config", options.Config?.Path), (options.MissionOption, options.MissionFile),
            ("--truth", options.TruthFile), ("--sign-key", options.SignKeyFile),
            ("--progress", options.Operator.ProgressFile), ("--originals", options.Preflight.OriginalsFile),
            ("--summary", options.SummaryFile), .. reports.Select(r => ("--report", (string?)r)),
            ("--log", options.LogFile),
            .. options.Reporting.Exports.Select(e => ("--export", (string?)e)),
        ]);
        if (options.Preflight.SetsFailsafes || options.Preflight.UploadsFence)
            OutputPath.CheckReplaced("--originals", options.Preflight.OriginalsFile);
        return new RunFiles(
            OutputPath.Check("--summary", options.SummaryFile, options.Links),
            reports.Select(r => OutputPath.Check("--report", r, options.Links)!).ToArray(),
            OutputPath.Check("--log", options.LogFile, options.Links),
            options.Reporting.Exports.Select(e => OutputPath.Check("--export", e, options.Links)!).ToArray());
    }

    /// <summary>The name of a mission as the beginning of a file name; empty where nothing of it can be one.</summary>
    public static string StemOf(string mission)
    {
        char[] name = mission.ToLowerInvariant().Select(c => c is >= 'a' and <= 'z' or >= '0' and <= '9' ? c : '-')
            .Take(MaxNameLength).ToArray();
        return new string(name).Trim('-');
    }

    public void Dispose() => Log?.Dispose();

    // Where the report of a mission goes when nothing else is asked for: beside the user, with mission and date, so
    // that no flight overwrites the last one's.
    private static string DefaultReport(string mission)
    {
        string date = DateTime.UtcNow.ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture);
        return $"{StemOf(mission)}-{date}-report.html".TrimStart('-');
    }

    // Beside that of the group each vehicle has its own: of search-report.html search-report-vehicle-1.html and so on.
    // Beside a device no file can be.
    private static IEnumerable<string> ReportsOf(string? report, int vehicles)
    {
        if (report is null)
            return [];
        string end = Path.GetExtension(report);
        string stem = report.Substring(0, report.Length - end.Length); // Mono's Remove refuses a name without an end
        return vehicles == 1 || OutputPath.IsOfDevice(report)
            ? [report]
            : Enumerable.Range(1, vehicles)
                .Select(v => stem + "-vehicle-" + v.ToString(CultureInfo.InvariantCulture) + end).Prepend(report);
    }

    private static void CheckTheyDiffer(IReadOnlyList<(string Option, string? Path)> files)
    {
        IGrouping<string, (string Option, string? Path)>? same = files
            .Where(f => !string.IsNullOrEmpty(f.Path) && !OutputPath.IsOfDevice(f.Path!))
            .GroupBy(f => Path.GetFullPath(f.Path!), StringComparer.Ordinal)
            .FirstOrDefault(g => g.Count() > 1);
        if (same is not null)
            throw new ArgumentException(
                $"{string.Join(" and ", same.Select(f => f.Option))} are the same file {same.First().Path}.",
                nameof(files));
    }
}
