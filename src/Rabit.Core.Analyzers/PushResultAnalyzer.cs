using System.Collections.Immutable;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;
using Microsoft.CodeAnalysis.Operations;

namespace Rabit.Core.Analyzers;

/// <summary>
/// RABIT0006: a call that returns what a push did stands alone, awaited or not, or one that returns how many values of
/// several were put in.
/// </summary>
[DiagnosticAnalyzer(LanguageNames.CSharp)]
public sealed class PushResultAnalyzer : DiagnosticAnalyzer
{
    private const string PushOfSeveral = "PushFrom";

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
            if (KnownTypes.Find(start.Compilation) is { PushResult: not null } types)
                start.RegisterOperationAction(operation => Check(operation, types), OperationKind.ExpressionStatement);
        });
    }

    private static void Check(OperationAnalysisContext context, KnownTypes types)
    {
        IOperation operation = ((IExpressionStatementOperation)context.Operation).Operation;
        if (operation is IConditionalAccessOperation { WhenNotNull: { } access })
            operation = access;
        bool isIgnored = operation switch
        {
            IAwaitOperation awaited => KnownTypes.Is(awaited.Type, types.PushResult),
            IInvocationOperation call => SaysWhatWasPut(call, types),
            _ => false,
        };
        if (isIgnored)
            context.ReportDiagnostic(Diagnostic.Create(Rules.IgnoredPushResult, operation.Syntax.GetLocation()));
    }

    private static bool SaysWhatWasPut(IInvocationOperation call, KnownTypes types)
        => KnownTypes.Is(call.Type, types.PushResult)
            || (call.TargetMethod.Name == PushOfSeveral
                && KnownTypes.Is(call.TargetMethod.ContainingType, types.QueueSender))
            // A task of a push that is not awaited.
            || (call.Type is INamedTypeSymbol { TypeArguments: { Length: 1 } results }
                && KnownTypes.Is(results[0], types.PushResult));
}
