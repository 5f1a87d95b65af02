using System;
using System.IO;

namespace Rabit.Tests.Shared;

/// <summary>Where the sources are, from wherever the tests run.</summary>
internal static class Repository
{
    /// <summary>The folder that holds Rabit.sln.</summary>
    public static string Root { get; } = FindRoot();

    private static string FindRoot()
    {
        // Not the base directory: some runners have one of their own.
        string assembly = typeof(Repository).Assembly.Location;
        for (DirectoryInfo? folder = Directory.GetParent(assembly); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, "Rabit.sln")))
                return folder.FullName;
        }

        throw new InvalidOperationException($"No folder above {assembly} holds Rabit.sln.");
    }
}
