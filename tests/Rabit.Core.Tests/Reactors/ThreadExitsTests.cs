using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Reactors;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

public sealed class ThreadExitsTests
{
    [Fact]
    public void Open_WithThreadsThatWait_LetsAllGo()
    {
        var exits = new ThreadExits(TimeSpan.FromHours(1));
        Thread[] threads = Start(exits.Wait, 5);
        Assert.True(
            SpinWait.SpinUntil(
                () => threads.All(t => (t.ThreadState & ThreadState.WaitSleepJoin) != 0), TestTimeout.Limit),
            "the threads wait");

        exits.Open();

        Assert.All(threads, t => Assert.True(t.Join(TestTimeout.Limit)));
    }

    [Fact]
    public void Wait_AfterOpen_DoesNotWait()
    {
        var exits = new ThreadExits(TimeSpan.FromHours(1));

        exits.Open();

        Assert.All(Start(exits.Wait, 3), t => Assert.True(t.Join(TestTimeout.Limit)));
    }

    [Fact]
    public void Wait_WithoutOpen_EndsWithItsLimit()
    {
        var exits = new ThreadExits(TimeSpan.FromMilliseconds(1));

        Assert.All(Start(exits.Wait, 3), t => Assert.True(t.Join(TestTimeout.Limit)));
    }

    [Fact, Trait("Clause", "4.3")]
    public void Finish_ThreadsOfManagers_ExitSoonAfterIt()
    {
        var threads = new List<Thread>();
        using var run = new TestRun(TimeKind.Real);
        foreach (string name in new[] { "a", "b", "c" })
            run.Add(name).OnStartup = () => threads.Add(Thread.CurrentThread);
        run.StartAndSettle();

        run.Finish();

        Assert.Equal(3, threads.Count);
        Assert.All(threads, t => Assert.True(t.Join(TestTimeout.Limit)));
    }

    private static Thread[] Start(ThreadStart wait, int count)
    {
        Thread[] threads = Enumerable.Range(0, count).Select(_ => new Thread(wait) { IsBackground = true }).ToArray();
        foreach (Thread thread in threads)
            thread.Start();
        return threads;
    }
}
