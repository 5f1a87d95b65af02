using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;
using Microsoft.CodeAnalysis.Operations;

namespace Rabit.Core.Analyzers;

/// <summary>
/// RABIT0008: a lease of a buffer is used after it was pushed. Looked for in the statements behind the push, of its
/// block and of those around it; where a variable has the result of the push, it is not judged, since a push that was
/// rejected leaves the lease with its sender.
/// </summary>
[DiagnosticAnalyzer(LanguageNames.CSharp)]
public sealed class LeaseAnalyzer : DiagnosticAnalyzer
{
    /// <inheritdoc/>
    public override ImmutableArray<DiagnosticDescriptor> SupportedDiagnostics { get; } = ImmutableArray.Create(
        Rules.LeaseUsedAfterPush);

    /// <inheritdoc/>
    public override void Initialize(AnalysisContext context)
    {
        context.ConfigureGeneratedCodeAnalysis(GeneratedCodeAnalysisFlags.None);
        context.EnableConcurrentExecution();
        context.RegisterCompilationStartAction(start =>
        {
            if (KnownTypes.Find(start.Compilation) is { PushResult: not null, BufferLease: not null } known)
                start.RegisterOperationAction(operation => Check(operation, known), OperationKind.Invocation);
        });
    }

    private static void Check(OperationAnalysisContext context, KnownTypes known)
    {
        var push = (IInvocationOperation)context.Operation;
        if (!KnownTypes.Is(push.Type, known.PushResult) || StatementOf(push) is not { } statement)
            return;
        foreach (ISymbol lease in push.Arguments.SelectMany(a => a.Descendants())
            .Where(o => IsPushed(o, known)).Select(VariableOf).OfType<ISymbol>().Where(v => IsLease(v, known))
            .Distinct<ISymbol>(SymbolEqualityComparer.Default))
        {
            if (FindUse(statement, lease) is { } use)
                context.ReportDiagnostic(Diagnostic.Create(
                    Rules.LeaseUsedAfterPush, use.Syntax.GetLocation(), lease.Name));
        }
    }

    // The statement that the push is, or whose condition it is in.
    private static IOperation? StatementOf(IOperation push)
    {
        IOperation at = push;
        while (at.Parent is { } parent)
        {
            if (parent is IExpressionStatementOperation)
                return parent;
            if (parent is IConditionalOperation condition && condition.Parent is IBlockOperation)
                return ReferenceEquals(condition.Condition, at) ? condition : null;
            if (parent is IVariableInitializerOperation or IReturnOperation or IAnonymousFunctionOperation
                || (parent is ISimpleAssignmentOperation { Target: not IDiscardOperation }))
                return null;
            at = parent;
        }

        return null;
    }

    private static IOperation? FindUse(IOperation statement, ISymbol lease)
    {
        for (IOperation at = statement; at.Parent is { } parent; at = parent)
        {
            if (parent is IAnonymousFunctionOperation)
                return null;
            if (parent is not IBlockOperation block)
                continue;
            foreach (IOperation next in block.Operations.SkipWhile(o => !ReferenceEquals(o, at)).Skip(1))
            {
                foreach (IOperation reference in next.DescendantsAndSelf().Where(o => IsSame(VariableOf(o), lease)))
                {
                    if (IsAssigned(reference))
                        return null;
                    if (!IsHarmless(reference))
                        return reference;
                }

                if (next is IReturnOperation or IBranchOperation or IThrowOperation)
                    return null;
            }
        }

        return null;
    }

    // Not what is only read of it: the width of a picture, say.
    private static bool IsPushed(IOperation reference, KnownTypes known) => reference.Parent switch
    {
        IMemberReferenceOperation member => KnownTypes.Is(member.Type, known.BufferLease),
        IInvocationOperation => false,
        _ => true,
    };

    private static ISymbol? VariableOf(IOperation operation) => operation switch
    {
        ILocalReferenceOperation local => local.Local,
        IParameterReferenceOperation parameter => parameter.Parameter,
        _ => null,
    };

    private static bool IsSame(ISymbol? variable, ISymbol lease)
        => SymbolEqualityComparer.Default.Equals(variable, lease);

    private static bool IsLease(ISymbol variable, KnownTypes known)
    {
        ITypeSymbol? type = (variable as ILocalSymbol)?.Type ?? (variable as IParameterSymbol)?.Type;
        return KnownTypes.Is(type, known.BufferLease)
            || (type is { IsValueType: true } && FieldsOf(type).Any(f => KnownTypes.Is(f.Type, known.BufferLease)));
    }

    private static IEnumerable<IFieldSymbol> FieldsOf(ITypeSymbol type)
        => type.GetMembers().OfType<IFieldSymbol>().Where(f => !f.IsStatic);

    private static bool IsAssigned(IOperation reference)
        => (reference.Parent is ISimpleAssignmentOperation assignment && ReferenceEquals(assignment.Target, reference))
            || reference.Parent is IArgumentOperation { Parameter.RefKind: RefKind.Out };

    // To return it twice does nothing, and an empty one is none.
    private static bool IsHarmless(IOperation reference) => reference.Parent switch
    {
        IInvocationOperation { TargetMethod.Name: "Dispose" } => true,
        IPropertyReferenceOperation { Property.Name: "IsEmpty" } => true,
        INameOfOperation => true,
        _ => false,
    };
}
