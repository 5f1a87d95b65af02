using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Documentation.Tests;

/// <summary>
/// Code and documents do not use the words of eng/word-list.txt. eng/words-check.sh prints the same without a build.
/// </summary>
public sealed class WordListTests(ITestOutputHelper output)
{
    private const string WordList = "eng/word-list.txt";

    private static readonly Regex Entry = new(
        "^(?<kind>word|name|allow) (?<pattern>.+) => (?<text>.+)$", RegexOptions.Compiled);

    [Fact]
    public void List_EachLine_IsAnEntryWithAReason()
        => Assert.All(
            SourceFiles.Lines(WordList).Where(l => l.Length > 0 && l[0] != '#'),
            line => Assert.True(Entry.IsMatch(line), $"'{line}' is not 'word|name|allow PATTERN => TEXT'."));

    [Fact]
    public void Words_OfTheList_AreNotUsed()
    {
        string[] code =
            [.. new[] { "src", "samples", "tests", "benchmarks" }.SelectMany(f => SourceFiles.Below(f, "*.cs"))];
        string[] documents =
        [
            .. new[] { "docs", "src", "benchmarks" }.SelectMany(f => SourceFiles.Below(f, "*.md")), "README.md",
            "CONTRIBUTING.md",
        ];
        string[] faults = [.. Find(Entries("word"), [.. code, .. documents]), .. Find(Entries("name"), code)];

        output.WriteLine($"{faults.Length} lines");
        output.WriteLine(string.Join("\n", faults));
        Assert.True(faults.Length == 0, string.Join("\n", faults));
    }

    private static List<(Regex Pattern, string Instead)> Entries(string kind)
        => SourceFiles.Lines(WordList).Select(l => Entry.Match(l))
            .Where(m => m.Success && string.Equals(m.Groups["kind"].Value, kind, StringComparison.Ordinal))
            .Select(m => (PatternOf(kind, m.Groups["pattern"].Value), m.Groups["text"].Value)).ToList();

    private static Regex PatternOf(string kind, string pattern)
        => kind == "word" ? new Regex($@"\b(?:{pattern})\b", RegexOptions.IgnoreCase) : new Regex(pattern);

    private static IEnumerable<string> Find(List<(Regex Pattern, string Instead)> entries, IEnumerable<string> files)
    {
        List<(Regex Pattern, string Instead)> allowed = Entries("allow");

        // Nearly every line has none of them, and one look finds that out.
        var any = new Regex(
            string.Join("|", entries.Select(e => $"(?:{e.Pattern})")),
            entries[0].Pattern.Options | RegexOptions.Compiled);
        foreach (string file in files)
        {
            string[] lines = SourceFiles.Lines(file);
            for (int i = 0; i < lines.Length; i++)
            {
                if (!any.IsMatch(lines[i]))
                    continue;
                string place = $"{file}:{i + 1}:{lines[i]}";
                foreach ((Regex pattern, string instead) in entries.Where(e => e.Pattern.IsMatch(lines[i])))
                {
                    if (!allowed.Any(a => a.Pattern.IsMatch(place)))
                        yield return $"{place}   [{pattern} => {instead}]";
                }
            }
        }
    }
}
