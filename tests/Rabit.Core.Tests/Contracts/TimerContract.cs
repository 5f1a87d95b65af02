using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.3: the timer. Fixed periods have a contract of their own.</summary>
public abstract class TimerContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "1.3")]
    public void WakeUpDelay_NotSet_IsOneSecond()
        => Assert.Equal(TimeSpan.FromSeconds(1), new PlainManager().WakeUpDelay);

    [Theory, Trait("Clause", "1.3")]
    [InlineData(0)]
    [InlineData(-1)]
    public void WakeUpDelay_NotPositive_IsRefusedByName(long ticks)
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("lazy");

        var error = Assert.Throws<ArgumentOutOfRangeException>(() => manager.WakeUpDelay = TimeSpan.FromTicks(ticks));

        Assert.Contains("'lazy'", error.Message, StringComparison.Ordinal);
        Assert.Equal(TimeSpan.FromHours(1), manager.WakeUpDelay);
    }

    [Fact, Trait("Clause", "1.3")]
    public void WakeUpDelay_MaxValue_IsLegalAndWakesStillCome()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.MaxValue;

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request], manager.Causes);
    }

    [Fact, Trait("Clause", "1.3")]
    public void WakeUpDelay_Infinite_LeavesTheManagerToEvents()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = Timeout.InfiniteTimeSpan;

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(20));
        Assert.Equal(Timeout.InfiniteTimeSpan, run.StatusOf(manager).WakeUpDelay);
        run.On(manager, () => manager.WakeUpDelay = TimeSpan.FromMilliseconds(5));
        run.Until(() => manager.Causes[manager.Causes.Count - 1] == WakeUpCauses.Timer, "the timer wakes it again");
        run.Finish();

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request, WakeUpCauses.Request], manager.Causes.Take(3));
    }

    [Fact, Trait("Clause", "1.3")]
    public void Timer_BetweenUnits_StartsWhenTheManagerGoesToSleepAndIsNeverEarly()
    {
        var delay = TimeSpan.FromMilliseconds(20);
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = delay;
        var begins = new List<TimeSpan>();
        var ends = new List<TimeSpan>();
        manager.OnUnit = () =>
        {
            begins.Add(manager.Time);
            ends.Add(manager.Time);
        };

        run.Start();
        run.Until(() => manager.Units >= 5, "five units run");
        run.Finish();

        for (int i = 1; i < begins.Count; i++)
            Assert.True(begins[i] - ends[i - 1] >= delay, $"unit {i} came after {begins[i] - ends[i - 1]}");
    }

    [Fact, Trait("Clause", "1.3")]
    public void WakeUpDelay_ChangedInAUnit_HoldsFromTheNextSleep()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.On(manager, () => manager.WakeUpDelay = TimeSpan.FromMilliseconds(5));
        run.Until(() => manager.Units >= 4, "the short timer wakes it");
        run.On(manager, () => manager.WakeUpDelay = TimeSpan.FromHours(1));
        int units = manager.Units;
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal(WakeUpCauses.Timer, manager.Causes[2]);
        Assert.Equal(TimeSpan.FromHours(1), run.StatusOf(manager).WakeUpDelay);
        Assert.DoesNotContain(manager.Causes.Skip(units), cause => (cause & WakeUpCauses.Timer) != 0);
    }

    private sealed class PlainManager() : RabitManager("plain")
    {
        protected override void ExecuteUnitOfWork()
        {
        }
    }
}

public sealed class TimerInRealTime() : TimerContract(TimeKind.Real);

public sealed class TimerInVirtualTime() : TimerContract(TimeKind.Virtual);
