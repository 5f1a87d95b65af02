using System;
using System.Collections.Immutable;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;
using Microsoft.CodeAnalysis.Operations;

namespace Rabit.Core.Analyzers;

/// <summary>
/// RABIT0009: nothing wakes a manager but the timer that it did not set. A manager that hands itself to other code is
/// not judged: that may wire for it.
/// </summary>
[DiagnosticAnalyzer(LanguageNames.CSharp)]
public sealed class DefaultTimerAnalyzer : DiagnosticAnalyzer
{
    /// <inheritdoc/>
    public override ImmutableArray<DiagnosticDescriptor> SupportedDiagnostics { get; } = ImmutableArray.Create(
        Rules.DefaultTimerOnly);

    /// <inheritdoc/>
    public override void Initialize(AnalysisContext context)
    {
        context.ConfigureGeneratedCodeAnalysis(GeneratedCodeAnalysisFlags.None);
        context.EnableConcurrentExecution();
        context.RegisterCompilationStartAction(start =>
        {
            if (KnownTypes.Find(start.Compilation) is { } known)
                start.RegisterSymbolStartAction(symbol => Begin(symbol, known), SymbolKind.NamedType);
        });
    }

    private static void Begin(SymbolStartAnalysisContext context, KnownTypes known)
    {
        // What a class between does, or one that derives from it, is not seen.
        var type = (INamedTypeSymbol)context.Symbol;
        if (!type.IsSealed || !KnownTypes.Is(type.BaseType, known.Manager))
            return;
        var wakeUps = new WakeUps(type);
        context.RegisterOperationAction(
            wakeUps.Visit, OperationKind.Invocation, OperationKind.PropertyReference, OperationKind.InstanceReference,
            OperationKind.MethodReference);
        context.RegisterSymbolEndAction(wakeUps.Report);
    }

    private sealed class WakeUps(INamedTypeSymbol type)
    {
        private static readonly string[] Wired = ["Publish", "Subscribe", "SubscribeToStatus", "Send", "AttachWriter"];

        // Written by several threads, to true only: what another thread has set must never be written back.
        private volatile bool _isWoken;
        private volatile bool _isWired;

        public void Visit(OperationAnalysisContext context)
        {
            if (!SymbolEqualityComparer.Default.Equals(context.ContainingSymbol?.ContainingType, type))
                return;
            switch (context.Operation)
            {
                case IInvocationOperation
                {
                    TargetMethod.Name: "Receive" or "AttachReader" or "OnPost" or "WakeUp"
                }:
                case IMethodReferenceOperation { Method.Name: "WakeUp" }:
                    _isWoken = true;
                    break;
                case IInvocationOperation invocation:
                    if (Array.IndexOf(Wired, invocation.TargetMethod.Name) >= 0)
                        _isWired = true;
                    if (invocation.Arguments.Any(Wakes))
                        _isWoken = true;
                    break;
                case IPropertyReferenceOperation { Property.Name: "WakeUpDelay" or "Period" } property
                    when property.Parent is ITupleOperation
                        || (property.Parent is IAssignmentOperation assignment
                            && ReferenceEquals(assignment.Target, property)):
                    _isWoken = true;
                    break;
                case IInstanceReferenceOperation { Parent: not (IMemberReferenceOperation or IInvocationOperation) }:
                    _isWoken = true;
                    break;
            }
        }

        public void Report(SymbolAnalysisContext context)
        {
            if (!_isWoken && _isWired)
                context.ReportDiagnostic(Diagnostic.Create(Rules.DefaultTimerOnly, type.Locations[0], type.Name));
        }

        private static bool Wakes(IArgumentOperation argument)
            => argument.Parameter?.Name is "wakeOnPost" or "wakeOnPop" or "wakeOnPush"
                && argument.Value.ConstantValue is not { HasValue: true, Value: false };
    }
}
