using System;
using System.Diagnostics;
using System.Threading;
using Rabit.Core.Synchronization;
using Xunit;

namespace Rabit.Core.Tests.Time;

/// <summary>What every wait engine keeps to: a signal ends the wait, is kept for one wait, and a timer is never early.</summary>
public abstract class WaitSignalContract
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(20);

    [Fact]
    public void Wait_SignalIsThere_ComesBackAtOnceAndTakesIt()
    {
        using IWaitSignal signal = Create();
        signal.Set();
        signal.Set();

        signal.Wait(TimeSpan.FromHours(2));

        var rest = Stopwatch.StartNew();
        signal.Wait(TimeSpan.FromMilliseconds(20));
        Assert.True(rest.Elapsed >= TimeSpan.FromMilliseconds(19), $"two signals did not merge: waited {rest.Elapsed}");
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-5)]
    public void Wait_NoTime_ComesBackAtOnce(int milliseconds)
    {
        using IWaitSignal signal = Create();
        signal.Wait(TimeSpan.FromMilliseconds(milliseconds));
    }

    [Theory]
    [InlineData(0.3)]
    [InlineData(1)]
    [InlineData(12.5)]
    [InlineData(1010)]
    public void Wait_NoSignal_IsNeverEarly(double milliseconds)
    {
        using IWaitSignal signal = Create();
        var wait = TimeSpan.FromTicks((long)(milliseconds * TimeSpan.TicksPerMillisecond));
        var waited = Stopwatch.StartNew();

        signal.Wait(wait);

        Assert.True(waited.Elapsed >= wait, $"waited {waited.Elapsed} instead of {wait}");
    }

    [Fact]
    public void Set_SleeperSleeps_EndsTheWait()
    {
        using IWaitSignal signal = Create();
        var sleeper = new Thread(() => signal.Wait(TimeSpan.MaxValue));
        sleeper.Start();
        Assert.False(sleeper.Join(TimeSpan.FromMilliseconds(30)), "the sleeper did not sleep");

        signal.Set();

        Assert.True(sleeper.Join(Patience), "the sleeper sleeps on");
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
                    ping.Wait(Patience);
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
                Assert.True(waited.Elapsed < Patience, $"a signal was lost in round {round}");
                pong.Wait(Patience);
            }
        }

        Assert.True(other.Join(Patience));
    }

    [Fact]
    public void Set_AfterDispose_DoesNothing()
    {
        IWaitSignal signal = Create();
        signal.Dispose();
        signal.Set();
    }

    private protected abstract IWaitSignal Create();
}

public sealed class EventWaitSignalTests : WaitSignalContract
{
    private protected override IWaitSignal Create() => new EventWaitSignal<SyncPoints>();
}

public sealed class FutexWaitSignalTests : WaitSignalContract
{
    // The build machines are Linux; a machine without it would run the engine that it cannot have.
    private protected override IWaitSignal Create() => WaitEngines.Create(Futex.IsThere ? WaitEngine.Futex : WaitEngine.Event);

    [Fact]
    public void IsThere_OnLinux_IsTrue()
        => Assert.True(Futex.IsThere || Environment.OSVersion.Platform != PlatformID.Unix, "the kernel says no to futexes");
}
