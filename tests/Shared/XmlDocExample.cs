using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Text;
using System.Text.RegularExpressions;

namespace Rabit.Tests.Shared;

/// <summary>One <c>&lt;example&gt;&lt;code&gt;</c> of the documentation comments of a source file.</summary>
internal sealed class XmlDocExample
{
    private static readonly Regex Example = ContentOf("example");
    private static readonly Regex Code = ContentOf("code");

    private XmlDocExample(string file, int line, string text)
    {
        File = file;
        Line = line;
        Text = text;
    }

    /// <summary>Path from the root of the repository.</summary>
    public string File { get; }

    /// <summary>Line of the comment that it is in.</summary>
    public int Line { get; }

    /// <summary>The code, its entities resolved.</summary>
    public string Text { get; }

    /// <summary>Finds all examples of the sources in a folder and the folders below.</summary>
    /// <param name="folder">From the root of the repository.</param>
    public static IReadOnlyList<XmlDocExample> In(string folder) =>
        [.. Directory.EnumerateFiles(Path.Combine(Repository.Root, folder), "*.cs", SearchOption.AllDirectories)
            .Where(
                file => !file.Contains(
                    $"{Path.DirectorySeparatorChar}obj{Path.DirectorySeparatorChar}", StringComparison.Ordinal))
            .OrderBy(file => file, StringComparer.Ordinal)
            .SelectMany(Of)];

    public override string ToString() => $"{File}({Line})";

    private static Regex ContentOf(string element) => new(
        $"<{element}>(?<content>.*?)</{element}>",
        RegexOptions.Singleline | RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        TimeSpan.FromSeconds(10));

    private static IEnumerable<XmlDocExample> Of(string path)
    {
        string file = path.Substring(Repository.Root.Length + 1).Replace('\\', '/');
        foreach ((int line, string comment) in CommentsOf(System.IO.File.ReadAllLines(path)))
        {
            foreach (Match example in Example.Matches(comment))
            {
                foreach (Match code in Code.Matches(example.Groups["content"].Value))
                    yield return new XmlDocExample(
                        file, line, WebUtility.HtmlDecode(code.Groups["content"].Value).Trim('\n'));
            }
        }
    }

    // The documentation comments, each with the number of its first line.
    private static IEnumerable<(int Line, string Text)> CommentsOf(string[] lines)
    {
        var text = new StringBuilder();
        int first = 0;
        for (int index = 0; index <= lines.Length; index++)
        {
            string line = index < lines.Length ? lines[index].TrimStart() : "";
            if (line.StartsWith("///", StringComparison.Ordinal))
            {
                if (text.Length == 0)
                    first = index + 1;
                text.Append(line.Length > 4 ? line.Substring(4) : "").Append('\n');
            }
            else if (text.Length > 0)
            {
                yield return (first, text.ToString());
                text.Clear();
            }
        }
    }
}
