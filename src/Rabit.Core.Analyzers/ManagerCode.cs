using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Diagnostics;
using Microsoft.CodeAnalysis.Operations;

namespace Rabit.Core.Analyzers;

/// <summary>
/// What one class of managers calls, member by member. When all of it was seen, the members that a unit of work reaches
/// are known, and what they may not do is reported. Members of other classes are not followed, nor is a function that
/// is handed on: where it runs is not known.
/// </summary>
internal sealed class ManagerCode(INamedTypeSymbol type, KnownTypes known)
{
    private static readonly string[] Stages = ["Startup", "ExecuteUnitOfWork", "Shutdown"];

    private static readonly ImmutableHashSet<string> Declarations = ImmutableHashSet.Create(
        System.StringComparer.Ordinal,
        "Publish", "Subscribe", "SubscribeToStatus", "Receive", "Send", "AttachReader", "AttachWriter");

    // Filled by several threads, read when all of them are done.
    private readonly ConcurrentBag<(IMethodSymbol From, IMethodSymbol To)> _calls = [];
    private readonly ConcurrentBag<Finding> _blocking = [];
    private readonly ConcurrentBag<Finding> _taskResults = [];
    private readonly ConcurrentBag<Finding> _declarations = [];
    private readonly ConcurrentDictionary<ISymbol, bool> _knowsTasks = new(SymbolEqualityComparer.Default);

    public void Visit(OperationAnalysisContext context)
    {
        if (context.ContainingSymbol is not { } place
            || !SymbolEqualityComparer.Default.Equals(place.ContainingType, type))
            return;
        switch (context.Operation)
        {
            case IInvocationOperation invocation:
                Use(context, invocation.TargetMethod, invocation);
                Follow(place, invocation.TargetMethod, invocation);
                break;
            case IObjectCreationOperation { Constructor: { } constructor } creation:
                Use(context, constructor, creation);
                break;
            case IPropertyReferenceOperation reference:
                Use(context, reference.Property, reference);
                Follow(place, reference.Property.GetMethod, reference);
                Follow(place, reference.Property.SetMethod, reference);
                break;
            case ILockOperation statement when place is IMethodSymbol method && !IsInFunction(statement):
                _blocking.Add(new Finding(method, statement.LockedValue.Syntax.GetLocation(), "lock"));
                break;
        }
    }

    public void Report(SymbolAnalysisContext context)
    {
        foreach (IMethodSymbol method in type.GetMembers().OfType<IMethodSymbol>())
        {
            if (method.IsAsync && Stages.Any(s => known.IsManagersOwn(method, s)))
                context.ReportDiagnostic(Diagnostic.Create(
                    Rules.AsyncCode, method.Locations[0], method.Name, type.Name));
        }

        HashSet<IMethodSymbol> unit = ReachedFrom("ExecuteUnitOfWork");
        foreach (Finding found in _blocking.Concat(_taskResults.Where(f => !_knowsTasks.ContainsKey(f.Place)))
            .Where(f => unit.Contains(f.Place)))
            context.ReportDiagnostic(Diagnostic.Create(Rules.BlockingCall, found.At, found.Name, type.Name));

        foreach (string stage in Stages)
        {
            HashSet<IMethodSymbol> reached = ReachedFrom(stage);
            foreach (Finding found in _declarations.Where(f => reached.Contains(f.Place)))
                context.ReportDiagnostic(Diagnostic.Create(
                    Rules.LateDeclaration, found.At, found.Name, stage, type.Name));
        }
    }

    private void Use(OperationAnalysisContext context, ISymbol member, IOperation operation)
    {
        if (member.ContainingType is null)
            return;
        string name = ForbiddenCalls.NameOf(member);
        Location at = operation.Syntax.GetLocation();
        if (ForbiddenCalls.IsOtherTime(name, operation))
            context.ReportDiagnostic(Diagnostic.Create(Rules.OtherTime, at, ShortName(member), type.Name));
        else if (ForbiddenCalls.IsUnseededRandom(name, operation))
            context.ReportDiagnostic(Diagnostic.Create(Rules.UnseededRandom, at, ShortName(member), type.Name));

        if (context.ContainingSymbol is not IMethodSymbol place || IsInFunction(operation))
            return;
        if (member is IPropertySymbol property && ForbiddenCalls.IsTaskState(property))
            _knowsTasks.TryAdd(place, true);
        else if (ForbiddenCalls.IsTaskResult(name))
            _taskResults.Add(new Finding(place, at, ShortName(member)));
        else if (ForbiddenCalls.Blocks(name, operation))
            _blocking.Add(new Finding(place, at, ShortName(member)));
        else if (Declarations.Contains(member.Name) && KnownTypes.Is(member.ContainingType, known.Manager))
            _declarations.Add(new Finding(place, at, member.Name));
    }

    private void Follow(ISymbol place, IMethodSymbol? target, IOperation operation)
    {
        if (place is IMethodSymbol from && target is not null && !IsInFunction(operation)
            && SymbolEqualityComparer.Default.Equals(target.ContainingType, type))
            _calls.Add((from, target.OriginalDefinition));
    }

    private HashSet<IMethodSymbol> ReachedFrom(string stage)
    {
        var reached = new HashSet<IMethodSymbol>(SymbolEqualityComparer.Default);
        var left = new Queue<IMethodSymbol>(
            type.GetMembers().OfType<IMethodSymbol>().Where(m => known.IsManagersOwn(m, stage)));
        ILookup<ISymbol?, IMethodSymbol> calls = _calls.ToLookup(
            c => (ISymbol?)c.From, c => c.To, SymbolEqualityComparer.Default);
        while (left.Count > 0)
        {
            IMethodSymbol method = left.Dequeue();
            if (!reached.Add(method))
                continue;
            foreach (IMethodSymbol next in calls[method])
                left.Enqueue(next);
        }

        return reached;
    }

    private static bool IsInFunction(IOperation operation)
    {
        for (IOperation? each = operation.Parent; each is not null; each = each.Parent)
        {
            if (each is IAnonymousFunctionOperation)
                return true;
        }

        return false;
    }

    private static string ShortName(ISymbol member)
        => member is IMethodSymbol { MethodKind: MethodKind.Constructor }
            ? $"new {member.ContainingType.Name}"
            : $"{member.ContainingType.Name}.{member.Name}";

    private readonly struct Finding(IMethodSymbol place, Location at, string name)
    {
        public IMethodSymbol Place { get; } = place;

        public Location At { get; } = at;

        public string Name { get; } = name;
    }
}
