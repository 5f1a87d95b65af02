using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Mavlink.Tests.Docs;

/// <summary>What the documents show compiles as it stands.</summary>
public class DocumentedCodeTests
{
    private const int LongestLoop = 15;

    // What a document may leave out: it says of each type which package it is from.
    private const string Usings = "using System; using System.Diagnostics; using System.IO; using Rabit.Mavlink; using Rabit.Mavlink.Messages;";

    private const string TimestampStore =
        "sealed class FileTimestampStore(string path) : IMavlinkTimestampStore { public int Read(int slot, Span<byte> r) => path.Length; public bool Write(int slot, ReadOnlySpan<byte> r) => true; }";

    [Theory]
    [InlineData("src/Rabit.Mavlink/README.md", 3)]
    [InlineData("docs/concepts/signing.md", 3)]
    [InlineData("docs/mavlink/protocols.md", 1)]
    public void EveryProgram_OfTheDocument_Compiles(string document, int programs)
    {
        List<string> blocks = BlocksOf(document);
        Assert.Equal(programs, blocks.Count);
        Assert.All(blocks, block => AssertCompiles(block));
    }

    [Fact]
    public void ReceiveAndSend_OfTheReadme_HaveFifteenLinesAtMost()
    {
        List<string> blocks = BlocksOf("src/Rabit.Mavlink/README.md");
        string[] loops = [.. blocks.Where(block => block.Contains("TcpClient", StringComparison.Ordinal))];
        Assert.Equal(2, loops.Length);
        Assert.All(loops, loop => Assert.InRange(loop.Split('\n').Count(line => line.Trim().Length > 0), 1, LongestLoop));
    }

    private static List<string> BlocksOf(string document)
    {
        var blocks = new List<string>();
        List<string>? block = null;
        foreach (string line in File.ReadLines(Path.Combine(Repository.Root, document)))
        {
            if (block is not null && line == "```")
            {
                blocks.Add(string.Join("\n", block));
                block = null;
            }
            else if (block is not null)
            {
                block.Add(line);
            }
            else if (line == "```csharp")
            {
                block = [];
            }
        }

        return blocks;
    }

    private static void AssertCompiles(string program)
    {
        bool usesStore = program.Contains("FileTimestampStore", StringComparison.Ordinal) && !program.Contains("class FileTimestampStore", StringComparison.Ordinal);
        List<SyntaxTree> trees = [Parse("global " + Usings.Replace("; ", "; global ", StringComparison.Ordinal)), Parse(program)];
        if (usesStore)
            trees.Add(Parse(TimestampStore));
        var compilation = CSharpCompilation.Create(
            "Documented", trees, References(), new CSharpCompilationOptions(OutputKind.ConsoleApplication, nullableContextOptions: NullableContextOptions.Enable));
        using var assembly = new MemoryStream();
        Diagnostic[] faults = [.. compilation.Emit(assembly).Diagnostics.Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error)];
        Assert.True(faults.Length == 0, string.Join("\n", faults.Select(fault => fault.ToString())) + "\n\n" + program);
    }

    private static SyntaxTree Parse(string text) => CSharpSyntaxTree.ParseText(text, new CSharpParseOptions(LanguageVersion.CSharp12));

    private static IEnumerable<MetadataReference> References() =>
        ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Where(path => Path.GetFileName(path).StartsWith("System.", StringComparison.Ordinal) || Path.GetFileName(path) is "netstandard.dll")
            .Append(typeof(IMavlinkMessage).Assembly.Location)
            .Select(path => MetadataReference.CreateFromFile(path));
}
