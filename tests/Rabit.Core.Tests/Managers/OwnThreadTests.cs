using System;
using System.Linq;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Managers;

/// <summary>Contract 1.1 and 1.8 where they speak of threads.</summary>
public sealed class OwnThreadTests
{
    [Fact, Trait("Clause", "1.1")]
    public void Manager_AllItsLife_RunsOnOneThreadOfItsOwnThatBearsItsName()
    {
        using var run = new TestRun(TimeKind.Real);
        foreach (string name in new[] { "a", "b" })
        {
            ScriptedManager manager = run.Add(name);
            void Tell() => run.Board.Write($"{name} {Thread.CurrentThread.Name} {Environment.CurrentManagedThreadId}");
            manager.OnStartup = Tell;
            manager.OnUnit = Tell;
            manager.OnShutdown = Tell;
        }

        run.StartAndSettle();
        run.Finish();

        string[] distinct = run.Board.Entries.Distinct(StringComparer.Ordinal).OrderBy(e => e, StringComparer.Ordinal).ToArray();
        Assert.Equal(6, run.Board.Entries.Count);
        Assert.Equal(2, distinct.Length);
        Assert.StartsWith("a a ", distinct[0], StringComparison.Ordinal);
        Assert.StartsWith("b b ", distinct[1], StringComparison.Ordinal);
        Assert.NotEqual(distinct[0].Substring(4), distinct[1].Substring(4));
        Assert.DoesNotContain(distinct, e => e.EndsWith(" " + Environment.CurrentManagedThreadId, StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_AllItsLife_RunsOnAThreadOfItsOwnThatBearsItsName()
    {
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager manager = run.Add("m");
        void Tell() => run.Board.Write(Thread.CurrentThread.Name + " " + Environment.CurrentManagedThreadId);
        var source = new ScriptedSource(new TestBoard(), TimeSpan.Zero, 1) { OnOpen = Tell, OnRead = Tell, OnClose = Tell };
        manager.AttachReader("line", source);

        run.Start();
        run.Until(() => run.Board.Entries.Count >= 2, "the source is read");
        run.Finish();

        Assert.StartsWith("m/line ", Assert.Single(run.Board.Entries.Distinct(StringComparer.Ordinal)), StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "1.2")]
    public void Sleep_OfALongTimer_TakesNoProcessorTime()
    {
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(50));
        run.Finish();

        // It neither polls nor spins: one run, and one measured wake at most.
        Assert.Equal(1, manager.Units);
    }
}
