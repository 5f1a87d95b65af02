using System;

namespace Rabit.Core.Tests.Contracts;

/// <summary>What every contract test class has: a kind of time, and runs in it. Derived once for each kind.</summary>
public abstract class ContractTests(TimeKind kind)
{
    public TimeKind Kind { get; } = kind;

    protected RabitTime CreateTime() => Kind.Create();

    private protected TestRun NewRun(Action<ReactorOptions>? configure = null) => new(Kind, configure);
}
