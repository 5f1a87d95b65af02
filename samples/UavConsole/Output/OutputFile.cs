using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Links;
using Rabit.Uav.Communications;

namespace UavConsole;

/// <summary>
/// A file that a run writes. Opened before the run, so that a wrong path shows at once and not after the flight. What
/// was there before is kept beside it, under its date.
/// </summary>
internal sealed class OutputFile : IDisposable
{
    private readonly string _option;
    private FileStream _stream;
    private bool _hasBegun;

    private OutputFile(string option, string path, FileStream stream)
    {
        _option = option;
        Path = path;
        _stream = stream;
    }

    /// <summary>As it was given.</summary>
    public string Path { get; }

    /// <param name="option">The option that asked for it, for errors.</param>
    /// <param name="path">Null where none was asked for.</param>
    /// <param name="links">A log that is played is never written to.</param>
    /// <returns>Null where none was asked for.</returns>
    /// <exception cref="ArgumentException">It cannot be written.</exception>
    public static OutputFile? Open(string option, string? path, IReadOnlyList<LinkUrl> links)
    {
        if (path is null)
            return null;
        try
        {
            LinkUrl[] logs = links.Where(l => l.Kind == LinkKind.RecordedFile).ToArray();
            string full = System.IO.Path.GetFullPath(path);
            if (Array.Exists(
                logs, l => string.Equals(System.IO.Path.GetFullPath(l.Path!), full, StringComparison.Ordinal)))
                throw new IOException("it is the log that is played.");

            // What was there before stays until there is something to put in its place. One write and no buffer, so
            // that what cannot be written shows there and not at the end.
            var stream = new FileStream(
                path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.ReadWrite, bufferSize: 1);
            if (!Array.Exists(logs, l => IsSameFile(stream, l.Path!)))
                return new OutputFile(option, path, stream);
            stream.Dispose();
            throw new IOException("it is the log that is played.");
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw CannotWrite(option, path, e);
        }
    }

    /// <summary>
    /// Writes what comes next; the first time, what was there before moves aside: NAME.20261122-143000.EXT by the time
    /// of its last change.
    /// </summary>
    /// <exception cref="ArgumentException">It cannot be written.</exception>
    public void Write(byte[] content)
    {
        try
        {
            if (!_hasBegun && _stream.CanSeek && _stream.Length > 0)
                KeepTheOldOne();
            _hasBegun = true;
            _stream.Write(content, 0, content.Length);
            _stream.Flush();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            throw CannotWrite(_option, Path, e);
        }
    }

    public void Dispose() => _stream.Dispose();

    private void KeepTheOldOne()
    {
        _stream.Dispose();
        DatedFile.Keep(Path);
        _stream = new FileStream(
            Path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.ReadWrite, bufferSize: 1);
    }

    // By a link of either kind the log may have a second name; no portable call shows it, but its content does.
    private static bool IsSameFile(FileStream output, string log)
    {
        using var other = new FileStream(log, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        if (!output.CanSeek || output.Length == 0 || output.Length != other.Length)
            return false;
        byte[] ours = Head(output);
        output.Position = 0;
        return ours.SequenceEqual(Head(other));
    }

    private static byte[] Head(FileStream stream)
    {
        var head = new byte[4096];
        int count = stream.Read(head, 0, head.Length);
        return head.Take(count).ToArray();
    }

    private static ArgumentException CannotWrite(string option, string path, Exception e)
        => new($"{option} {path} cannot be written: {e.Message}", nameof(path), e);
}
