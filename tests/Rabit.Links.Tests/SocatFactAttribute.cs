using System;
using System.IO;
using System.Linq;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>A test that needs the program socat, and is skipped where it is missing.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class SocatFactAttribute : FactAttribute
{
    public SocatFactAttribute()
    {
        string path = Environment.GetEnvironmentVariable("PATH") ?? "";
        if (!path.Split(Path.PathSeparator).Any(folder => File.Exists(Path.Combine(folder, "socat"))))
            Skip = "socat is not installed (Debian: apt-get install socat)";
    }
}
