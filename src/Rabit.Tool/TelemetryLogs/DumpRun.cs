using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Mavlink;

namespace Rabit.Tool.TelemetryLogs;

/// <summary>The main job: reads the log from end to end, one record at a time, and gives each to the output.</summary>
internal static class DumpRun
{
    private const int OutputBuffer = 64 * 1024;

    /// <returns>The exit code.</returns>
    public static int Run(DumpOptions options, TextWriter errors)
    {
        using FileStream file = Open(options.File);

        // Not disposed, which would write what is left in it a second time to an output that takes no more.
        var output = new BufferedStream(StandardOutput.Open(), OutputBuffer);
        int exitCode = Dump(options, file, output, errors);
        output.Flush();
        return exitCode;
    }

    private static int Dump(DumpOptions options, FileStream file, Stream output, TextWriter errors)
    {
        var log = new TlogReader(file, MavlinkDialect.All);
        var text = new StreamWriter(output, new UTF8Encoding(false), 1024, leaveOpen: true) { NewLine = "\n" };
        IDumpOutput dump = CreateOutput(options, text, output);
        using var interruption = new Interruption();
        long shown;
        try
        {
            shown = Read(options, file, log, dump, interruption, Flush);
        }
        catch (ToolException)
        {
            // What was read of a file that breaks off is shown.
            Flush();
            throw;
        }

        if (interruption.IsRequested)
        {
            Flush();
            return ToolExitCode.Interrupted;
        }

        if (log.End is TlogEnd.Empty or TlogEnd.NoRecord)
            throw new ToolException(
                $"{options.File}: {(log.End == TlogEnd.Empty ? "the file is empty" : "no intact record in it: it is no telemetry log")}.");
        dump.Finish(log);
        text.Flush();
        return Conclude(options, log, shown, errors);

        void Flush()
        {
            text.Flush();
            output.Flush();
        }
    }

    /// <returns>How many records were shown.</returns>
    private static long Read(
        DumpOptions options, FileStream file, TlogReader log, IDumpOutput dump, Interruption interruption,
        Action flush)
    {
        long shown = 0;

        // No bar where lines of ours run over the same screen. A pipe has no length.
        bool isFree = options.Format == DumpFormat.Table || Console.IsOutputRedirected;
        using ProgressBar progress = ProgressBar.Start(file.CanSeek && isFree ? file.Length : 0);
        while (!interruption.IsRequested && TryRead(log, options.File, out MavlinkFrame frame, out TlogRecord record))
        {
            progress.Show(log.Position);
            if (!IsWanted(options, frame))
                continue;
            dump.Add(frame, record);
            shown++;
            if (!file.CanSeek)
                flush();   // what comes through a pipe may come live
        }

        return shown;
    }

    private static bool TryRead(TlogReader log, string path, out MavlinkFrame frame, out TlogRecord record)
    {
        try
        {
            return log.TryRead(out frame, out record);
        }
        catch (IOException e)
        {
            throw new ToolException($"{path}: the file cannot be read: {e.Message}", e);
        }
    }

    private static int Conclude(DumpOptions options, TlogReader log, long shown, TextWriter errors)
    {
        if (log.LostBytes > 0 && options.Format != DumpFormat.Table)
            errors.WriteLine(FormattableString.Invariant(
                $"rabit mavlink: {options.File}: {log.LostBytes} bytes belong to no intact record, the first at offset {log.FirstDamageOffset}."));
        if (shown > 0)
            return ToolExitCode.Done;
        errors.WriteLine(string.Format(
            CultureInfo.InvariantCulture, "rabit mavlink: {0}: none of its {1} records is what was asked for.",
            options.File, log.Records));
        return ToolExitCode.NotFound;
    }

    private static IDumpOutput CreateOutput(DumpOptions options, TextWriter text, Stream output)
        => options.Format switch
        {
            DumpFormat.Lines => new LineOutput(text, new LoggedEventTexts(options.EventsFile)),
            DumpFormat.Csv => new CsvOutput(text, options.MessageIds.First()),
            DumpFormat.Json => new JsonOutput(output, new LoggedEventTexts(options.EventsFile)),
            _ => new TableOutput(text, options.File),
        };

    private static bool IsWanted(DumpOptions options, in MavlinkFrame frame) =>
        (options.SystemId is null || options.SystemId == frame.SystemId)
        && (options.ComponentId is null || options.ComponentId == frame.ComponentId)
        && (options.MessageIds.Count == 0 || options.MessageIds.Contains(frame.MessageId));

    private static FileStream Open(string path)
    {
        if (Directory.Exists(path))
            throw new ToolException($"{path}: that is a folder.");
        try
        {
            return new FileStream(
                path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite, 1, FileOptions.SequentialScan);
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new ToolException($"{path}: no such file.", e);
        }
        catch (Exception e)
            when (e is UnauthorizedAccessException or IOException or ArgumentException or NotSupportedException)
        {
            throw new ToolException($"{path}: the file cannot be read: {e.Message}", e);
        }
    }
}
