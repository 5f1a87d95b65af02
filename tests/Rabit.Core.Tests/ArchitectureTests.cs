using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests;

/// <summary>
/// Dependency and source rules that a test can check: what the package may use, and how its sources are made.
/// </summary>
public sealed class ArchitectureTests
{
    private static readonly Assembly Core = typeof(RabitManager).Assembly;

    [Fact]
    public void References_OfTheAssembly_AreThePlatformsOwn()
    {
        string[] allowed = ["netstandard", "mscorlib", "System", "Microsoft.Bcl"];
        IEnumerable<string> foreign = Core.GetReferencedAssemblies()
            .Select(a => a.Name!)
            .Where(name => !allowed.Any(a => name == a || name.StartsWith(a + ".", StringComparison.Ordinal)));

        Assert.Empty(foreign);
    }

    [Fact]
    public void References_OnDotNet_ComeWithTheRuntime()
    {
        // On .NET the package depends on no other; down-level it may bring Microsoft's own.
        bool isDotNet = Environment.Version.Major >= 5;
        string runtime = Path.GetDirectoryName(typeof(object).Assembly.Location)!;
        IEnumerable<string> brought = Core.GetReferencedAssemblies()
            .Select(Assembly.Load)
            .Where(
                a => isDotNet && !string.Equals(Path.GetDirectoryName(a.Location), runtime, StringComparison.Ordinal))
            .Select(a => a.GetName().Name!);

        Assert.Empty(brought);
    }

    [Fact, Trait("Clause", "4.1")]
    public void StaticFields_OfTheAssembly_AreReadOnly()
    {
        const BindingFlags Statics = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic
            | BindingFlags.DeclaredOnly;
        IEnumerable<string> changeable = Core.GetTypes()
            .Where(type => !type.IsDefined(typeof(CompilerGeneratedAttribute), inherit: false))
            .SelectMany(type => type.GetFields(Statics))
            .Where(field => !field.IsInitOnly && !field.IsLiteral && field.Name[0] != '<')
            .Select(field => field.DeclaringType!.Name + "." + field.Name);

        // The mark of the running manager, one for each thread (contract 2.8); the kernel's id of a thread, which does
        // not change once it was asked for.
        Assert.Equal(
            ["InheritanceFutex._threadId", "RunningManager._current"],
            changeable.OrderBy(field => field, StringComparer.Ordinal));
    }

    [Fact]
    public void Namespaces_OfPublicTypes_AreOne()
        => Assert.Equal(
            "Rabit.Core",
            string.Join(", ", Core.GetExportedTypes().Select(t => t.Namespace!).Distinct(StringComparer.Ordinal)));

    [Fact]
    public void Namespaces_OfInternalTypes_AreTheirFolders()
    {
        // A polyfill has the namespace of what it stands for; helpers beside the project file are of all folders.
        IEnumerable<string> misplaced = Sources()
            .Where(s => s.Path.Contains('/') && !s.Path.StartsWith("Polyfills/", StringComparison.Ordinal))
            .Where(s => !s.Lines.Any(line => line.StartsWith("public ", StringComparison.Ordinal)))
            .Where(s => !s.Lines.Contains($"namespace Rabit.Core.{Path.GetDirectoryName(s.Path)};"))
            .Select(s => s.Path);

        Assert.Empty(misplaced);
    }

    [Fact]
    public void Sources_OutsidePolyfills_HaveNoConditionalCode()
        => Assert.Empty(Sources()
            .Where(s => !s.Path.StartsWith("Polyfills/", StringComparison.Ordinal))
            .Where(s => s.Lines.Any(line => line.TrimStart().StartsWith("#if", StringComparison.Ordinal)))
            .Select(s => s.Path));

    [Fact]
    public void Sources_Each_HaveNoMoreThan350Lines()
        => Assert.Empty(Sources().Where(s => s.Lines.Length > 350).Select(s => $"{s.Path}: {s.Lines.Length} lines"));

    private static IEnumerable<(string Path, string[] Lines)> Sources()
    {
        string root = Path.Combine(Repository.Root, "src", "Rabit.Core");
        return Directory.GetFiles(root, "*.cs", SearchOption.AllDirectories)
            .Select(
                file => (file.Substring(root.Length + 1).Replace(Path.DirectorySeparatorChar, '/'),
                    File.ReadAllLines(file)));
    }
}
