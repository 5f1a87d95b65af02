using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Documentation.Tests;

/// <summary>Lines of code have at most 120 columns.</summary>
public sealed class LineLengthTests(ITestOutputHelper output)
{
    private const int MaxColumns = 120;

    // False until the whole tree has been formatted; then a longer line fails.
    private const bool IsEnforced = false;

    private static readonly string[] Folders = ["src", "samples", "tests", "benchmarks"];

    [Fact]
    public void Lines_OfTheCode_AreNotLongerThanTheLimit()
    {
        string[] faults = Folders.SelectMany(folder => SourceFiles.Below(folder, "*.cs"))
            .SelectMany(LongLines).ToArray();
        output.WriteLine($"{faults.Length} lines are longer than {MaxColumns} columns.");
        output.WriteLine(string.Join("\n", faults));
        Assert.True(!IsEnforced || faults.Length == 0, string.Join("\n", faults));
    }

    private static IEnumerable<string> LongLines(string file)
        => SourceFiles.Lines(file).Select((line, index) => (line, index)).Where(l => l.line.Length > MaxColumns)
            .Select(l => $"{file}:{l.index + 1}: {l.line.Length}");
}
