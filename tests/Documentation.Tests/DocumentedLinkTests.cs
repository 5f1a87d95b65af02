using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>Links between the documents, and from them to files, lead somewhere.</summary>
public sealed class DocumentedLinkTests
{
    private static readonly Regex Link = new(
        @"\]\((?!https?:|mailto:)([^)\s]+)\)", RegexOptions.None, TimeSpan.FromSeconds(5));
    private static readonly Regex Heading = new(@"^#+ +(.+)$", RegexOptions.Multiline, TimeSpan.FromSeconds(5));

    [Fact]
    public void Links_OfAllDocuments_LeadToFilesAndHeadings()
    {
        var dead = new List<string>();
        foreach (string document in DocumentFiles.All)
        {
            foreach (string target in Link.Matches(DocumentFiles.Read(document)).Select(m => m.Groups[1].Value))
            {
                if (!Leads(document, target))
                    dead.Add($"{document}: {target}");
            }
        }

        Assert.True(dead.Count == 0, string.Join(Environment.NewLine, dead));
    }

    private static bool Leads(string document, string target)
    {
        string[] parts = target.Split('#');
        string folder = Path.GetDirectoryName(document)!;
        string path = parts[0].Length == 0 ? document : Path.Combine(folder, parts[0]);
        string full = Path.GetFullPath(Path.Combine(Repository.Root, path));
        if (!File.Exists(full) && !Directory.Exists(full))
            return false;
        return parts.Length == 1 || !File.Exists(full)
            || Slugs(File.ReadAllText(full)).Contains(parts[1], StringComparer.Ordinal);
    }

    // As GitHub makes them: lower case, spaces become hyphens, and of the rest only letters, digits, hyphens and
    // underscores stay.
    private static IEnumerable<string> Slugs(string text) => Heading.Matches(text).Select(m =>
    {
        var slug = new StringBuilder();
        foreach (char c in m.Groups[1].Value.Trim().ToLowerInvariant())
        {
            if (char.IsLetterOrDigit(c) || c is '-' or '_')
                slug.Append(c);
            else if (c == ' ')
                slug.Append('-');
        }

        return slug.ToString();
    });
}
