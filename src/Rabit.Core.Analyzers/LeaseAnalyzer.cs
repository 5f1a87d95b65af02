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
            if (FindUse(statement, lease, known) is { } use)
                context.ReportDiagnostic(Diagnostic.Create(
                    Rules.LeaseUsedAfterPush, use.Syntax.GetLocation(), lease.Name));
        }
    }

    // The statement that the push is, or the "if" that looks at whether it was rejected. What another condition means
    // is not known.
    private static IOperation? StatementOf(IInvocationOperation push) => push.Parent switch
    {
        IExpressionStatementOperation statement => statement,
        ISimpleAssignmentOperation { Target: IDiscardOperation, Parent: IExpressionStatementOperation statement }
            => statement,
        IBinaryOperation { OperatorKind: BinaryOperatorKind.Equals, Parent: IConditionalOperation condition } test
            when IsRejected(test.LeftOperand) || IsRejected(test.RightOperand) => condition,
        _ => null,
    };

    private static bool IsRejected(IOperation operand)
        => operand is IFieldReferenceOperation { Field.Name: "Rejected" };

    private static IOperation? FindUse(IOperation statement, ISymbol lease, KnownTypes known)
    {
        for (IOperation at = statement; at.Parent is { } parent; at = parent)
        {
            if (parent is IAnonymousFunctionOperation)
                return null;
            foreach (IOperation next in StatementsOf(parent).SkipWhile(o => !ReferenceEquals(o, at)).Skip(1))
            {
                foreach (IOperation reference in next.DescendantsAndSelf().Where(o => IsSame(VariableOf(o), lease)))
                {
                    if (IsAssigned(reference))
                        return null;
                    if (!IsHarmless(reference, known))
                        return reference;
                }

                if (next is IBranchOperation { BranchKind: BranchKind.Break } && parent is ISwitchCaseOperation)
                    break;
                if (next is IReturnOperation or IBranchOperation
                    or IExpressionStatementOperation { Operation: IThrowOperation } or IThrowOperation)
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

    private static ImmutableArray<IOperation> StatementsOf(IOperation parent) => parent switch
    {
        IBlockOperation block => block.Operations,
        ISwitchCaseOperation part => part.Body,
        _ => ImmutableArray<IOperation>.Empty,
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

    // From there on it is another lease.
    private static bool IsAssigned(IOperation reference) => reference.Parent switch
    {
        ISimpleAssignmentOperation assignment => ReferenceEquals(assignment.Target, reference),
        IArgumentOperation argument => argument.Parameter?.RefKind is RefKind.Out or RefKind.Ref,
        ITupleOperation { Parent: IDeconstructionAssignmentOperation deconstruction } tuple
            => ReferenceEquals(deconstruction.Target, tuple),
        IFieldReferenceOperation field => IsAssigned(field),
        _ => false,
    };

    // To return it twice does nothing, an empty one is none, and what else a struct has is a copy of its own. What
    // becomes of a copy is not followed.
    private static bool IsHarmless(IOperation reference, KnownTypes known) => reference.Parent switch
    {
        IInvocationOperation { TargetMethod.Name: "Dispose" } => true,
        IPropertyReferenceOperation { Property.Name: "IsEmpty" } => true,
        IFieldReferenceOperation field when KnownTypes.Is(field.Type, known.BufferLease) => IsHarmless(field, known),
        IFieldReferenceOperation => true,
        IIsPatternOperation or INameOfOperation or IVariableInitializerOperation or ISimpleAssignmentOperation => true,
        _ => false,
    };
}
