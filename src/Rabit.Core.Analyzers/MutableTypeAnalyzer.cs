using System.Collections.Immutable;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;
using Microsoft.CodeAnalysis.Operations;

namespace Rabit.Core.Analyzers;

/// <summary>RABIT0005: the type of a message or queue, where an endpoint of it is declared.</summary>
[DiagnosticAnalyzer(LanguageNames.CSharp)]
public sealed class MutableTypeAnalyzer : DiagnosticAnalyzer
{
    /// <inheritdoc/>
    public override ImmutableArray<DiagnosticDescriptor> SupportedDiagnostics { get; } = ImmutableArray.Create(
        Rules.MutableType);

    /// <inheritdoc/>
    public override void Initialize(AnalysisContext context)
    {
        context.ConfigureGeneratedCodeAnalysis(GeneratedCodeAnalysisFlags.None);
        context.EnableConcurrentExecution();
        context.RegisterCompilationStartAction(start =>
        {
            if (KnownTypes.Find(start.Compilation) is { } known)
                start.RegisterOperationAction(operation => Check(operation, known), OperationKind.Invocation);
        });
    }

    private static void Check(OperationAnalysisContext context, KnownTypes known)
    {
        var call = (IInvocationOperation)context.Operation;
        IMethodSymbol method = call.TargetMethod;
        if (method.TypeArguments.Length != 1
            || !(KnownTypes.Is(method.ContainingType, known.Manager)
                || KnownTypes.Is(method.ContainingType, known.Workspace)))
            return;
        bool isQueue = method.Name is "Receive" or "Send" or "AttachReader" or "AttachWriter";
        if (!isQueue && method.Name is not ("Publish" or "Subscribe"))
            return;
        ITypeSymbol type = method.TypeArguments[0];
        if (new SharedState(known, isQueue).Find(type) is { } why)
            context.ReportDiagnostic(Diagnostic.Create(
                Rules.MutableType, call.Syntax.GetLocation(), isQueue ? "A queue of" : "A message of",
                type.ToDisplayString(SymbolDisplayFormat.MinimallyQualifiedFormat), why));
    }
}
