using System;
using System.Linq;
using System.Threading;
using Rabit.Core.Locks;
using Rabit.Core.RealTimeKit;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Locks;

/// <summary>
/// The lock with priority inheritance, on real threads: one holder at a time, who waits is served, a holder that ended
/// is replaced, and the holder runs with the priority of who waits (contract 1.8).
/// </summary>
public sealed class PriorityInheritanceMutexTests(ITestOutputHelper output)
{
    private readonly PriorityInheritanceMutex _mutex = new();

    [LinuxFact, Trait("Category", "Stress")]
    public void Enter_ByManyThreads_LetsOneInAtATime()
    {
        const int Threads = 4;
        const int Turns = 5000;
        long sum = 0;
        int inside = 0;
        int most = 0;
        Thread[] threads = [.. Enumerable.Range(0, Threads).Select(_ => Start(() =>
        {
            for (int i = 0; i < Turns; i++)
            {
                _mutex.Enter();
                most = Math.Max(most, ++inside);
                sum++;
                inside--;
                _mutex.Exit();
            }
        }))];
        foreach (Thread thread in threads)
            Join(thread);

        Assert.Equal(Threads * Turns, sum);
        Assert.Equal(1, most);
    }

    [LinuxFact]
    public void Enter_AgainByTheHolder_IsLeftAsOftenAsItWasEntered()
    {
        _mutex.Enter();
        _mutex.Enter();
        bool isIn = false;
        Thread other = StartWaiting(() =>
        {
            Volatile.Write(ref isIn, true);
            _mutex.Exit();
        });

        _mutex.Exit();
        Assert.False(Volatile.Read(ref isIn));
        _mutex.Exit();

        Join(other);
        Assert.True(isIn);
    }

    [LinuxFact]
    public void Enter_HolderEndedBefore_ReplacesIt()
    {
        Join(Start(_mutex.Enter));

        _mutex.Enter();
        _mutex.Exit();
        Join(Start(() =>
        {
            _mutex.Enter();
            _mutex.Exit();
        }));
    }

    [LinuxFact]
    public void Enter_HolderEndsWhileOthersWait_HandsItOn()
    {
        using var ends = new ManualResetEventSlim();
        using var holds = new ManualResetEventSlim();
        Thread holder = Start(() =>
        {
            _mutex.Enter();
            holds.Set();
            ends.Wait();
        });
        holds.Wait();
        Thread[] waiters = [.. Enumerable.Range(0, 2).Select(_ => StartWaiting(_mutex.Exit))];

        ends.Set();

        Join(holder);
        foreach (Thread waiter in waiters)
            Join(waiter);
        _mutex.Enter();
        _mutex.Exit();
    }

    [LinuxFact]
    public void Enter_ThreadIsInterrupted_WaitsOn()
    {
        bool isIn = false;
        _mutex.Enter();
        Thread other = StartWaiting(() =>
        {
            isIn = true;
            _mutex.Exit();
        });

        other.Interrupt();
        _mutex.Exit();

        Join(other);
        Assert.True(isIn);
    }

    /// <summary>
    /// A signal takes the waiter out of its sleep in the kernel, each time; it is not let in, and is served at last.
    /// </summary>
    [LinuxFact, Trait("Clause", "1.8")]
    public void Enter_UnixSignalsToTheWaiter_WaitsOn()
    {
        UnixSignal.Install();
        bool isIn = false;
        _mutex.Enter();
        Thread other = StartWaiting(
            () =>
            {
                Volatile.Write(ref isIn, true);
                _mutex.Exit();
            },
            first: null, out KernelThread waiter);

        for (int i = 0; i < 20; i++)
        {
            long before = waiter.Sleeps;
            UnixSignal.SendTo(waiter.Id);
            AwaitSleep(waiter, from: before);
            Assert.False(Volatile.Read(ref isIn));
        }

        _mutex.Exit();
        Join(other);
        Assert.True(isIn);
        _mutex.Enter();
        _mutex.Exit();
    }

    /// <summary>The holder ends while a waiter is between two sleeps.</summary>
    [LinuxFact, Trait("Clause", "1.8")]
    public void Enter_HolderEndsWhileTheWaiterIsSignalled_HandsItOn()
    {
        UnixSignal.Install();
        for (int round = 0; round < 20; round++)
        {
            using var ends = new ManualResetEventSlim();
            using var holds = new ManualResetEventSlim();
            Thread holder = Start(() =>
            {
                _mutex.Enter();
                holds.Set();
                ends.Wait();
            });
            holds.Wait();
            Thread waiting = StartWaiting(
                () =>
                {
                    ends.Wait();
                    _mutex.Exit();
                },
                first: null, out KernelThread waiter);

            for (int i = 0; i < round; i++)
                UnixSignal.SendTo(waiter.Id);
            ends.Set();

            Join(holder);
            Join(waiting);
        }

        _mutex.Enter();
        _mutex.Exit();
    }

    [LinuxFact, Trait("Clause", "1.8")]
    public void Enter_ByAThreadOfHigherPriority_LendsItToTheHolder()
    {
        const int Priority = 7;
        _mutex.Enter();
        int before = new KernelThread(InheritanceFutex.ThreadId).Priority;
        int error = 0;
        Thread other = StartWaiting(_mutex.Exit, first: () =>
            error = new LinuxThreadControl().SetPriority(RealTimePolicy.Fifo, Priority));
        int meanwhile = new KernelThread(InheritanceFutex.ThreadId).Priority;
        _mutex.Exit();
        Join(other);

        if (error != 0)
        {
            output.WriteLine($"Not shown: no real-time priority is granted here ({SystemErrors.Name(error)}).");
            return;
        }

        Assert.Equal(-1 - Priority, meanwhile);
        Assert.Equal(before, new KernelThread(InheritanceFutex.ThreadId).Priority);
    }

    // Starts a thread that enters, and returns when it waits for the lock in the kernel.
    private Thread StartWaiting(Action inside, Action? first = null) => StartWaiting(inside, first, out _);

    private Thread StartWaiting(Action inside, Action? first, out KernelThread waiter)
    {
        int id = 0;
        Thread thread = Start(() =>
        {
            first?.Invoke();
            Volatile.Write(ref id, InheritanceFutex.ThreadId);
            _mutex.Enter();
            inside();
        });
        Await(() => Volatile.Read(ref id) != 0, "the thread does not run");
        var started = waiter = new KernelThread(Volatile.Read(ref id));
        AwaitSleep(started);
        return thread;
    }

    // Between its last line and the lock a thread runs; it sleeps nowhere else, but may be stopped for a collection.
    private static void AwaitSleep(KernelThread thread, long from = 0)
    {
        const int FutexLock = 6 | 128;   // FUTEX_LOCK_PI | FUTEX_PRIVATE_FLAG
        Await(() => thread.Sleeps > from && thread.IsInFutex(FutexLock), "the thread does not wait for the lock");
    }

    private static void Await(Func<bool> condition, string otherwise)
    {
        var timeout = new TestTimeout();
        while (!condition())
            Assert.True(timeout.TryWait(), otherwise);
    }

    private static Thread Start(Action work)
    {
        var thread = new Thread(() => work()) { IsBackground = true };
        thread.Start();
        return thread;
    }

    private static void Join(Thread thread)
        => Assert.True(thread.Join(TestTimeout.Limit), "a thread waits for a lock that is free");
}
