using System;
using System.IO;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Vision.Tests;

/// <summary>
/// A test that needs the whole sets of generated pictures, of which the repository has a part, and is skipped without
/// them.
/// </summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class GeneratedPicturesFactAttribute : FactAttribute
{
    public GeneratedPicturesFactAttribute()
    {
        if (Folder is null)
            Skip = "imagery is not there: it is looked for in ../shared/vectors beside the repository, or in the "
                + "folder that RABIT_VECTORS names.";
    }

    internal static string? Folder
    {
        get
        {
            string above = Environment.GetEnvironmentVariable("RABIT_VECTORS") is { Length: > 0 } named
                ? named
                : Path.Combine(Repository.Root, "..", "shared", "vectors");
            string path = Path.Combine(above, "imagery");
            return Directory.Exists(path) ? path : null;
        }
    }
}
