using System.Collections.Generic;
using System.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.Operations;

namespace Rabit.Core.Analyzers;

/// <summary>What blocks a thread, what shows or waits for another time, and what is random, by name.</summary>
internal static class ForbiddenCalls
{
    private const string Threading = "System.Threading.";

    private static readonly HashSet<string> Blocking =
    [
        Threading + "Thread.Sleep", Threading + "Thread.Join",
        Threading + "Tasks.Task.Wait", Threading + "Tasks.Task.WaitAll", Threading + "Tasks.Task.WaitAny",
        Threading + "Monitor.Enter", Threading + "Monitor.Wait",
        Threading + "Lock.Enter", Threading + "Lock.EnterScope",
        Threading + "WaitHandle.WaitOne", Threading + "WaitHandle.WaitAll", Threading + "WaitHandle.WaitAny",
        Threading + "WaitHandle.SignalAndWait", Threading + "SemaphoreSlim.Wait",
        Threading + "ManualResetEventSlim.Wait", Threading + "CountdownEvent.Wait",
        Threading + "Barrier.SignalAndWait", Threading + "SpinWait.SpinUntil",
        Threading + "ReaderWriterLockSlim.EnterReadLock", Threading + "ReaderWriterLockSlim.EnterWriteLock",
        Threading + "ReaderWriterLockSlim.EnterUpgradeableReadLock",
        "System.Console.Read", "System.Console.ReadLine", "System.Console.ReadKey",
        "System.Collections.Concurrent.BlockingCollection.Take",
    ];

    // Harmless once the task is known to be done.
    private static readonly HashSet<string> TaskResults =
    [
        Threading + "Tasks.Task.Result", Threading + "Tasks.ValueTask.Result",
        "System.Runtime.CompilerServices.TaskAwaiter.GetResult",
        "System.Runtime.CompilerServices.ValueTaskAwaiter.GetResult",
        "System.Runtime.CompilerServices.ConfiguredTaskAwaitable.ConfiguredTaskAwaiter.GetResult",
        "System.Runtime.CompilerServices.ConfiguredValueTaskAwaitable.ConfiguredValueTaskAwaiter.GetResult",
    ];

    private static readonly HashSet<string> TaskStates =
    [
        "IsCompleted", "IsCompletedSuccessfully", "IsFaulted", "IsCanceled", "Status",
    ];

    private static readonly HashSet<string> OtherTimes =
    [
        "System.DateTime.Now", "System.DateTime.UtcNow", "System.DateTime.Today",
        "System.DateTimeOffset.Now", "System.DateTimeOffset.UtcNow",
        "System.Environment.TickCount", "System.Environment.TickCount64", "System.TimeProvider.System",
        "System.Diagnostics.Stopwatch.StartNew", "System.Diagnostics.Stopwatch.GetTimestamp",
        "System.Diagnostics.Stopwatch.GetElapsedTime", "System.Diagnostics.Stopwatch",
        "System.Timers.Timer", Threading + "Timer",
    ];

    // With a delay they use the time of the system, unless they are given a TimeProvider.
    private static readonly HashSet<string> Delays =
    [
        Threading + "Tasks.Task.Delay", Threading + "CancellationTokenSource.CancelAfter",
        Threading + "CancellationTokenSource", Threading + "PeriodicTimer",
    ];

    public static bool Blocks(string name, IOperation operation)
        => Blocking.Contains(name) && !HasZeroTimeout(operation);

    public static bool IsTaskResult(string name) => TaskResults.Contains(name);

    public static bool IsTaskState(IPropertySymbol property)
        => TaskStates.Contains(property.Name)
            && property.ContainingType.Name is "Task" or "ValueTask"
            && property.ContainingNamespace.ToDisplayString() == "System.Threading.Tasks";

    public static bool IsOtherTime(string name, IOperation operation)
    {
        if (OtherTimes.Contains(name))
            return true;
        if (!Delays.Contains(name))
            return false;
        IEnumerable<IParameterSymbol> parameters = operation switch
        {
            IInvocationOperation invocation => invocation.TargetMethod.Parameters,
            IObjectCreationOperation { Constructor: { } constructor } => constructor.Parameters,
            _ => Enumerable.Empty<IParameterSymbol>(),
        };
        return parameters.Any(p => p.Type.Name is "TimeSpan" or "Int32")
            && !parameters.Any(p => p.Type.Name == "TimeProvider");
    }

    public static bool IsUnseededRandom(string name, IOperation operation)
        => name == "System.Random.Shared"
            || (name == "System.Random" && operation is IObjectCreationOperation { Arguments.Length: 0 });

    /// <summary>"System.Threading.Thread.Sleep", "System.Random" for its constructor, without type arguments.</summary>
    public static string NameOf(ISymbol member)
    {
        string type = TypeName(member.ContainingType);
        return member is IMethodSymbol { MethodKind: MethodKind.Constructor } ? type : $"{type}.{member.Name}";
    }

    private static string TypeName(INamedTypeSymbol type)
        => type.ContainingType is { } outer
            ? $"{TypeName(outer)}.{type.Name}"
            : $"{type.ContainingNamespace.ToDisplayString()}.{type.Name}";

    // A look without a wait.
    private static bool HasZeroTimeout(IOperation operation)
        => operation is IInvocationOperation invocation && invocation.Arguments.Any(a => IsZero(a.Value));

    private static bool IsZero(IOperation value)
        => value.ConstantValue is { HasValue: true, Value: 0 }
            || value is IFieldReferenceOperation { Field: { Name: "Zero", ContainingType.Name: "TimeSpan" } };
}
