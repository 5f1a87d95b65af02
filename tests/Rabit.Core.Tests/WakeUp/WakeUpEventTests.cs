using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Tests.Time;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;
using Xunit;

namespace Rabit.Core.Tests.WakeUp;

/// <summary>Contract 1.2 and 1.4 at the piece that carries them.</summary>
public sealed class WakeUpEventTests
{
    private const int Any = WakeUpEvent.Any;

    private enum Step
    {
        WakeByPost,
        WakeByPush,
        RequestStop,
        FallAsleep,
        FallAsleepForStopOnly,
        Take,
    }

    [Fact, Trait("Clause", "1.4")]
    public void Take_AfterSeveralWakes_GivesAllCausesAndTheirNumberOnce()
    {
        var wakeUp = new WakeUpEvent();
        wakeUp.Wake(WakeUpCauses.Post);
        wakeUp.Wake(WakeUpCauses.Post);
        wakeUp.Wake(WakeUpCauses.Pop);

        ConsumedWakeUps taken = wakeUp.Consume();
        ConsumedWakeUps empty = wakeUp.Consume();

        Assert.Equal((WakeUpCauses.Post | WakeUpCauses.Pop, 3, false), (taken.Causes, taken.Count, taken.Stop));
        Assert.Equal((WakeUpCauses.None, 0, false), (empty.Causes, empty.Count, empty.Stop));
    }

    [Fact, Trait("Clause", "1.4")]
    public void Wake_MoreThanTheCounterHolds_KeepsTheCausesAndStaysAtTheLimit()
    {
        const int Limit = (1 << 19) - 1;
        var wakeUp = new WakeUpEvent();
        for (int i = 0; i < Limit + 10; i++)
            wakeUp.Wake(WakeUpCauses.Push);
        wakeUp.Wake(WakeUpCauses.Pop);
        wakeUp.RequestStop();

        ConsumedWakeUps taken = wakeUp.Consume();

        Assert.Equal((WakeUpCauses.Push | WakeUpCauses.Pop, Limit, true), (taken.Causes, taken.Count, taken.Stop));
    }

    [Fact, Trait("Clause", "4.4")]
    public void WokenAt_WakeFromSleep_IsTheTimeOfTheFirstWake()
    {
        var clock = new ManualClock();
        var wakeUp = new WakeUpEvent();
        wakeUp.Connect(new CountingSignal(), new RunClock(clock));
        Assert.True(wakeUp.TryPrepareToWait(Any));
        clock.Timestamp = 5;
        wakeUp.Wake(WakeUpCauses.Post);
        clock.Timestamp = 9;
        wakeUp.Wake(WakeUpCauses.Post);

        Assert.Equal(TimeSpan.FromTicks(5), wakeUp.WokenAt);
    }

    /// <summary>
    /// Every sequence of seven steps, against a model that a person can check: what must be taken is a set of causes
    /// and a number, and a signal must have been given whenever something that is wanted came while the sleeper slept.
    /// </summary>
    [Fact, Trait("Clause", "1.2"), Trait("Clause", "1.4"), Trait("Clause", "1.6")]
    public void Steps_InEveryOrder_LoseNoWakeAndSignalEverySleeper()
    {
        const int Length = 7;
        Step[] steps =
        [
            Step.WakeByPost, Step.WakeByPush, Step.RequestStop, Step.FallAsleep, Step.FallAsleepForStopOnly, Step.Take
        ];
        int sequences = (int)Math.Pow(steps.Length, Length);
        var sequence = new Step[Length];
        for (int number = 0; number < sequences; number++)
        {
            int rest = number;
            for (int i = 0; i < Length; i++)
            {
                sequence[i] = steps[rest % steps.Length];
                rest /= steps.Length;
            }

            if (FindFault(sequence) is { } fault)
                Assert.Fail($"{string.Join(", ", sequence)}: {fault}");
        }
    }

    private static string? FindFault(IEnumerable<Step> sequence)
    {
        var signal = new CountingSignal();
        var wakeUp = new WakeUpEvent();
        wakeUp.Connect(signal, Clock);
        WakeUpCauses causes = WakeUpCauses.None;
        int count = 0;
        bool stop = false;
        int sleepsFor = 0;   // 0: awake; else what ends the sleep

        foreach (Step step in sequence)
        {
            int signalsBefore = signal.Count;
            switch (step)
            {
                case Step.WakeByPost:
                case Step.WakeByPush:
                    WakeUpCauses cause = step == Step.WakeByPost ? WakeUpCauses.Post : WakeUpCauses.Push;
                    bool ends = sleepsFor == Any && causes == WakeUpCauses.None && !stop;
                    wakeUp.Wake(cause);
                    causes |= cause;
                    count++;
                    if (ends && signal.Count == signalsBefore)
                        return "a wake did not signal the sleeper";
                    if (sleepsFor == 0 && signal.Count != signalsBefore)
                        return "a wake signalled no thread";
                    break;
                case Step.RequestStop:
                    wakeUp.RequestStop();
                    stop = true;
                    if (sleepsFor != 0 && signal.Count == signalsBefore)
                        return "a stop did not signal the sleeper";
                    break;
                case Step.FallAsleep:
                case Step.FallAsleepForStopOnly:
                    int wanted = step == Step.FallAsleep ? Any : WakeUpEvent.Stop;
                    bool mayNot = stop || (wanted == Any && causes != WakeUpCauses.None);
                    if (wakeUp.Has(wanted) != mayNot)
                        return "it does not know what it has";
                    if (wakeUp.TryPrepareToWait(wanted) == mayNot)
                        return mayNot ? "it fell asleep over a wake" : "it did not fall asleep";
                    if (!mayNot)
                        sleepsFor = wanted;
                    break;
                case Step.Take:
                    ConsumedWakeUps taken = wakeUp.Consume();
                    if ((taken.Causes, taken.Count, taken.Stop) != (causes, count, stop))
                        return "it took something else than came";
                    (causes, count, stop, sleepsFor) = (WakeUpCauses.None, 0, false, 0);
                    break;
            }

            if (wakeUp.StopRequested != stop)
                return "it lost a stop";
        }

        return null;
    }

    private static readonly RunClock Clock = new(new ManualClock());

    private sealed class CountingSignal : IWakeSignal
    {
        public int Count { get; private set; }

        public void Set() => Count++;
    }
}
