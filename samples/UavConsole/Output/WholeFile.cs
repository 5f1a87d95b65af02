using System;
using System.IO;

namespace UavConsole;

/// <summary>
/// A file that is written once and is then complete, or not there: it is made beside its place and renamed at the end.
/// What was in its place is kept beside it, under its date.
/// </summary>
internal sealed class WholeFile(OutputPath path)
{
    /// <summary>As it was given.</summary>
    public string Path => path.Path;

    /// <summary>Writes it.</summary>
    /// <returns>Why it could not be written, for people; null where it was.</returns>
    public string? Write(byte[] content)
    {
        string next = Path + ".new";
        try
        {
            if (path.IsDevice)
            {
                WriteTo(Path, FileMode.Open, content);
                return null;
            }

            WriteTo(next, FileMode.Create, content);
            DatedFile.Keep(Path);
            File.Move(next, Path);
            return null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            Remove(next);
            return path.CannotBeWritten(e);
        }
    }

    // Without a buffer, so that a full disk shows here and not when the stream is closed.
    private static void WriteTo(string path, FileMode mode, byte[] content)
    {
        using var stream = new FileStream(path, mode, FileAccess.Write, FileShare.Read, bufferSize: 1);
        stream.Write(content, 0, content.Length);
        if (mode == FileMode.Create)
            stream.Flush(flushToDisk: true);
    }

    private static void Remove(string path)
    {
        try
        {
            File.Delete(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            // What is reported is why it could not be written.
        }
    }
}
