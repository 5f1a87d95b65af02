using System;
using System.IO;
using System.Linq;
using Xunit;

namespace Rabit.Uav.Web.Tests.Browser;

/// <summary>A test in a headless Chromium; skipped where none is installed.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class BrowserFactAttribute : FactAttribute
{
    private static readonly string[] Names = ["chromium", "chromium-browser", "google-chrome"];

    /// <summary>Looks for it.</summary>
    public BrowserFactAttribute()
    {
        if (FindProgram() is null)
            Skip = "There is no Chromium here (eng/install-tools.sh installs Debian's).";
    }

    /// <summary>The program; null where there is none.</summary>
    public static string? FindProgram()
        => (Environment.GetEnvironmentVariable("PATH") ?? string.Empty).Split(Path.PathSeparator)
            .SelectMany(folder => Names.Select(name => Path.Combine(folder, name))).FirstOrDefault(File.Exists);
}
