using System.Collections.Immutable;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;

namespace Rabit.Core.Analyzers;

/// <summary>What the code of a manager may not do: RABIT0001 to RABIT0004, and RABIT0007.</summary>
[DiagnosticAnalyzer(LanguageNames.CSharp)]
public sealed class ManagerCodeAnalyzer : DiagnosticAnalyzer
{
    /// <inheritdoc/>
    public override ImmutableArray<DiagnosticDescriptor> SupportedDiagnostics { get; } = ImmutableArray.Create(
        Rules.AsyncCode, Rules.BlockingCall, Rules.OtherTime, Rules.UnseededRandom, Rules.LateDeclaration);

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
        var type = (INamedTypeSymbol)context.Symbol;
        if (!known.IsManager(type))
            return;
        var code = new ManagerCode(type, known);
        context.RegisterOperationAction(
            code.Visit, OperationKind.Invocation, OperationKind.ObjectCreation, OperationKind.PropertyReference,
            OperationKind.Lock);
        context.RegisterSymbolEndAction(code.Report);
    }
}
