using System;
using System.IO;

namespace UavConsole;

/// <summary>A fault on standard error: one line that names the program.</summary>
internal static class FaultLine
{
    /// <summary>Writes the line. Where standard error is closed too, the exit code remains.</summary>
    /// <param name="errors">Where to.</param>
    /// <param name="text">What is wrong; its first line is written.</param>
    public static void Write(TextWriter errors, string text) => WriteWhole(errors, FirstOf(text));

    /// <summary>As <see cref="Write"/>, of what is one line.</summary>
    public static void WriteWhole(TextWriter errors, string line)
    {
        try
        {
            errors.WriteLine("UavConsole: " + line);
        }
        catch (IOException)
        {
            // It cannot be read; that is no reason to end in another way.
        }
    }

    // ArgumentException adds the parameter's name on a line or in brackets; a person needs the sentence alone.
    public static string FirstOf(string text)
    {
        int end = text.IndexOf(" (Parameter '", StringComparison.Ordinal);
        if (end < 0)
            end = text.IndexOfAny(['\r', '\n']);
        return end < 0 ? text : text.Substring(0, end);
    }
}
