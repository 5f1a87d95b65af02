using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Mavlink.Tests.Docs;

/// <summary>The programs in the documents compile as they are.</summary>
public class DocumentedCodeTests
{
    private const int MaxLoopLines = 15;

    // What a document may leave out: it names the package of each type.
    internal static readonly ProgramCompiler Compiler = new(
        ["System", "System.Diagnostics", "System.IO", "Rabit.Mavlink", "Rabit.Mavlink.Messages"],
        typeof(IMavlinkMessage));

    private const string TimestampStore =
        "sealed class FileTimestampStore(string path) : IMavlinkTimestampStore { public int Read(int slot, Span<byte> "
            + "r) => path.Length; public bool Write(int slot, ReadOnlySpan<byte> r) => true; }";

    [Theory]
    [InlineData("src/Rabit.Mavlink/README.md", 3)]
    [InlineData("docs/concepts/signing.md", 3)]
    [InlineData("docs/mavlink/protocols.md", 8)]
    public void EveryProgram_OfTheDocument_Compiles(string document, int programs)
    {
        List<string> blocks = BlocksOf(document);
        Assert.Equal(programs, blocks.Count);
        Assert.All(blocks, block => AssertCompiles(block));
    }

    [Fact]
    public void ReceiveAndSend_OfTheReadme_HaveNoMoreThanFifteenLines()
    {
        List<string> blocks = BlocksOf("src/Rabit.Mavlink/README.md");
        string[] loops = [.. blocks.Where(block => block.Contains("TcpClient", StringComparison.Ordinal))];
        Assert.Equal(2, loops.Length);
        Assert.All(
            loops, loop => Assert.InRange(loop.Split('\n').Count(line => line.Trim().Length > 0), 1, MaxLoopLines));
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
        bool usesStore = program.Contains("FileTimestampStore", StringComparison.Ordinal)
            && !program.Contains("class FileTimestampStore", StringComparison.Ordinal);
        IReadOnlyList<string> errors = usesStore
            ? Compiler.ErrorsOf(program, TimestampStore)
            : Compiler.ErrorsOf(program);
        Assert.True(errors.Count == 0, string.Join("\n", errors) + "\n\n" + program);
    }
}
