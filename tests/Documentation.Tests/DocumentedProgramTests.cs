using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>
/// Every C# block of the pages that users copy from compiles, and runs where it can. A comment on the line before a
/// block says more: <c>runs</c> (and prints the <c>text</c> block that follows, if there is one; commands may stand
/// between them),
/// <c>runs in virtual time</c> (the same with the argument --virtual), <c>test of the program above</c> (its facts
/// pass), <c>part of FILE</c> (it stands in that file, which CI builds).
/// </summary>
public sealed class DocumentedProgramTests
{
    private const string PartOf = "part of ";

    private static readonly string[] Documents =
    [
        "docs/getting-started.md", "docs/how-to.md", "docs/camera-folder.md", "docs/managers/image-processing.md",
        "src/Rabit.Vision/README.md",
    ];

    public static TheoryData<string, int> Blocks()
    {
        var data = new TheoryData<string, int>();
        foreach (string document in Documents)
        {
            foreach (DocumentBlock block in DocumentBlock.Read(document).Where(b => b.Language == "csharp"))
                data.Add(document, block.Line);
        }

        return data;
    }

    [Theory]
    [MemberData(nameof(Blocks))]
    public void Block_OfADocument_CompilesAndDoesWhatItSays(string document, int line)
    {
        IReadOnlyList<DocumentBlock> blocks = DocumentBlock.Read(document);
        int index = blocks.ToList().FindIndex(b => b.Line == line);
        DocumentBlock block = blocks[index];
        switch (block.Marker)
        {
            case "":
                CompiledProgram.Compile(block);
                break;
            case "runs":
                AssertRuns(block, OutputOf(blocks, index));
                break;
            case "runs in virtual time":
                AssertRuns(block, OutputOf(blocks, index), "--virtual");
                break;
            case "test of the program above":
                DocumentBlock program = blocks.Take(index).Last(b => b.Language == "csharp");
                Assert.True(
                    CompiledProgram.RunFacts(CompiledProgram.Compile(program, block)) > 0, $"{block} has no test.");
                break;
            case string part when part.StartsWith(PartOf, StringComparison.Ordinal):
                AssertIsPartOf(block, part.Substring(PartOf.Length));
                break;
            default:
                Assert.Fail($"{block}: the marker '{block.Marker}' is not known.");
                break;
        }
    }

    [Theory]
    [InlineData("Core")]
    [InlineData("Mavlink")]
    [InlineData("Geodesy")]
    [InlineData("Links")]
    [InlineData("Hosting")]
    [InlineData("Uav")]
    [InlineData("Uav.Hosting")]
    [InlineData("Uav.Reporting")]
    [InlineData("Uav.Simulation")]
    public void FirstBlock_OfThePackagesReadme_IsAProgramThatCompiles(string package)
    {
        DocumentBlock block = DocumentBlock.Read($"src/Rabit.{package}/README.md").First(b => b.Language == "csharp");

        Assert.NotNull(CompiledProgram.Compile(block).EntryPoint);
    }

    private static DocumentBlock? OutputOf(IReadOnlyList<DocumentBlock> blocks, int index)
        => blocks.Skip(index + 1).SkipWhile(b => b.Language == "sh").FirstOrDefault() is { Language: "text" } output
            ? output
            : null;

    private static void AssertRuns(DocumentBlock block, DocumentBlock? output, params string[] args)
    {
        (string printed, int exitCode) = CompiledProgram.Run(CompiledProgram.Compile(block), args);
        Assert.Equal(0, exitCode);
        if (output is not null)
            Assert.Equal(output.Text, printed);
    }

    private static void AssertIsPartOf(DocumentBlock block, string file)
    {
        string[] lines = File.ReadAllLines(Path.Combine(Repository.Root, file)).Select(l => l.Trim())
            .Where(l => l.Length > 0).ToArray();
        string[] part = block.Text.Split('\n').Select(l => l.Trim()).Where(l => l.Length > 0).ToArray();
        bool isPart = Enumerable.Range(0, Math.Max(0, lines.Length - part.Length + 1))
            .Any(at => lines.Skip(at).Take(part.Length).SequenceEqual(part, StringComparer.Ordinal));
        Assert.True(isPart, $"{block} does not stand in {file}.");
    }
}
