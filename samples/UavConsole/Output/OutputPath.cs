using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Links;

namespace UavConsole;

/// <summary>
/// Where a run writes a file, checked before the run: a wrong path shows at once, not after the flight.
/// </summary>
internal sealed class OutputPath
{
    private readonly string _option;

    private OutputPath(string option, string path) => (_option, Path) = (option, path);

    /// <summary>As it was given.</summary>
    public string Path { get; }

    /// <summary>Whether it is written as it stands: a device has no name to be renamed to.</summary>
    public bool IsDevice => IsOfDevice(Path);

    public static bool IsOfDevice(string path) => path.StartsWith("/dev/", StringComparison.Ordinal);

    /// <summary>Checks a path. What is there stays as it is, and what is not there does not come to be.</summary>
    /// <param name="option">The option that asked for it, for errors.</param>
    /// <param name="path">Null where none was asked for.</param>
    /// <param name="links">A log that is played is never written to.</param>
    /// <returns>Null where none was asked for.</returns>
    /// <exception cref="ArgumentException">It cannot be written.</exception>
    public static OutputPath? Check(string option, string? path, IReadOnlyList<LinkUrl> links)
    {
        if (path is null)
            return null;
        var output = new OutputPath(option, path);
        try
        {
            Check(path, links.Where(l => l.Kind == LinkKind.RecordedFile).Select(l => l.Path!).ToArray());
            return output;
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new ArgumentException(output.CannotBeWritten(e), nameof(path), e);
        }
    }

    /// <summary>Checks the path of a file that is replaced by renaming, which a device is not.</summary>
    /// <exception cref="ArgumentException">It cannot be written.</exception>
    public static void CheckReplaced(string option, string path)
    {
        Check(option, path, []);
        if (IsOfDevice(path))
            throw new ArgumentException($"{option} {path} cannot be written: it is a device.", nameof(path));
    }

    /// <summary>Why it cannot be written, for people.</summary>
    public string CannotBeWritten(Exception e) => $"{_option} {Path} cannot be written: {e.Message}";

    private static void Check(string path, string[] logs)
    {
        string full = System.IO.Path.GetFullPath(path);
        bool isThere = File.Exists(full);
        if (Array.Exists(logs, l => string.Equals(System.IO.Path.GetFullPath(l), full, StringComparison.Ordinal)))
            throw new IOException("it is the log that is played.");
        using (var stream = new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.ReadWrite))
        {
            if (isThere && Array.Exists(logs, l => IsSameFile(stream, l)))
                throw new IOException("it is the log that is played.");
        }

        if (!isThere)
            File.Delete(full);
    }

    // By a link of either kind the log may have a second name; no portable call shows it, but its content does.
    private static bool IsSameFile(FileStream output, string log)
    {
        using var other = new FileStream(log, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        if (!output.CanSeek || output.Length == 0 || output.Length != other.Length)
            return false;
        output.Position = 0;
        return Head(output).SequenceEqual(Head(other));
    }

    private static byte[] Head(FileStream stream)
    {
        var head = new byte[4096];
        int count = stream.Read(head, 0, head.Length);
        return head.Take(count).ToArray();
    }
}
