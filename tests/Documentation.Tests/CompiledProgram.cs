using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Text;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>
/// Programs of the documents, compiled as a user's project would: nullable on, the analyzers of the package on, and no
/// warnings, nor what an analyzer says beside.
/// </summary>
internal static class CompiledProgram
{
    // Everything beside the tests: the framework, xunit and the packages.
    private static readonly Lazy<IReadOnlyList<MetadataReference>> All = new(() =>
        [.. ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Select(f => (MetadataReference)MetadataReference.CreateFromFile(f))]);

    public static IReadOnlyList<MetadataReference> References => All.Value;

    /// <summary>Compiles blocks together; one of them may have top-level statements.</summary>
    public static Assembly Compile(params DocumentBlock[] blocks)
    {
        var parse = new CSharpParseOptions(LanguageVersion.CSharp12);
        IEnumerable<SyntaxTree> trees = blocks.Select(
            b => CSharpSyntaxTree.ParseText(SourceText.From(b.Padded), parse, path: b.Document));
        bool isProgram = trees.Any(
            t => t.GetCompilationUnitRoot().Members.Any(m => m.IsKind(SyntaxKind.GlobalStatement)));
        var options = new CSharpCompilationOptions(
            isProgram ? OutputKind.ConsoleApplication : OutputKind.DynamicallyLinkedLibrary)
            .WithNullableContextOptions(NullableContextOptions.Enable)
            .WithOptimizationLevel(OptimizationLevel.Release);
        var compilation = CSharpCompilation.Create("document-" + blocks[^1].Line, trees, References, options);

        string[] faults = [.. compilation.GetDiagnostics()
            .Where(d => d.Severity >= DiagnosticSeverity.Warning && d.Id != "CS1701")
            .Concat(PackageAnalyzers.FindIn(compilation)).Select(d => d.ToString())];
        Assert.True(faults.Length == 0, string.Join(Environment.NewLine, faults));

        using var stream = new MemoryStream();
        Assert.True(compilation.Emit(stream).Success);
        return Assembly.Load(stream.ToArray());
    }

    /// <summary>Runs a program; what it prints and its exit code.</summary>
    public static (string Printed, int ExitCode) Run(Assembly program, params string[] args)
    {
        TextWriter before = Console.Out;
        using var printed = new StringWriter();
        Console.SetOut(printed);
        try
        {
            object? result = program.EntryPoint!.Invoke(null, [args]);
            return (printed.ToString().ReplaceLineEndings("\n").TrimEnd(), result is int code ? code : 0);
        }
        finally
        {
            Console.SetOut(before);
        }
    }

    /// <summary>
    /// Runs all facts of the test classes in an assembly, each on an instance of its own. How many there were.
    /// </summary>
    public static int RunFacts(Assembly tests)
    {
        int count = 0;
        foreach (MethodInfo fact in tests.GetTypes().SelectMany(t => t.GetMethods())
            .Where(m => m.GetCustomAttribute<FactAttribute>() is not null))
        {
            fact.Invoke(Activator.CreateInstance(fact.DeclaringType!), []);
            count++;
        }

        return count;
    }
}
