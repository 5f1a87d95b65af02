using System;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>What every contract test class has: a kind of time, and runs in it. Derived once for each kind.</summary>
public abstract class ContractTests(TimeKind kind)
{
    public TimeKind Kind { get; } = kind;

    protected RabitTime CreateTime() => Kind.Create();

    private protected TestRun NewRun(Action<ReactorOptions>? configure = null) => new(Kind, configure);

    /// <summary>What a task gives; only a test that fails waits for long.</summary>
    protected static async Task<TResult> InTime<TResult>(Task<TResult> task)
    {
        Assert.Same(task, await Task.WhenAny(task, Task.Delay(TestTimeout.Limit)).ConfigureAwait(false));
        return await task.ConfigureAwait(false);
    }
}
