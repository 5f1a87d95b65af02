using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;

namespace Rabit.Documentation.Tests;

/// <summary>The Markdown documents of the repository.</summary>
internal static class DocumentFiles
{
    /// <summary>Paths from the root of the repository, in order.</summary>
    public static IReadOnlyList<string> All { get; } =
        [.. new[] { "docs", "src", "samples", "benchmarks", "tests" }
            .SelectMany(
                folder => Directory.EnumerateFiles(
                    Path.Combine(Repository.Root, folder), "*.md", SearchOption.AllDirectories))
            .Concat(Directory.EnumerateFiles(Repository.Root, "*.md"))
            .Select(f => f.Substring(Repository.Root.Length + 1))
            .Where(f => !f.Split('/').Any(p => p is "bin" or "obj"))
            .OrderBy(f => f, StringComparer.Ordinal)];

    public static string Read(string document) => File.ReadAllText(Path.Combine(Repository.Root, document));
}
