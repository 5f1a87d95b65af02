using System.IO;

namespace UavConsole;

/// <summary>Files that people write.</summary>
internal static class TextFile
{
    /// <summary>
    /// The text of a file; no more than a file of its kind has: a device or a video given by mistake has no end.
    /// </summary>
    /// <exception cref="IOException">It cannot be read, or is longer.</exception>
    public static string Read(string path)
    {
        const int MaxLength = 4_000_000;
        using var reader = new StreamReader(path);
        var text = new char[MaxLength + 1];
        int length = reader.ReadBlock(text, 0, text.Length);
        return length <= MaxLength
            ? new string(text, 0, length)
            : throw new IOException($"it is longer than {MaxLength} characters.");
    }
}
