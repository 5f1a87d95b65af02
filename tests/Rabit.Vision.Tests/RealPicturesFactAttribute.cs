using System;
using System.IO;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Vision.Tests;

/// <summary>
/// A test that needs pictures of real cameras, which are not part of the repository, and is skipped without them.
/// </summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class RealPicturesFactAttribute : FactAttribute
{
    public RealPicturesFactAttribute(string folder)
    {
        if (FolderOf(folder) is null)
            Skip = $"real/{folder} is not there: it is looked for in ../shared/vectors beside the repository, or in "
                + "the folder that RABIT_VECTORS names.";
    }

    internal static string? FolderOf(string folder)
    {
        string above = Environment.GetEnvironmentVariable("RABIT_VECTORS") is { Length: > 0 } named
            ? named
            : Path.Combine(Repository.Root, "..", "shared", "vectors");
        string path = Path.Combine(above, "real", folder);
        return Directory.Exists(path) ? path : null;
    }
}
