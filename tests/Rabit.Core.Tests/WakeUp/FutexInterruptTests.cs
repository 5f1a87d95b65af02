using System;
using System.Threading;
using Rabit.Core.Locks;
using Rabit.Core.Tests.Contracts;
using Rabit.Core.Tests.Locks;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.WakeUp;

/// <summary>
/// Unix signals to threads that wait on a futex (EINTR): the wait may end early, but no signal of ours is lost and no
/// unit of work runs without a reason.
/// </summary>
public sealed class FutexInterruptTests
{
    private const int FutexWait = 9 | 128;   // FUTEX_WAIT_BITSET | FUTEX_PRIVATE_FLAG

    [LinuxFact, Trait("Clause", "1.4")]
    public void Wait_UnixSignal_ComesBackWithoutASignalAndKeepsTheNext()
    {
        UnixSignal.Install();
        using IWaitSignal signal = NewSignal(out _);
        int id = 0;
        int returns = 0;
        bool isSet = false;
        var sleeper = new Thread(() =>
        {
            Volatile.Write(ref id, InheritanceFutex.ThreadId);
            while (!Volatile.Read(ref isSet))
            {
                signal.Wait(TimeSpan.MaxValue);
                Interlocked.Increment(ref returns);
            }
        })
        {
            IsBackground = true,
        };
        sleeper.Start();
        Await(() => Volatile.Read(ref id) != 0, "it does not run");
        var kernel = new KernelThread(Volatile.Read(ref id));

        for (int i = 0; i < 20; i++)
        {
            Await(() => kernel.IsInFutex(FutexWait), "it does not sleep");
            int before = Volatile.Read(ref returns);
            UnixSignal.SendTo(kernel.Id);
            Await(() => Volatile.Read(ref returns) > before, "the signal does not end the wait");
        }

        Volatile.Write(ref isSet, true);
        signal.Set();
        Assert.True(sleeper.Join(TestTimeout.Limit), "it sleeps on");
    }

    [LinuxFact, Trait("Clause", "1.4"), Trait("Category", "Stress")]
    public void Set_TwoThreadsInTurnBothInterrupted_LosesNoSignal()
    {
        const int Rounds = 5000;
        UnixSignal.Install();
        using IWaitSignal ping = NewSignal(out RunClock clock);
        using IWaitSignal pong = NewSignal(out _);
        int pings = 0;
        int pongs = 0;
        int first = 0;
        int second = 0;
        var mayEnd = new ManualResetEventSlim();   // a thread that has ended cannot be signalled
        Thread Start(Action<int> round, Action<int> publish)
        {
            var thread = new Thread(() =>
            {
                publish(InheritanceFutex.ThreadId);
                for (int i = 1; i <= Rounds; i++)
                    round(i);
                mayEnd.Wait();
            })
            {
                IsBackground = true,
            };
            thread.Start();
            return thread;
        }

        void Receive(IWaitSignal signal, ref int count, int round)
        {
            while (Volatile.Read(ref count) < round)
                signal.Wait(clock.Now + TimeSpan.FromHours(1));
        }

        Thread one = Start(
            i =>
            {
                Volatile.Write(ref pings, i);
                ping.Set();
                Receive(pong, ref pongs, i);
            },
            id => Volatile.Write(ref first, id));
        Thread other = Start(
            i =>
            {
                Receive(ping, ref pings, i);
                Volatile.Write(ref pongs, i);
                pong.Set();
            },
            id => Volatile.Write(ref second, id));
        Await(() => Volatile.Read(ref first) != 0 && Volatile.Read(ref second) != 0, "they do not run");

        // No more signals until they have gone on: the next would make good what one has cost.
        while (Volatile.Read(ref pongs) is var from && from < Rounds)
        {
            UnixSignal.SendTo(Volatile.Read(ref first));
            UnixSignal.SendTo(Volatile.Read(ref second));
            int until = Math.Min(from + 10, Rounds);
            Assert.True(
                SpinWait.SpinUntil(() => Volatile.Read(ref pongs) >= until, TestTimeout.Limit),
                $"a signal was lost in round {Volatile.Read(ref pongs)}");
        }

        mayEnd.Set();
        Assert.True(one.Join(TestTimeout.Limit));
        Assert.True(other.Join(TestTimeout.Limit));
    }

    [LinuxFact, Trait("Clause", "1.4"), Trait("Clause", "1.3")]
    public void UnitOfWork_UnixSignalsToTheSleepingManager_RunsForItsWakesAlone()
    {
        UnixSignal.Install();
        using var run = new TestRun(TimeKind.Real, o => o.Time = new RealTime { WaitEngine = WaitEngine.Futex });
        ScriptedManager manager = run.Add("m");
        int id = 0;
        manager.OnStartup = () => id = InheritanceFutex.ThreadId;
        run.StartAndSettle();
        var thread = new KernelThread(id);

        run.Until(() => thread.IsInFutex(FutexWait), "it sleeps");

        for (int i = 0; i < 20; i++)
        {
            long before = thread.Sleeps;
            UnixSignal.SendTo(id);
            run.Until(() => thread.Sleeps > before && thread.IsInFutex(FutexWait), "it sleeps again");
            Assert.Equal(1 + i, manager.Units);

            UnixSignal.SendTo(id);
            run.OnAndSettle(manager, () => { });
            Assert.Equal(2 + i, manager.Units);
        }

        run.Finish();
    }

    private static IWaitSignal NewSignal(out RunClock clock)
    {
        clock = new RunClock(TimeProvider.System);
        return WaitEngines.Create(WaitEngine.Futex, clock);
    }

    private static void Await(Func<bool> condition, string otherwise)
    {
        var timeout = new TestTimeout();
        while (!condition())
            Assert.True(timeout.TryWait(), otherwise);
    }
}
