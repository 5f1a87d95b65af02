using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>
/// The tests that documents name are there: <c>Class</c>, <c>Class.Method</c>, <c>Class.Method_...</c>, and, behind one
/// of these, <c>..._End</c> or <c>Begin_...</c> of another method of the same class.
/// </summary>
public sealed class DocumentedTestNameTests
{
    private const string Omission = "...";

    private static readonly Regex Quoted = new("`([^`]+)`", RegexOptions.Compiled);
    private static readonly Regex ClassName = new(
        @"^(?<class>\w+(?:Tests|Contract))(?:\.(?<method>(?!cs$)\w+))?(?:\.\.\.)?$", RegexOptions.Compiled);
    private static readonly Regex End = new(@"^\.\.\._(?<end>\w+)$", RegexOptions.Compiled);
    private static readonly Regex Begin = new(@"^(?<begin>\w+_)\.\.\.$", RegexOptions.Compiled);
    private static readonly Regex Declaration = new(
        @"\bclass (?<name>\w+)(?:<\w+>)?(?:\([^)]*\))?(?:\s*:\s*(?<base>\w+))?", RegexOptions.Compiled);
    private static readonly Regex Method = new(@"\b(?:void|Task) (?<name>\w+)\(", RegexOptions.Compiled);

    [Fact]
    public void Tests_NamedInDocuments_AreThere()
    {
        Dictionary<string, HashSet<string>> tests = TestsByClass();
        string[] missing = DocumentFiles.All
            .SelectMany(
                d => SourceFiles.Lines(d)
                    .SelectMany((line, i) => Missing(line, tests).Select(n => $"{d}:{i + 1}: {n}")))
            .ToArray();

        Assert.True(missing.Length == 0, string.Join(Environment.NewLine, missing));
    }

    [Theory]
    [InlineData("| x | `DocumentedTestNameTests.Line_TestThatIsNotThere_...`, `..._IsFound`, `Tests_...` |", 0)]
    [InlineData("| x | `DocumentedTestNameTests.Line_NoSuchTest_IsFound` |", 1)]
    [InlineData("| x | `DocumentedTestNameTests`, `..._NoSuchEnd`, `NoSuchBegin_...` |", 2)]
    [InlineData("| x | `NoSuchClassTests` |", 1)]
    public void Line_TestThatIsNotThere_IsFound(string line, int missing)
        => Assert.Equal(missing, Missing(line, TestsByClass()).Count());

    private static IEnumerable<string> Missing(string line, Dictionary<string, HashSet<string>> tests)
    {
        HashSet<string>? current = null;
        foreach (string quoted in Quoted.Matches(line).Cast<Match>().Select(m => m.Groups[1].Value))
        {
            bool isThere = true;
            if (ClassName.Match(quoted) is { Success: true } named)
            {
                string method = named.Groups["method"].Value;
                isThere = tests.TryGetValue(named.Groups["class"].Value, out current)
                    && IsThere(current, method, quoted);
            }
            else if (current is not null && End.Match(quoted) is { Success: true } end)
            {
                isThere = current.Any(m => m.EndsWith("_" + end.Groups["end"].Value, StringComparison.Ordinal));
            }
            else if (current is not null && Begin.Match(quoted) is { Success: true } begin)
            {
                isThere = current.Any(m => m.StartsWith(begin.Groups["begin"].Value, StringComparison.Ordinal));
            }

            if (!isThere)
                yield return quoted;
        }
    }

    private static bool IsThere(HashSet<string> methods, string method, string quoted)
        => method.Length == 0 || methods.Contains(method)
            || (quoted.EndsWith(Omission, StringComparison.Ordinal)
                && methods.Any(m => m.StartsWith(method, StringComparison.Ordinal)));

    // By the text of the sources: this project does not refer to the others. A file with several classes gives each of
    // them all of its methods, and a class has those of the class that it derives from.
    private static Dictionary<string, HashSet<string>> TestsByClass()
    {
        var methods = new Dictionary<string, HashSet<string>>(StringComparer.Ordinal);
        var bases = new List<(string Class, string Base)>();
        foreach (string text in SourceFiles.Below("tests", "*.cs").Select(SourceFiles.Read))
        {
            string[] names = [.. Method.Matches(text).Cast<Match>().Select(m => m.Groups["name"].Value)];
            foreach (Match declaration in Declaration.Matches(text))
            {
                string name = declaration.Groups["name"].Value;
                if (!methods.TryGetValue(name, out HashSet<string>? found))
                    methods.Add(name, found = new HashSet<string>(StringComparer.Ordinal));
                found.UnionWith(names);
                bases.Add((name, declaration.Groups["base"].Value));
            }
        }

        foreach ((string derived, string basis) in bases.Where(b => methods.ContainsKey(b.Base)))
            methods[derived].UnionWith(methods[basis]);
        return methods;
    }
}
