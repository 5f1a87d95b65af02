using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Mavlink;

namespace MavlinkDump;

/// <summary>The main job: reads the log from end to end, one record at a time, and gives each to the output.</summary>
internal static class DumpRun
{
    private const int OutputBuffer = 64 * 1024;

    public static int Run(DumpOptions options)
    {
        try
        {
            using FileStream file = Open(options.File);
            using Stream stdout = Console.OpenStandardOutput();
            using var buffered = new BufferedStream(stdout, OutputBuffer);
            int exitCode = Dump(options, file, buffered);
            buffered.Flush();
            return exitCode;
        }
        catch (DumpException e)
        {
            return Refuse(e.Message);
        }
        catch (IOException e)
        {
            return Refuse("the output cannot be written: " + e.Message);
        }
    }

    private static int Dump(DumpOptions options, FileStream file, Stream output)
    {
        var log = new TlogReader(file, MavlinkDialect.All);
        using var text = new StreamWriter(output, new UTF8Encoding(false), 1024, leaveOpen: true) { NewLine = "\n" };
        IDumpOutput dump = CreateOutput(options, text, output);
        long shown = 0;
        // a pipe has no length
        using (ProgressBar progress = ProgressBar.Start(options, file.CanSeek ? file.Length : 0))
        {
            while (TryRead(log, options.File, out MavlinkFrame frame, out TlogRecord record))
            {
                progress.Show(log.Position);
                if (!IsWanted(options, frame))
                    continue;
                dump.Add(frame, record);
                shown++;
            }
        }

        if (log.End is TlogEnd.Empty or TlogEnd.NoRecord)
            throw new DumpException(
                $"{options.File}: {(log.End == TlogEnd.Empty ? "the file is empty" : "no intact record in it: it is no telemetry log")}.");
        dump.Finish(log);
        text.Flush();
        return Conclude(options, log, shown);
    }

    private static bool TryRead(TlogReader log, string path, out MavlinkFrame frame, out TlogRecord record)
    {
        try
        {
            return log.TryRead(out frame, out record);
        }
        catch (IOException e)
        {
            throw new DumpException($"{path}: the file cannot be read: {e.Message}");
        }
    }

    private static int Conclude(DumpOptions options, TlogReader log, long shown)
    {
        if (log.LostBytes > 0 && options.Format != DumpFormat.Table)
            Console.Error.WriteLine(FormattableString.Invariant(
                $"MavlinkDump: {options.File}: {log.LostBytes} bytes belong to no intact record, the first at offset {log.FirstDamageOffset}."));
        if (shown > 0)
            return ExitCodes.Done;
        Console.Error.WriteLine(string.Format(
            CultureInfo.InvariantCulture, "MavlinkDump: {0}: none of its {1} records is what was asked for.",
            options.File, log.Records));
        return ExitCodes.NothingFound;
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
            throw new DumpException($"{path}: that is a folder.");
        try
        {
            return new FileStream(
                path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite, 1, FileOptions.SequentialScan);
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new DumpException($"{path}: no such file.");
        }
        catch (Exception e)
            when (e is UnauthorizedAccessException or IOException or ArgumentException or NotSupportedException)
        {
            throw new DumpException($"{path}: the file cannot be read: {e.Message}");
        }
    }

    private static int Refuse(string reason)
    {
        Console.Error.WriteLine("MavlinkDump: " + reason);
        return ExitCodes.BadInput;
    }
}
