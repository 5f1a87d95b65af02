using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>
/// A search for a type finds one: no two types of the same name, public or internal, in different places of src/,
/// samples/ and benchmarks/. Parts of a partial type, and overloads by the number of type parameters, lie in one
/// folder.
/// </summary>
public sealed class TypeNameTests
{
    private const string AllowList = "eng/same-type-names.txt";

    private static readonly Regex Declaration = new(
        @"^(?:(?:public|internal|file|abstract|sealed|static|partial|readonly|ref|unsafe)\s+)*"
        + @"(?:class|struct|interface|enum|record(?:\s+struct)?|delegate\s+[\w<>?,\[\]]+)\s+(?<name>\w+)",
        RegexOptions.Compiled);

    [Fact]
    public void Types_OfOneName_AreInOnePlace()
    {
        Dictionary<string, string> allowed = ReasonedList.Read(AllowList);
        var faults = new List<string>();
        foreach (IGrouping<string, (string Name, string Folder)> type in Types().Distinct()
            .GroupBy(t => t.Name, StringComparer.Ordinal))
        {
            bool isAllowed = allowed.Remove(type.Key);
            if (type.Count() > 1 && !isAllowed)
                faults.Add($"{type.Key}: {string.Join(", ", type.Select(t => t.Folder))}");
            else if (type.Count() == 1 && isAllowed)
                faults.Add($"{type.Key} is in {AllowList}, and there is only one.");
        }

        faults.AddRange(allowed.Keys.Select(name => $"{name} is in {AllowList}, and there is none."));
        faults.Sort(StringComparer.Ordinal);
        Assert.True(faults.Count == 0, "Types of one name in different places:\n" + string.Join("\n", faults));
    }

    // Types inside others have an indent, except in a program whose first lines are statements; those are its own.
    private static IEnumerable<(string Name, string Folder)> Types()
    {
        string[] folders = ["src", "samples", "benchmarks"];
        foreach (string file in folders.SelectMany(f => SourceFiles.Below(f, "*.cs")))
        {
            string folder = file.Substring(0, file.LastIndexOf('/'));
            foreach (string line in SourceFiles.Lines(file))
            {
                if (Declaration.Match(line) is { Success: true } type)
                    yield return (type.Groups["name"].Value, folder);
            }
        }
    }
}
