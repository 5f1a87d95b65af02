using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Tests.Shared;

namespace Rabit.Documentation.Tests;

/// <summary>A fenced block of a Markdown document.</summary>
/// <param name="document">Path from the root of the repository.</param>
/// <param name="line">Line of its fence, from 1.</param>
/// <param name="language">What stands behind the fence.</param>
/// <param name="marker">The comment on the line before it, without its brackets; empty where there is none.</param>
/// <param name="text">The block, with the line numbers of the document kept by <see cref="Padded"/>.</param>
public sealed class DocumentBlock(string document, int line, string language, string marker, string text)
{
    private const string Fence = "```";

    public string Document { get; } = document;

    public int Line { get; } = line;

    public string Language { get; } = language;

    public string Marker { get; } = marker;

    public string Text { get; } = text;

    /// <summary>The text behind so many empty lines that a compiler's message names the line of the document.</summary>
    public string Padded => new string('\n', Line) + Text;

    public override string ToString() => $"{Document}:{Line}";

    /// <summary>All blocks of a document, in order.</summary>
    public static IReadOnlyList<DocumentBlock> Read(string document)
    {
        string[] lines = File.ReadAllLines(Path.Combine(Repository.Root, document));
        var blocks = new List<DocumentBlock>();
        for (int i = 0; i < lines.Length; i++)
        {
            if (!lines[i].StartsWith(Fence, StringComparison.Ordinal))
                continue;
            int end = Array.FindIndex(lines, i + 1, l => l.StartsWith(Fence, StringComparison.Ordinal));
            if (end < 0)
                throw new InvalidDataException($"{document}:{i + 1}: the block has no end.");
            string before = i > 0 ? lines[i - 1].Trim() : string.Empty;
            string marker = before.StartsWith("<!--", StringComparison.Ordinal)
                ? before.Trim('<', '!', '-', '>', ' ')
                : string.Empty;
            blocks.Add(
                new DocumentBlock(
                    document, i + 1, lines[i].Substring(Fence.Length).Trim(), marker,
                    string.Join("\n", lines[(i + 1)..end])));
            i = end;
        }

        return blocks;
    }
}
