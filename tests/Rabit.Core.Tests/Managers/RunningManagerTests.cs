using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Managers;
using Rabit.Core.Wiring;
using Xunit;

namespace Rabit.Core.Tests.Managers;

/// <summary>The check of who runs on a thread: by a mark on its stack and by its thread-static field.</summary>
public sealed partial class RunningManagerTests
{
    // More than a mark covers.
    private const int DeepBytes = 48 * 1024;

    private readonly EndpointOwner _first = NewOwner("first");
    private readonly EndpointOwner _second = NewOwner("second");

    [Fact, Trait("Clause", "2.8")]
    public void Is_BeforeInAndAfterTheScope_IsTrueInIt()
    {
        bool before = RunningManager.Is(_first);
        var scope = new RunningScope();
        scope.Enter(_first);
        bool inside = RunningManager.Is(_first);
        bool other = RunningManager.Is(_second);
        scope.Leave();

        Assert.Equal((false, true, false, false), (before, inside, other, RunningManager.Is(_first)));
        Assert.Null(RunningManager.Current);
    }

    [Fact, Trait("Clause", "2.8")]
    public void Is_WhileAnotherRunsOnTheThread_IsFalseUntilThatLeaves()
    {
        var scope = new RunningScope();
        scope.Enter(_first);
        (bool First, bool Second) nested = RunSecond();
        bool after = RunningManager.Is(_first);
        bool second = RunningManager.Is(_second);
        scope.Leave();

        Assert.Equal((false, true), nested);
        Assert.Equal((true, false), (after, second));
    }

    [Fact]
    public void Is_WhileItRunsOnceMoreOnTheThread_IsTrueUntilTheOuterLeaves()
    {
        var scope = new RunningScope();
        scope.Enter(_first);
        var inner = new RunningScope();
        inner.Enter(_first);
        bool nested = RunningManager.Is(_first);
        inner.Leave();
        bool after = RunningManager.Is(_first);
        scope.Leave();

        Assert.Equal((true, true, false), (nested, after, RunningManager.Is(_first)));
    }

    [Fact]
    public void Is_FarBelowTheMark_IsTrueForTheOneThatRuns()
    {
        var scope = new RunningScope();
        scope.Enter(_first);
        (bool First, bool Second) deep = FarBelow(() => (RunningManager.Is(_first), RunningManager.Is(_second)));
        (bool First, bool Second) nested = FarBelow(RunSecond);
        bool after = RunningManager.Is(_first);
        scope.Leave();

        Assert.Equal((true, false), deep);
        Assert.Equal((false, true), nested);
        Assert.True(after);
    }

    [Fact]
    public void Is_ScopeThatAnExceptionLeft_IsFalseOnceAbandoned()
    {
        Assert.Throws<InvalidOperationException>(EnterAndThrow);
        RunningScope.Abandon(_first);

        Assert.False(RunningManager.Is(_first));
    }

    // A manager that was restarted after a hang, while its old thread is still in its code.
    [Fact, Trait("Clause", "2.8")]
    public void Is_OneManagerOnTwoThreads_IsTrueOnBothUntilEachLeaves()
    {
        using var entered = new ManualResetEventSlim();
        using var mayLeave = new ManualResetEventSlim();
        (bool In, bool Out) onOther = default;
        var other = new Thread(() =>
        {
            var scope = new RunningScope();
            scope.Enter(_first);
            entered.Set();
            mayLeave.Wait();
            bool inside = RunningManager.Is(_first);
            scope.Leave();
            onOther = (inside, RunningManager.Is(_first));
        });

        var own = new RunningScope();
        own.Enter(_first);
        other.Start();
        entered.Wait();
        bool inside = RunningManager.Is(_first);
        own.Leave();
        bool after = RunningManager.Is(_first);
        mayLeave.Set();
        other.Join();

        Assert.Equal((true, false), (inside, after));
        Assert.Equal((true, false), onOther);
    }

    // The stacks of threads lie side by side: a mark must not reach into that of a neighbour.
    [Fact, Trait("Clause", "2.8")]
    public void Is_ManyThreadsAtRandomDepths_IsTrueForItsOwnOnly()
    {
        int seed = Environment.TickCount;
        EndpointOwner[] owners = [.. Enumerable.Range(0, 16).Select(i => NewOwner("manager " + i))];
        var wrong = new List<string>();
        using var together = new Barrier(owners.Length);
        Thread[] threads = [.. owners.Select((own, i) => new Thread(
            () =>
            {
                var random = new Random(seed + i);
                for (int round = 0; round < 10; round++)
                    AtDepth(random.Next(200), () => LookTogether(own, owners, together, wrong));
            },
            512 * 1024))];
        foreach (Thread thread in threads)
            thread.Start();
        foreach (Thread thread in threads)
            thread.Join();

        Assert.True(wrong.Count == 0, $"seed {seed}: {string.Join("; ", wrong.Take(5))}");
    }

    private void EnterAndThrow()
    {
        var scope = new RunningScope();
        scope.Enter(_first);
        throw new InvalidOperationException();
    }

    // All have entered when the first one looks, and none leaves before all have looked.
    private static void LookTogether(
        EndpointOwner own, EndpointOwner[] owners, Barrier together, List<string> wrong)
    {
        var scope = new RunningScope();
        scope.Enter(own);
        together.SignalAndWait();
        foreach (EndpointOwner owner in owners)
        {
            if (RunningManager.Is(owner) == (owner == own))
                continue;
            lock (wrong)
                wrong.Add($"on the thread of {own.Name}: {owner.Name}");
        }

        together.SignalAndWait();
        scope.Leave();
    }

    private static EndpointOwner NewOwner(string name) => new(name, isManager: true, wakeUp: null);

    private (bool First, bool Second) RunSecond()
    {
        var scope = new RunningScope();
        scope.Enter(_second);
        (bool, bool) found = (RunningManager.Is(_first), RunningManager.Is(_second));
        scope.Leave();
        return found;
    }

    private static (bool First, bool Second) FarBelow(Func<(bool, bool)> look)
    {
        Span<byte> filler = stackalloc byte[DeepBytes];
        filler.Fill(1);
        (bool, bool) found = look();
        return filler[DeepBytes - 1] == 1 ? found : default;
    }

    private static void AtDepth(int frames, Action look)
    {
        Span<byte> filler = stackalloc byte[256];
        filler.Fill(1);
        if (frames == 0)
            look();
        else
            AtDepth(frames - 1, look);
        Assert.Equal(1, filler[255]);
    }
}
