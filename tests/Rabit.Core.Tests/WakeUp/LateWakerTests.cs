using System;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Core.Tests.Time;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.WakeUp;

/// <summary>
/// Contract 1.4 and 4.4 at their narrowest: a waker that has set its cause, and is held up just before it signals. The
/// clock that it reads there is the test's, and holds it.
/// </summary>
public sealed class LateWakerTests
{
    [Fact, Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    public void Wake_HeldUpUntilTheRunHasEnded_DoesNotThrow()
    {
        using var late = new LateWaker();
        using var run = new TestRun(TimeKind.Real, options => options.Time = new RealTime(late.Clock));
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        late.Begin(manager);
        run.Finish();

        Assert.Null(late.End());
    }

    [Fact, Trait("Clause", "4.4")]
    public void WakeLatency_WakerHeldUpUntilTheTimerCame_IsNotTakenFromAnOlderWake()
    {
        using var late = new LateWaker();
        using var run = new TestRun(TimeKind.Real, options => options.Time = new RealTime(late.Clock));
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(100);

        run.StartAndSettle();
        late.Begin(manager);
        late.Clock.Timestamp = TimeSpan.FromSeconds(1000).Ticks;
        run.Until(() => run.StatusOf(manager).Runs > 1, "the manager finds the cause when its wait times out");
        late.End();

        Assert.Equal(TimeSpan.Zero, run.StatusOf(manager).WakeLatency.Max);
    }

    private sealed class LateWaker : IDisposable
    {
        private readonly ManualResetEventSlim _isHeld = new();
        private readonly ManualResetEventSlim _release = new();
        private Thread? _thread;
        private Exception? _thrown;

        public LateWaker() => Clock.OnRead = () =>
        {
            if (Thread.CurrentThread != _thread)
                return;
            _isHeld.Set();
            _release.Wait();
        };

        public ManualClock Clock { get; } = new();

        /// <summary>Wakes until a wake is held up; the wakes before that find the manager awake.</summary>
        public void Begin(RabitManager manager)
        {
            _thread = new Thread(() =>
            {
                try
                {
                    while (!_isHeld.IsSet)
                        manager.WakeUp();
                }
                catch (Exception e)
                {
                    // For the test to see.
                    _thrown = e;
                }
            });
            _thread.Start();
            Assert.True(_isHeld.Wait(TestTimeout.Limit));
        }

        public Exception? End()
        {
            _release.Set();
            Assert.True(_thread!.Join(TestTimeout.Limit));
            return _thrown;
        }

        public void Dispose() => _release.Set();
    }
}
