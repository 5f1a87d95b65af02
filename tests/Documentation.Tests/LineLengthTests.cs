using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>
/// Lines of code have at most 120 columns, but for those that a string literal makes longer: a search does not find a
/// text that is split.
/// </summary>
public sealed class LineLengthTests
{
    private const int MaxColumns = 120;

    private static readonly string[] Folders = ["src", "samples", "tests", "benchmarks"];

    [Fact]
    public void Lines_OfTheCode_HaveAtMost120Columns()
    {
        string[] faults =
            Folders.SelectMany(folder => SourceFiles.Below(folder, "*.cs")).SelectMany(LongLines).ToArray();
        Assert.True(faults.Length == 0, string.Join("\n", faults));
    }

    private static IEnumerable<string> LongLines(string file)
    {
        string[] lines = SourceFiles.Lines(file).ToArray();
        if (!lines.Any(l => l.Length > MaxColumns))
            return [];
        SyntaxNode root = CSharpSyntaxTree.ParseText(File.ReadAllText(Path.Combine(Repository.Root, file))).GetRoot();
        TextLineCollection positions = root.GetText().Lines;
        return positions.Where(l => l.End - l.Start > MaxColumns && !IsOfAString(root, l))
            .Select(l => $"{file}:{l.LineNumber + 1}: {l.End - l.Start}");
    }

    // A string that begins on the line or before it, and ends beyond the last column.
    private static bool IsOfAString(SyntaxNode root, TextLine line)
    {
        SyntaxToken token = root.FindToken(line.Start + MaxColumns - 1);
        SyntaxToken before = token.GetPreviousToken();
        return IsString(token) || IsString(before);
    }

    private static bool IsString(SyntaxToken token)
        => token.Parent is LiteralExpressionSyntax literal && literal.Token.Value is string
            || token.Parent?.FirstAncestorOrSelf<InterpolatedStringExpressionSyntax>() is not null;
}
