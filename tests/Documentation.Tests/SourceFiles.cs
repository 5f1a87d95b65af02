using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;

namespace Rabit.Documentation.Tests;

/// <summary>The files of the repository that people write, by their path from its root, with slashes.</summary>
internal static class SourceFiles
{
    private static readonly string[] BuildFolders = ["bin", "obj", "artifacts", "artifacts-mono"];

    /// <summary>Files below a folder, in the order of their paths.</summary>
    /// <param name="folder">From the root; empty for the root itself without its folders.</param>
    /// <param name="pattern">For example *.cs.</param>
    public static IEnumerable<string> Below(string folder, string pattern)
    {
        SearchOption option = folder.Length == 0 ? SearchOption.TopDirectoryOnly : SearchOption.AllDirectories;
        return Directory.EnumerateFiles(Path.Combine(Repository.Root, folder), pattern, option)
            .Select(f => f.Substring(Repository.Root.Length + 1).Replace('\\', '/'))
            .Where(f => !f.Split('/').Any(part => BuildFolders.Contains(part, StringComparer.Ordinal)))
            .OrderBy(f => f, StringComparer.Ordinal);
    }

    public static string Read(string path)
        => File.ReadAllText(Path.Combine(Repository.Root, path)).Replace("\r\n", "\n");

    public static string[] Lines(string path) => Read(path).Split('\n');
}
