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

            // What was there before stays until there is something to put in its place. One write and no buffer, so that what cannot
            // be written shows there and not at the end.
            var stream = new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.ReadWrite, bufferSize: 1);
            if (!options.Links.Any(l => l.Kind == LinkKind.RecordedFile && IsSameFile(stream, l.Path!)))
                return new SummaryFile(path, stream);
            stream.Dispose();
            throw new IOException("it is the log that is played.");
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
            if (_stream.CanSeek && _stream.Length > 0)
                _stream.SetLength(0);
            _stream.Write(text.ToArray(), 0, (int)text.Length);
            _stream.Flush();
        }
        catch (IOException e)
        {
            throw CannotWrite(_path, e);
        }
    }

    public void Dispose() => _stream.Dispose();

    // By a link of either kind the log may have a second name; no portable call tells, but its content does.
    private static bool IsSameFile(FileStream summary, string log)
    {
        using var other = new FileStream(log, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        if (!summary.CanSeek || summary.Length == 0 || summary.Length != other.Length)
            return false;
        byte[] ours = Head(summary);
        summary.Position = 0;
        return ours.SequenceEqual(Head(other));
    }

    private static byte[] Head(FileStream stream)
    {
        var head = new byte[4096];
        int count = stream.Read(head, 0, head.Length);
        return head.Take(count).ToArray();
    }

    private static ArgumentException CannotWrite(string path, Exception e) => new($"--summary {path} cannot be written: {e.Message}", nameof(path), e);
}
