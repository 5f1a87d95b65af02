using System;
using System.Diagnostics;
using System.Threading;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.WakeUp;

/// <summary>
/// What every wait engine keeps to: a signal ends the wait, is kept for one wait, and a timer is never early.
/// </summary>
public abstract class WaitSignalContract
{
    private static TimeSpan MaxWait => TestTimeout.Limit;

    private readonly RunClock _clock = new(TimeProvider.System);

    [Fact]
    public void Wait_SignalIsThere_ComesBackAtOnceAndTakesIt()
    {
        // A Unix signal to the thread may end a wait early, and Mono's collector sends one for every collection that
        // other tests cause; signals that do not merge end each of the attempts.
        TimeSpan shortWait = TimeSpan.FromMilliseconds(2);
        TimeSpan rest = TimeSpan.Zero;
        for (int attempt = 0; attempt < 1000 && rest.Ticks < shortWait.Ticks / 2; attempt++)
        {
            using IWaitSignal signal = Create();
            signal.Set();
            signal.Set();

            signal.Wait(TimeSpan.FromHours(2));

            TimeSpan begin = _clock.Now;
            signal.Wait(begin + shortWait);
            rest = _clock.Now - begin;
        }

        Assert.True(rest.Ticks >= shortWait.Ticks / 2, $"two signals did not merge: waited {rest}");
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-5)]
    public void Wait_TimeIsOver_ComesBackAtOnce(int milliseconds)
    {
        using IWaitSignal signal = Create();
        signal.Wait(_clock.Now + TimeSpan.FromMilliseconds(milliseconds));
        signal.Wait(TimeSpan.Zero);
    }

    [Theory]
    [InlineData(0.3, false)]
    [InlineData(1, false)]
    [InlineData(12.5, false)]
    [InlineData(1010, false)]
    [InlineData(0.3, true)]
    [InlineData(12.5, true)]
    public void Wait_NoSignal_SleepsUntilItsTime(double milliseconds, bool hasOwnClock)
    {
        var clock = new RunClock(hasOwnClock ? new OwnClock() : TimeProvider.System);
        using IWaitSignal signal = Create(clock);
        TimeSpan until = clock.Now + TimeSpan.FromTicks((long)(milliseconds * TimeSpan.TicksPerMillisecond));
        int waits = 0;

        do
        {
            signal.Wait(until);
            waits++;
        }
        while (clock.Now < until);

        // A Unix signal may end a wait early, as Mono's collector sends them to all threads; an engine that does not
        // sleep would come here more than a hundred times in a millisecond.
        Assert.InRange(waits, 1, 20 + (int)(2 * milliseconds));
    }

    [Fact]
    public void Set_SleeperSleeps_EndsTheWait()
    {
        using IWaitSignal signal = Create();
        bool isSet = false;
        var sleeper = new Thread(() =>
        {
            while (!Volatile.Read(ref isSet))
                signal.Wait(TimeSpan.MaxValue);
        });
        sleeper.Start();
        Assert.False(sleeper.Join(TimeSpan.FromMilliseconds(30)), "the sleeper did not sleep");

        Volatile.Write(ref isSet, true);
        signal.Set();

        Assert.True(sleeper.Join(MaxWait), "the sleeper sleeps on");
    }

    [Fact]
    public void Set_TwoThreadsInTurn_LosesNoSignal()
    {
        const int Rounds = 20_000;
        using IWaitSignal ping = Create();
        using IWaitSignal pong = Create();
        int pings = 0;
        int pongs = 0;
        var other = new Thread(() =>
        {
            for (int round = 1; round <= Rounds; round++)
            {
                while (Volatile.Read(ref pings) < round)
                    ping.Wait(_clock.Now + MaxWait);
                Volatile.Write(ref pongs, round);
                pong.Set();
            }
        });
        other.Start();

        for (int round = 1; round <= Rounds; round++)
        {
            Volatile.Write(ref pings, round);
            ping.Set();
            var waited = Stopwatch.StartNew();
            while (Volatile.Read(ref pongs) < round)
            {
                Assert.True(waited.Elapsed < MaxWait, $"a signal was lost in round {round}");
                pong.Wait(_clock.Now + MaxWait);
            }
        }

        Assert.True(other.Join(MaxWait));
    }

    [Fact]
    public void Set_AfterDispose_DoesNothing()
    {
        IWaitSignal signal = Create();
        signal.Dispose();
        signal.Set();
    }

    private protected abstract IWaitSignal Create(RunClock clock);

    private IWaitSignal Create() => Create(_clock);

    /// <summary>The same time as the system's, which an engine cannot know.</summary>
    private sealed class OwnClock : TimeProvider;
}

public sealed class EventWaitSignalTests : WaitSignalContract
{
    private protected override IWaitSignal Create(RunClock clock) => new EventWaitSignal<SyncPoints>(clock);
}

public sealed class FutexWaitSignalTests : WaitSignalContract
{
    // The build machines are Linux; a machine without it would run the engine that it cannot have.
    private protected override IWaitSignal Create(RunClock clock)
        => WaitEngines.Create(Futex.IsThere ? WaitEngine.Futex : WaitEngine.Event, clock);

    [Fact]
    public void IsThere_OnLinux_IsTrue()
        => Assert.True(
            Futex.IsThere || Environment.OSVersion.Platform != PlatformID.Unix, "the kernel says no to futexes");
}
