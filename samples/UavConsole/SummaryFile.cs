using System;
using System.IO;
using System.Linq;
using Rabit.Uav.Links;

namespace UavConsole;

/// <summary>Where the summary goes as JSON. Opened before the run, so that a wrong path shows at once and not after the flight.</summary>
internal sealed class SummaryFile : IDisposable
{
    private readonly string _path;
    private readonly FileStream _stream;

    private SummaryFile(string path, FileStream stream)
    {
        _path = path;
        _stream = stream;
    }

    /// <returns>Null where none was asked for.</returns>
    /// <exception cref="ArgumentException">It cannot be written.</exception>
    public static SummaryFile? Open(ConsoleOptions options)
    {
        if (options.SummaryFile is not { } path)
            return null;
        try
        {
            string full = Path.GetFullPath(path);
            if (options.Links.Any(l => l.Kind == LinkKind.RecordedFile && string.Equals(Path.GetFullPath(l.Path!), full, StringComparison.Ordinal)))
                throw new IOException("it is the log that is played.");

            // One write into it and no buffer, so that what cannot be written shows there and not at the end.
            return new SummaryFile(path, new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.Read, bufferSize: 1));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw CannotWrite(path, e);
        }
    }

    /// <exception cref="ArgumentException">It cannot be written.</exception>
    public void Write(RunSummary summary)
    {
        using var text = new MemoryStream();
        SummaryJson.Write(text, summary);
        try
        {
            _stream.Write(text.ToArray(), 0, (int)text.Length);
            _stream.Flush();
        }
        catch (IOException e)
        {
            throw CannotWrite(_path, e);
        }
    }

    public void Dispose() => _stream.Dispose();

    private static ArgumentException CannotWrite(string path, Exception e) => new($"--summary {path} cannot be written: {e.Message}", nameof(path), e);
}
