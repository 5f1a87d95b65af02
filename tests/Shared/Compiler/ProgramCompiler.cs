using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace Rabit.Tests.Shared;

/// <summary>
/// Compiles small programs against the assemblies under test, without running them. For projects that reference
/// Microsoft.CodeAnalysis.CSharp: they compile this file beside <c>tests/Shared/*.cs</c>.
/// </summary>
/// <param name="usings">Namespaces that every program sees.</param>
/// <param name="assemblies">One type of each assembly that programs may use beside the runtime's own.</param>
internal sealed class ProgramCompiler(IReadOnlyList<string> usings, params Type[] assemblies)
{
    private readonly List<MetadataReference> _references = [.. ReferencesOf(assemblies)];

    /// <summary>Compiles a program of top-level statements.</summary>
    /// <param name="program">Its text.</param>
    /// <param name="others">Further files, such as types that a document leaves to its reader.</param>
    /// <returns>The errors; empty where it compiles.</returns>
    public IReadOnlyList<string> ErrorsOf(string program, params string[] others)
    {
        string globalUsings = string.Concat(usings.Select(name => $"global using {name};\n"));
        SyntaxTree[] trees = [Parse(globalUsings), Parse(program), .. others.Select(Parse)];
        var compilation = CSharpCompilation.Create(
            "Documented", trees, _references,
            new CSharpCompilationOptions(
                OutputKind.ConsoleApplication, nullableContextOptions: NullableContextOptions.Enable));
        using var assembly = new MemoryStream();
        return [.. compilation.Emit(assembly).Diagnostics
            .Where(diagnostic => diagnostic.Severity == DiagnosticSeverity.Error).Select(error => error.ToString())];
    }

    private static SyntaxTree Parse(string text)
        => CSharpSyntaxTree.ParseText(text, new CSharpParseOptions(LanguageVersion.CSharp12));

    private static IEnumerable<MetadataReference> ReferencesOf(Type[] assemblies) =>
        ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Where(
                path => Path.GetFileName(path).StartsWith("System.", StringComparison.Ordinal)
                    || Path.GetFileName(path) is "netstandard.dll")
            .Concat(assemblies.Select(type => type.Assembly.Location))
            .Select(path => MetadataReference.CreateFromFile(path));
}
