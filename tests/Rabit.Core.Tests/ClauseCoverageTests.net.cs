using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests;

/// <summary>
/// The table of the clauses in the docs. Some test classes are of .NET alone, so the table is compared there.
/// </summary>
public sealed partial class ClauseCoverageTests
{
    /// <summary>With RABIT_UPDATE_CONTRACT=1 the table is written instead.</summary>
    [Fact]
    public void Table_OfTheDocs_NamesTheTestsOfEachClause()
    {
        string file = Path.Combine(Repository.Root, "docs", "concepts", "contract.md");
        string[] lines = File.ReadAllLines(file);
        string[] expected = Array.ConvertAll(lines, WithTests);
        if (string.Equals(Environment.GetEnvironmentVariable("RABIT_UPDATE_CONTRACT"), "1", StringComparison.Ordinal))
            File.WriteAllText(file, string.Join("\n", expected) + "\n");

        Assert.Equal(DueClauses, expected.Select(ClauseOf).OfType<string>());
        Assert.Equal(expected, File.ReadAllLines(file));
    }

    private static string? ClauseOf(string line)
        => line.Split('|') is { Length: 5 } cells && cells[1].Trim() is { Length: > 2 } clause
            && char.IsDigit(clause[0])
            ? clause
            : null;

    private static string WithTests(string line)
    {
        if (ClauseOf(line) is not { } clause)
            return line;
        IEnumerable<string> tests = Tests().Where(t => t.Clause == clause)
            .Select(t => typeof(ContractTests).IsAssignableFrom(t.Type) ? t.Type.BaseType! : t.Type)
            .Select(type => "`" + type.Name + "`")
            .Distinct()
            .OrderBy(name => name, StringComparer.Ordinal);
        string[] cells = line.Split('|');
        string[] benchmarks = cells[3].Split(';').Select(c => c.Trim())
            .Where(c => c.StartsWith("bench: ", StringComparison.Ordinal)).ToArray();
        cells[3] = " " + string.Join("; ", new[] { string.Join(", ", tests) }.Concat(benchmarks)) + " ";
        return string.Join("|", cells);
    }
}
