using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Xunit;

namespace Rabit.Mavlink.Tests;

/// <summary>
/// A test of logs that others recorded, which are not part of the repository: the folder shared/vectors/real/tlogs
/// beside it.
/// </summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class RealLogTheoryAttribute : TheoryAttribute
{
    public RealLogTheoryAttribute()
    {
        if (RealLogs.Sidecars.Count == 0)
            Skip = "Real flight logs are not there: they are looked for in ../shared/vectors/real/tlogs beside the "
                + "repository, or in the folder that RABIT_REAL_TLOGS names.";
    }
}

/// <summary>Finds the logs of others, by the .json beside each.</summary>
internal static class RealLogs
{
    public static IReadOnlyList<string> Sidecars { get; } = Find();

    private static string[] Find()
    {
        string? folder = Environment.GetEnvironmentVariable("RABIT_REAL_TLOGS");
        for (DirectoryInfo? above = new(TestData.Folder); above is not null && folder is null; above = above.Parent)
        {
            if (File.Exists(Path.Combine(above.FullName, "Rabit.sln")))
                folder = Path.Combine(above.FullName, "..", "shared", "vectors", "real", "tlogs");
        }

        return folder is null || !Directory.Exists(folder)
            ? []
            : Directory.GetFiles(folder, "*.json", SearchOption.AllDirectories)
                .Where(f => File.Exists(Path.ChangeExtension(f, ".tlog")))
                .OrderBy(f => f, StringComparer.Ordinal).ToArray();
    }
}
