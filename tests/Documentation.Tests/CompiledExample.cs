using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Rabit.Documentation.Tests;

/// <summary>
/// Examples of the XML documentation, compiled: statements and types. What they take for granted (an open system, a
/// link, a buffer) is in Surroundings.txt, a class whose members they see.
/// </summary>
internal static class CompiledExample
{
    private const string Usings = """
        global using System;
        global using System.Collections.Generic;
        global using System.Collections.Immutable;
        global using System.IO;
        global using System.Linq;
        global using System.Threading;
        global using System.Threading.Tasks;
        global using Rabit.Core;
        global using Rabit.Geodesy;
        global using Rabit.Links;
        global using Rabit.Mavlink;
        global using Rabit.Mavlink.Messages;
        global using Rabit.Uav;
        global using Rabit.Uav.AutopilotInterface;
        global using Rabit.Uav.CameraGeometry;
        global using Rabit.Uav.Communications;
        global using Rabit.Uav.GroundControl;
        global using Rabit.Uav.HealthMonitoring;
        global using Rabit.Uav.ImageProcessing;
        global using Rabit.Uav.ImageProcessing.Geolocation;
        global using Rabit.Uav.Messages;
        global using Rabit.Uav.MissionControl;
        global using Rabit.Uav.Reporting;
        global using Rabit.Uav.SensorFusion;
        global using Rabit.Uav.SensorFusion.Metrics;
        global using Rabit.Uav.Simulation;
        global using Rabit.Vision;
        """;

    private static readonly CSharpParseOptions Parse = new(LanguageVersion.CSharp12);

    private static readonly Lazy<SyntaxTree[]> Common = new(() =>
    [
        CSharpSyntaxTree.ParseText(Usings, Parse),
        CSharpSyntaxTree.ParseText(DocumentFiles.Read("tests/Documentation.Tests/Surroundings.txt"), Parse),
    ]);

    /// <summary>Errors, warnings of what may be null, and what the analyzers of the package say.</summary>
    public static IReadOnlyList<string> FindFaults(string example)
    {
        SyntaxTree tree = CSharpSyntaxTree.ParseText(Placed(example), Parse, "example");
        var options = new CSharpCompilationOptions(
            OutputKind.DynamicallyLinkedLibrary, nullableContextOptions: NullableContextOptions.Enable);
        var compilation = CSharpCompilation.Create(
            "example", [tree, .. Common.Value], CompiledProgram.References, options);
        return [.. compilation.GetDiagnostics()
            .Where(d => d.Severity == DiagnosticSeverity.Error || d.Id.StartsWith("CS86", StringComparison.Ordinal))
            .Concat(PackageAnalyzers.FindIn(compilation)).Select(d => d.ToString())];
    }

    // Statements go into a method of the surroundings; types stand beside it.
    private static string Placed(string example)
    {
        var statements = new StringBuilder();
        var types = new StringBuilder();
        CompilationUnitSyntax unit = CSharpSyntaxTree.ParseText(example, Parse).GetCompilationUnitRoot();
        foreach (MemberDeclarationSyntax member in unit.Members)
            (member is GlobalStatementSyntax ? statements : types).Append(member.ToFullString()).Append('\n');
        statements.Append(unit.EndOfFileToken.ToFullString()).Append('\n');
        return $"internal abstract class Example : Surroundings\n{{\n    public void Run(string[] args)\n    {{\n"
            + $"{statements}    }}\n}}\n{types}";
    }
}
