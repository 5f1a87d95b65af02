using System;
using System.IO;
using Xunit;

namespace Rabit.Mavlink.Tests;

/// <summary>
/// A test that needs the larger vectors, which are not part of the repository: a folder shared/vectors/mavlink beside
/// it.
/// </summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class ExtendedDataFactAttribute : FactAttribute
{
    public ExtendedDataFactAttribute(string file)
    {
        if (ExtendedData.Find(file) is null)
            Skip = $"{file} is not there: it is looked for in ../shared/vectors/mavlink beside the repository, or in "
                + "the folder that RABIT_VECTORS names.";
    }
}

/// <summary>Finds the larger vectors.</summary>
internal static class ExtendedData
{
    public static string? Find(string file)
    {
        if (Environment.GetEnvironmentVariable("RABIT_VECTORS") is { Length: > 0 } named)
            return Existing(Path.Combine(named, file));
        for (DirectoryInfo? folder = new(TestData.Folder); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, "Rabit.sln")))
                return Existing(Path.Combine(folder.FullName, "..", "shared", "vectors", "mavlink", file));
        }
        return null;
    }

    private static string? Existing(string path) => File.Exists(path) ? path : null;
}
