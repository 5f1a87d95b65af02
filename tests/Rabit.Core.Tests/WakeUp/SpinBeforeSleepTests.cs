using System;
using Rabit.Core.RealTimeKit;
using Rabit.Core.Tests.Contracts;
using Rabit.Core.Tests.RealTimeKit;
using Rabit.Core.Tests.Time;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Xunit;

namespace Rabit.Core.Tests.WakeUp;

/// <summary>A look for wake-ups before the sleep: no sleep where one comes, never longer than asked.</summary>
public sealed class SpinBeforeSleepTests : IDisposable
{
    private static readonly TimeSpan Spin = TimeSpan.FromTicks(1000);

    private readonly ManualClock _clock = new();
    private readonly WakeUpEvent _wakeUp = new();
    private readonly WaitingSignal _signal = new();

    [Fact, Trait("Clause", "1.4")]
    public void Run_WakeComesDuringTheSpin_DoesNotSleep()
    {
        int reads = 0;
        _clock.OnRead = () =>
        {
            _clock.Timestamp += 10;
            if (++reads == 5)
                _wakeUp.Wake(WakeUpCauses.Push);
        };

        ConsumedWakeUps wakes = RunOneStep(NextStep.At(TimeSpan.MaxValue, spin: Spin), out TimeSpan? wokenAt);

        Assert.Equal((WakeUpCauses.Push, 1, 0), (wakes.Causes, wakes.Count, _signal.Waits));
        Assert.InRange(wakes.Spun.Ticks, 10, 100);
        Assert.Equal(wakes.Spun, wakes.SpunUntil);   // it spins from time zero on
        Assert.Null(wokenAt);
    }

    [Fact, Trait("Clause", "1.4")]
    public void Run_NoWakeDuringTheSpin_SleepsWhenItIsOver()
    {
        _clock.OnRead = () => _clock.Timestamp += 10;
        _signal.OnWait = () => _wakeUp.Wake(WakeUpCauses.Post);

        ConsumedWakeUps wakes = RunOneStep(NextStep.At(TimeSpan.MaxValue, spin: Spin), out TimeSpan? wokenAt);

        Assert.Equal((WakeUpCauses.Post, 1), (wakes.Causes, _signal.Waits));
        Assert.InRange(wakes.Spun, Spin, Spin + TimeSpan.FromTicks(20));
        Assert.Equal(TimeSpan.Zero, wakes.SpunUntil);   // the sleep has made it old
        Assert.NotNull(wokenAt);
    }

    [Fact, Trait("Clause", "1.3")]
    public void Run_TimerIsDueDuringTheSpin_EndsItThen()
    {
        _clock.OnRead = () => _clock.Timestamp += 10;
        TimeSpan due = TimeSpan.FromTicks(200);

        ConsumedWakeUps wakes = RunOneStep(NextStep.At(due, spin: Spin), out TimeSpan? wokenAt);

        Assert.Equal((WakeUpCauses.Timer, 0, due), (wakes.Causes, _signal.Waits, wokenAt));
        Assert.InRange(wakes.Spun, due, due + TimeSpan.FromTicks(20));
    }

    [Fact, Trait("Clause", "1.6")]
    public void Run_StopDuringTheSpin_EndsAtOnce()
    {
        int reads = 0;
        _clock.OnRead = () =>
        {
            _clock.Timestamp += 10;
            if (++reads == 3)
                _wakeUp.RequestStop();
        };

        int steps = 0;
        New().Run(NextStep.At(TimeSpan.MaxValue, spin: Spin), (_, _) =>
        {
            steps++;
            return NextStep.Never;
        });

        Assert.Equal((0, 0), (steps, _signal.Waits));
    }

    [Theory]
    [InlineData(1, false)]
    [InlineData(2, true)]
    public void Run_ProcessWithOneProcessor_SleepsWithoutASpin(int processors, bool spins)
    {
        _clock.OnRead = () => _clock.Timestamp += 10;
        _signal.OnWait = () => _wakeUp.Wake(WakeUpCauses.Post);
        SpinPermit permit = new SharedCpus(new FakeThreadControl(0, 1), processors).Enter();

        ConsumedWakeUps wakes = RunOneStep(NextStep.At(TimeSpan.MaxValue, spin: Spin), out _, permit);

        Assert.Equal(spins, wakes.Spun > TimeSpan.Zero);
    }

