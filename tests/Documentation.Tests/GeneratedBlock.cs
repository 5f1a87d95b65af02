using System;
using System.IO;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>A part of a document that a test generates, between two comments that name it.</summary>
internal static class GeneratedBlock
{
    /// <summary>Whether documents are to be brought up to date instead of checked.</summary>
    public static bool Updates
        => string.Equals(Environment.GetEnvironmentVariable("RABIT_UPDATE_DOCS"), "1", StringComparison.Ordinal);

    /// <summary>Checks that the block is as generated; with RABIT_UPDATE_DOCS=1 writes it.</summary>
    /// <param name="document">Path from the root of the repository.</param>
    /// <param name="name">Name of the block.</param>
    /// <param name="content">Generated, with a line feed at its end.</param>
    public static void AssertUpToDate(string document, string name, string content)
    {
        string path = Path.Combine(Repository.Root, document);
        string text = File.ReadAllText(path).Replace("\r\n", "\n");
        string begin = $"<!-- generated: {name} -->\n";
        int start = text.IndexOf(begin, StringComparison.Ordinal) + begin.Length;
        int end = text.IndexOf("<!-- end -->", start, StringComparison.Ordinal);
        Assert.True(start >= begin.Length && end >= start, $"{document} has no block '{name}'.");
        if (Updates)
            File.WriteAllText(path, string.Concat(text.AsSpan(0, start), content, text.AsSpan(end)));
        else if (!string.Equals(text.Substring(start, end - start), content, StringComparison.Ordinal))
            Assert.Fail($"{document} is out of date; RABIT_UPDATE_DOCS=1 writes it. It should have:\n{content}");
    }
}
