using System;
using System.IO;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Tool.Tests;

/// <summary>The tool is a program: it uses the packages and two libraries for consoles, and none uses it.</summary>
public sealed class ArchitectureTests
{
    [Fact]
    public void Tool_References_ArePackagesOfRabitAndLibrariesForConsoles()
        => Assert.DoesNotContain(
            typeof(CommandLine).Assembly.GetReferencedAssemblies(),
            a => !a.Name!.StartsWith("Rabit.", StringComparison.Ordinal)
                && !a.Name.StartsWith("System", StringComparison.Ordinal)
                && a.Name is not ("mscorlib" or "netstandard" or "Microsoft.Win32.Primitives" or "Spectre.Console"));

    [Fact]
    public void Tool_Types_AreNoneOfThemPublic() => Assert.Empty(typeof(CommandLine).Assembly.GetExportedTypes());

    [Fact]
    public void Packages_References_AreNotTheTool()
        => Assert.DoesNotContain(
            Directory.GetFiles(Path.Combine(Repository.Root, "src"), "*.csproj", SearchOption.AllDirectories),
            p => !p.EndsWith("Rabit.Tool.csproj", StringComparison.Ordinal)
                && File.ReadAllText(p).Contains("Rabit.Tool.csproj"));
}
