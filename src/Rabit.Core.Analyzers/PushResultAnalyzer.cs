using System.Collections.Immutable;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;
using Microsoft.CodeAnalysis.Operations;

namespace Rabit.Core.Analyzers;

/// <summary>RABIT0006: a call that returns what a push did stands alone.</summary>
[DiagnosticAnalyzer(LanguageNames.CSharp)]
public sealed class PushResultAnalyzer : DiagnosticAnalyzer
{
    /// <inheritdoc/>
    public override ImmutableArray<DiagnosticDescriptor> SupportedDiagnostics { get; } = ImmutableArray.Create(
        Rules.IgnoredPushResult);

    /// <inheritdoc/>
    public override void Initialize(AnalysisContext context)
    {
        context.ConfigureGeneratedCodeAnalysis(GeneratedCodeAnalysisFlags.None);
        context.EnableConcurrentExecution();
        context.RegisterCompilationStartAction(start =>
        {
            if (KnownTypes.Find(start.Compilation) is { PushResult: { } result })
                start.RegisterOperationAction(
                    operation => Check(operation, result), OperationKind.ExpressionStatement);
        });
    }

    private static void Check(OperationAnalysisContext context, INamedTypeSymbol result)
    {
        if (((IExpressionStatementOperation)context.Operation).Operation is IInvocationOperation call
            && KnownTypes.Is(call.Type, result))
            context.ReportDiagnostic(Diagnostic.Create(Rules.IgnoredPushResult, call.Syntax.GetLocation()));
    }
}
