using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Documentation.Tests;

/// <summary>
/// docs/glossary.md: its links lead somewhere, and the search terms of the field find the right file.
/// </summary>
public sealed class GlossaryTests(ITestOutputHelper output)
{
    private const string Page = "docs/glossary.md";
    private const int MinTerms = 80;
    private const int MinBehaviours = 14;

    // A name is read before the text of a file.
    private const int HitsOfAName = 10;

    private static readonly Regex Link = new(@"\]\((?<target>[^)#:]+)\)", RegexOptions.Compiled);
    private static readonly Regex Term = new(@"^\| [^|]+ \| [^|]+ \| .*\[.+\| .+ \|$", RegexOptions.Compiled);
    private static readonly Regex Search = new(
        @"^\| .+ \| `(?<term>[^`]+)` \| `(?<file>[^`]+)` \|$", RegexOptions.Compiled | RegexOptions.Multiline);

    [Fact]
    public void Terms_OfTheGlossary_AreEnough()
        => Assert.InRange(SourceFiles.Lines(Page).Count(l => Term.IsMatch(l)), MinTerms, int.MaxValue);

    [Fact]
    public void Links_OfTheGlossary_LeadToAFileOrFolder()
    {
        if (GeneratedBlock.Updates)
            RepairLinks();
        string[] dead = Link.Matches(SourceFiles.Read(Page)).Cast<Match>()
            .Select(m => m.Groups["target"].Value).Where(t => !Exists(t)).ToArray();
        Assert.True(
            dead.Length == 0,
            $"Not there: {string.Join(", ", dead)}. RABIT_UPDATE_DOCS=1 corrects links to files that only moved.");
    }

    [Fact]
    public void SearchTerms_OfTheField_FindTheRightFileAmongTheFirstThree()
    {
        (string Term, string File)[] searches = Search.Matches(SourceFiles.Read(Page)).Cast<Match>()
            .Select(m => (m.Groups["term"].Value, m.Groups["file"].Value)).ToArray();
        Assert.InRange(searches.Length, MinBehaviours, int.MaxValue);

        // The simulated vehicle has the autopilots' failsafes and batteries, which is not what is looked for.
        Dictionary<string, string> texts = SourceFiles.Below("src", "*.cs").Concat(SourceFiles.Below("samples", "*.cs"))
            .Where(f => !f.Contains("Rabit.Uav.Simulation/Autopilot", StringComparison.Ordinal))
            .ToDictionary(f => f, SourceFiles.Read, StringComparer.Ordinal);

        string[] misses = searches.Select(s => FindMiss(s.Term, s.File, texts)).OfType<string>().ToArray();
        Assert.True(misses.Length == 0, string.Join(Environment.NewLine, misses));
    }

    private string? FindMiss(string term, string file, Dictionary<string, string> texts)
    {
        // "CRC_EXTRA" finds CrcExtra, and "return to launch" ReturnToLaunch.
        string pattern = string.Join(@"[\s_-]*", Regex.Split(term, @"[\s_-]+").Select(Regex.Escape));
        var words = new Regex(pattern, RegexOptions.IgnoreCase);
        (string Name, int Hits)[] found = texts
            .Select(t => (Name: Path.GetFileName(t.Key), Text: t.Value))
            .Select(t => (t.Name, words.Count(t.Text) + (words.IsMatch(t.Name) ? HitsOfAName : 0)))
            .OrderByDescending(f => f.Item2).ToArray();
        string first = string.Join(", ", found.Take(5).Select(f => $"{f.Name} {f.Hits}"));
        output.WriteLine($"{term}: {first}");
        int hits = found.Where(f => string.Equals(f.Name, file, StringComparison.Ordinal))
            .Select(f => f.Hits).DefaultIfEmpty(0).Max();
        return hits > 0 && found.Count(f => f.Hits > hits) < 3
            ? null
            : $"'{term}' should find {file}, which has {hits} hits; it finds {first}";
    }

    private static bool Exists(string target)
    {
        string path = Path.Combine(Repository.Root, "docs", target);
        return File.Exists(path) || Directory.Exists(path);
    }

    private static void RepairLinks()
    {
        ILookup<string, string> files = SourceFiles.Below("src", "*.*").Concat(SourceFiles.Below("docs", "*.md"))
            .ToLookup(f => Path.GetFileName(f));
        string text = Link.Replace(SourceFiles.Read(Page), match =>
        {
            string target = match.Groups["target"].Value;
            string[] places = files[Path.GetFileName(target)].ToArray();
            return Exists(target) || places.Length != 1 ? match.Value : $"](../{places[0]})";
        });
        File.WriteAllText(Path.Combine(Repository.Root, Page), text);
    }
}