    [Fact]
    public void Permit_ThreadsWithOneCpuOnly_IsGivenWhereNoOtherSharesIt()
    {
        var control = new FakeThreadControl(0, 1, 2);
        var cpus = new SharedCpus(control, processors: 3);
        SpinPermit anywhere = cpus.Enter();
        control.SetCpus([1]);
        SpinPermit first = cpus.Enter();
        control.SetCpus([2]);
        SpinPermit other = cpus.Enter();
        Assert.Equal((true, true, true), (anywhere.IsGiven, first.IsGiven, other.IsGiven));

        control.SetCpus([1]);
        SpinPermit second = cpus.Enter();

        Assert.Equal(
            (true, false, true, false), (anywhere.IsGiven, first.IsGiven, other.IsGiven, second.IsGiven));
    }

    [Fact]
    public void Permit_ThreadsThatCannotBePinned_IsGiven()
        => Assert.True(new SharedCpus(control: null, processors: 2).Enter().IsGiven);

    [Theory]
    [InlineData(-1)]
    [InlineData(1001)]
    public void SpinBeforeSleep_OutOfRange_NamesTheManager(long ticks)
    {
        var manager = new ScriptedManager("m", new TestBoard());

        var e = Assert.Throws<ArgumentOutOfRangeException>(() => manager.SpinBeforeSleep = TimeSpan.FromTicks(ticks));

        Assert.Contains("The spin of manager 'm' before it sleeps must be 0 to 100 µs", e.Message);
        Assert.Equal(TimeSpan.Zero, manager.SpinBeforeSleep);
    }

    [Fact, Trait("Clause", "1.2")]
    public void Managers_ThatAnswerEachOther_LoseNothingAndCountTheSpin()
    {
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager server = run.Add("server");
        ScriptedManager answerer = run.Add("answerer");
        server.SpinBeforeSleep = answerer.SpinBeforeSleep = Spin;
        QueueSender<int> ping = server.Send<int>("ping");
        QueueReceiver<int> pings = answerer.Receive<int>("ping", capacity: 4);
        QueueSender<int> pong = answerer.Send<int>("pong");
        QueueReceiver<int> pongs = server.Receive<int>("pong", capacity: 4);
        int returned = 0;
        answerer.OnUnit = () =>
        {
            while (pings.TryPop(out int ball))
                _ = pong.Push(ball);
        };
        server.OnUnit = () =>
        {
            if (returned == 0)
                _ = ping.Push(0);
            while (pongs.TryPop(out int ball))
            {
                System.Threading.Volatile.Write(ref returned, ball + 1);
                if (returned < 2000)
                    _ = ping.Push(returned);
            }
        };

        run.Start();
        run.Until(() => System.Threading.Volatile.Read(ref returned) == 2000, "the ball came back 2000 times");
        TimeSpan spun = run.StatusOf(server).SpinTime;

        Assert.Equal(Environment.ProcessorCount > 1, spun > TimeSpan.Zero);
    }

    [Fact, Trait("Clause", "5.2")]
    public void Manager_InVirtualTime_DoesNotSpin()
    {
        using var run = new TestRun(TimeKind.Virtual);
        ScriptedManager manager = run.Add("m");
        manager.SpinBeforeSleep = Spin;

        run.StartAndSettle();

        Assert.Equal(TimeSpan.Zero, run.StatusOf(manager).SpinTime);
    }

    public void Dispose() => _signal.Dispose();

    private StepLoop<SyncPoints> New(SpinPermit? permit = null)
    {
        var clock = new RunClock(_clock);
        _wakeUp.Connect(_signal, clock);
        return new StepLoop<SyncPoints>(_wakeUp, _signal, clock, permit);
    }

    private ConsumedWakeUps RunOneStep(NextStep step, out TimeSpan? wokenAt, SpinPermit? permit = null)
    {
        ConsumedWakeUps first = default;
        TimeSpan? firstWokenAt = null;
        New(permit).Run(step, (wakes, at) =>
        {
            (first, firstWokenAt) = (wakes, at);
            _wakeUp.RequestStop();
            return NextStep.Never;
        });
        wokenAt = firstWokenAt;
        return first;
    }

    private sealed class WaitingSignal : IWaitSignal
    {
        public int Waits { get; private set; }

        public Action? OnWait { get; set; }

        public void Set()
        {
        }

        public void Wait(TimeSpan until)
        {
            Waits++;
            OnWait?.Invoke();
        }

        public void Dispose()
        {
        }
    }
}
