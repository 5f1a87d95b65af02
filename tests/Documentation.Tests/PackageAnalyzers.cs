using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using System.Reflection;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;
using Rabit.Core.Analyzers;

namespace Rabit.Documentation.Tests;

/// <summary>The analyzers that the package Rabit.Core brings, run as the compiler of a user runs them.</summary>
internal static class PackageAnalyzers
{
    private static readonly Lazy<ImmutableArray<DiagnosticAnalyzer>> All = new(() =>
        [.. typeof(ManagerCodeAnalyzer).Assembly.GetTypes()
            .Where(t => t.GetCustomAttribute<DiagnosticAnalyzerAttribute>() is not null)
            .Select(t => (DiagnosticAnalyzer)Activator.CreateInstance(t)!)]);

    /// <summary>What they say of a program, hints too; an analyzer that fails says so itself (AD0001).</summary>
    public static IEnumerable<Diagnostic> FindIn(Compilation compilation)
        => compilation.WithAnalyzers(All.Value).GetAnalyzerDiagnosticsAsync().GetAwaiter().GetResult()
            .OrderBy(d => d.Location.SourceSpan.Start);
}
