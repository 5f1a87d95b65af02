using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Rabit.Tests.Shared;

/// <summary>
/// The examples in XML documentation, as they are in the sources. A test project holds the same lines in a file of its
/// own, which the compiler checks, and compares.
/// </summary>
internal static class DocumentationExamples
{
    /// <summary>The lines of each <c>code</c> element below a folder of the repository, without indentation.</summary>
    public static IEnumerable<(string File, string[] Lines)> Find(params string[] folder)
    {
        string root = Path.Combine([Repository.Root, .. folder]);
        foreach (string file
            in Directory.GetFiles(root, "*.cs", SearchOption.AllDirectories).OrderBy(f => f, StringComparer.Ordinal))
        {
            List<string>? code = null;
            foreach (string line in File.ReadLines(file).Select(l => l.Trim()))
            {
                if (line == "/// <code>")
                    code = [];
                else if (line == "/// </code>" && code is not null)
                    yield return (file.Substring(root.Length + 1), TakeAll(ref code));
                else if (line.StartsWith("///", StringComparison.Ordinal))
                    code?.Add(Unescape(line.Substring(3).Trim()));
            }
        }
    }

    /// <summary>The lines of a source file, without indentation and empty ones.</summary>
    public static string[] LinesOf(params string[] path)
        => [.. File.ReadLines(Path.Combine([Repository.Root, .. path])).Select(l => l.Trim()).Where(l => l.Length > 0)];

    /// <summary>Whether some lines follow each other in a file; empty lines do not count.</summary>
    public static bool Contain(string[] file, string[] lines)
    {
        string[] wanted = [.. lines.Where(l => l.Length > 0)];
        return Enumerable.Range(0, Math.Max(0, file.Length - wanted.Length + 1))
            .Any(i => file.Skip(i).Take(wanted.Length).SequenceEqual(wanted));
    }

    private static string[] TakeAll(ref List<string>? code)
    {
        string[] lines = [.. code!];
        code = null;
        return lines;
    }

    private static string Unescape(string text) => text.Replace("&lt;", "<").Replace("&gt;", ">").Replace("&amp;", "&");
}
