using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.Diagnostics;
using Rabit.Core.Analyzers;
using Xunit;

namespace Rabit.Core.Tests.Analyzers;

/// <summary>Runs all analyzers on the members of one manager, as the compiler does.</summary>
internal static class AnalyzedManager
{
    private const string Usings = """
        using System;
        using System.Collections.Generic;
        using System.Collections.Immutable;
        using System.Diagnostics;
        using System.Linq;
        using System.Threading;
        using System.Threading.Tasks;
        using Rabit.Core;
        """;

    private static readonly MetadataReference[] References =
        [.. ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Where(path => Path.GetFileName(path).StartsWith("System.", StringComparison.Ordinal))
            .Append(typeof(RabitManager).Assembly.Location)
            .Select(path => MetadataReference.CreateFromFile(path))];

    /// <summary>
    /// The diagnostics as "RABIT0002 at Thread.Sleep(1)", in the order of the text, with what the members need beside
    /// them.
    /// </summary>
    /// <param name="members">Of a class that derives from <see cref="RabitManager"/> and is named Pilot.</param>
    /// <param name="types">Further types.</param>
    /// <param name="setsTimer">Whether its constructor sets a timer.</param>
    public static async Task<string[]> Report(string members, string types = "", bool setsTimer = true)
        => await ReportOf($$"""
            {{Usings}}
            public sealed partial class Pilot : RabitManager
            {
                public Pilot() : base("pilot")
                {
                    {{(setsTimer ? "WakeUpDelay = TimeSpan.FromSeconds(1);" : "")}}
                    Declare();
                }
                partial void Declare();
                {{members}}
            }
            {{types}}
            """);

    /// <summary>As <see cref="Report"/>, of a whole program.</summary>
    public static async Task<string[]> ReportOf(string program)
    {
        SyntaxTree tree = CSharpSyntaxTree.ParseText(program, new CSharpParseOptions(LanguageVersion.CSharp12));
        var compilation = CSharpCompilation.Create(
            "Analyzed", [tree], References,
            new CSharpCompilationOptions(
                OutputKind.DynamicallyLinkedLibrary, nullableContextOptions: NullableContextOptions.Enable));
        Assert.Empty(compilation.GetDiagnostics().Where(d => d.Severity == DiagnosticSeverity.Error));

        ImmutableArray<DiagnosticAnalyzer> analyzers =
        [
            new ManagerCodeAnalyzer(), new MutableTypeAnalyzer(), new PushResultAnalyzer(), new LeaseAnalyzer(),
            new DefaultTimerAnalyzer(),
        ];
        ImmutableArray<Diagnostic> found = await compilation.WithAnalyzers(analyzers).GetAnalyzerDiagnosticsAsync();
        IEnumerable<string> lines = found
            .OrderBy(d => d.Location.SourceSpan.Start).ThenBy(d => d.Id, StringComparer.Ordinal)
            .Select(d => $"{d.Id} at {tree.GetText().ToString(d.Location.SourceSpan)}");
        return [.. lines];
    }
}
