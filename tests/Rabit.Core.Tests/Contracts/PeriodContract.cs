using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.3: a fixed period.</summary>
public abstract class PeriodContract(TimeKind kind) : ContractTests(kind)
{
    private static readonly TimeSpan Period = TimeSpan.FromMilliseconds(20);

    [Theory, Trait("Clause", "1.3")]
    [InlineData(0)]
    [InlineData(-1)]
    public void Period_NotPositive_IsRefusedByName(int milliseconds)
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        var thrown = Assert.Throws<ArgumentOutOfRangeException>(
            () => manager.Period = TimeSpan.FromMilliseconds(milliseconds));

        Assert.Contains("'m'", thrown.Message, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "1.3")]
    public void Period_OtherWakesInBetween_KeepsTheGrid()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.Period = Period;
        List<TimeSpan> begins = RecordBegins(manager);
        TimeSpan start = run.Reactor.Now;

        run.StartAndSettle();
        run.Until(() => manager.Units >= 3, "the timer wakes");
        if (!Kind.HasThreads)
            run.Reactor.RunFor(TimeSpan.FromMilliseconds(7));   // not at a deadline, as it is in real time anyway
        run.OnAndSettle(manager, () => { });
        run.Until(() => manager.Units >= 8, "the timer wakes on");
        run.Finish();

        // Never early, whatever the machine does; how late it is, is for the machine and the benchmarks. The grid
        // begins after the start, and before the first unit of work can look at the clock, by however much the machine
        // stands still in between.
        // In virtual time it is exactly zero.
        IEnumerable<TimeSpan> byTimer = begins.Where((_, i) => manager.Causes[i] == WakeUpCauses.Timer);
        Assert.All(
            byTimer.Select((at, i) => at - start - TimeSpan.FromTicks(Period.Ticks * (i + 1))),
            late => Assert.True(Kind.HasThreads ? late >= TimeSpan.Zero : late == TimeSpan.Zero, $"{late}"));
    }

    [Fact, Trait("Clause", "1.3")]
    public void Period_SetByAUnitOfWork_HoldsFromTheNextSleep()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.OnAndSettle(manager, () => manager.Period = Period);
        run.Until(() => manager.Causes.Count(c => c == WakeUpCauses.Timer) >= 3, "the timer wakes with the period");
        Assert.Equal(Period, run.StatusOf(manager).WakeUpDelay);
        run.OnAndSettle(manager, () => manager.Period = null);
        run.Finish();
    }

    /// <summary>A delay after each unit of work has no deadlines that it could miss.</summary>
    [Fact, Trait("Clause", "1.3"), Trait("Clause", "4.4")]
    public void WakeUpDelay_WithoutAPeriod_CountsNoPeriodError()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(2);

        run.Start();
        run.Until(() => manager.Causes.Count(c => c == WakeUpCauses.Timer) >= 5, "the timer wakes");
        ManagerStatus status = run.Finish().Managers[0].Status;

        Assert.Equal((0, 0), (status.PeriodError.Count, status.MissedDeadlines));
    }

    private static List<TimeSpan> RecordBegins(ScriptedManager manager)
    {
        var begins = new List<TimeSpan>();
        manager.OnUnit = () => begins.Add(manager.Time);
        return begins;
    }
}

public sealed class PeriodContractInRealTime() : PeriodContract(TimeKind.Real)
{
    /// <summary>
    /// However late the machine is: the deadline of each unit of work is when it began less how late it was, which the
    /// status keeps to the tick, and all deadlines are whole periods apart. A grid that began again with a wake, or
    /// with each unit of work, would be off by when that came.
    /// </summary>
    [Fact, Trait("Clause", "1.3")]
    public void Period_WokenInBetweenOnRealThreads_HasAllDeadlinesOnOneGrid()
    {
        const int Deadlines = 10;
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var period = TimeSpan.FromMilliseconds(20);
        manager.Period = period;
        var deadlines = new List<TimeSpan>();   // under the board's gate
        DurationStatistics error = default;     // the manager's thread alone
        manager.OnUnit = () =>
        {
            // Of the unit of work before.
            ref readonly ManagerStatus status = ref manager.StatusPublisher.Value;
            if (status.PeriodError.Count == error.Count)
                return;
            TimeSpan late = status.PeriodError.Total - error.Total;
            error = status.PeriodError;
            lock (run.Board.Gate)
                deadlines.Add(status.LastRunAt - late);
            run.Board.Changed();
        };

        run.StartAndSettle();
        for (int i = 1; i <= Deadlines; i++)
        {
            int count = i;
            run.Until(() => deadlines.Count >= count, "the timer wakes");
            run.OnAndSettle(manager, () => { });
        }

        run.Finish();

        Assert.True(manager.Causes.Count(c => (c & WakeUpCauses.Timer) == 0) >= Deadlines, "no other wakes came");
        Assert.All(
            deadlines.Select(d => d - deadlines[0]),
            apart => Assert.True(apart.Ticks % period.Ticks == 0, $"{apart} after the first is no deadline"));
        Assert.Equal(deadlines.Distinct().OrderBy(d => d), deadlines);
    }

    [Fact, Trait("Clause", "1.3")]
    public void Period_WorkLongerThanIt_CountsMissedDeadlinesAndRunsNoBurst()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var period = TimeSpan.FromMilliseconds(50);
        manager.Period = period;
        bool hasWorkedLong = false;
        var begins = new List<TimeSpan>();
        manager.OnUnit = () =>
        {
            begins.Add(manager.Time);
            if (hasWorkedLong || (manager.CausesNow & WakeUpCauses.Timer) == 0)
                return;
            hasWorkedLong = true;
            TimeSpan until = manager.Time + TimeSpan.FromTicks(period.Ticks * 4);
            while (manager.Time < until)
                Thread.SpinWait(100);
        };

        run.StartAndSettle();
        run.Until(() => manager.Units >= 4, "the timer wakes on");
        run.Finish();

        // Four deadlines passed: one run at once, and then the grid again.
        Assert.True(
            run.StatusOf(manager).MissedDeadlines >= 4, $"{run.StatusOf(manager).MissedDeadlines} missed deadlines");
        Assert.True(
            begins[3] - begins[1] >= TimeSpan.FromTicks(period.Ticks * 4),
            "the deadlines that passed were caught up on");
    }
}

public sealed class PeriodContractInVirtualTime() : PeriodContract(TimeKind.Virtual)
{
    [Fact, Trait("Clause", "1.3")]
    public void Period_ModelledWorkLongerThanIt_MissesDeadlinesAsSpecified()
    {
        var time = new VirtualTime(seed: 1);
        time.SetUnitOfWorkDuration("m", TimeSpan.FromMilliseconds(25));
        var board = new TestBoard();
        var manager = new ScriptedManager("m", board) { Period = TimeSpan.FromMilliseconds(10) };
        var begins = new List<TimeSpan>();
        manager.OnUnit = () => begins.Add(manager.Time);
        var reactor = new RabitReactor(time) { manager };
        MessageSubscriber<ManagerStatus> status = reactor.Workspace.SubscribeToStatus("m");

        reactor.Start();
        reactor.RunFor(TimeSpan.FromMilliseconds(80));
        status.Fetch();
        reactor.Stop();
        reactor.Finish();

        // 0 to 25 passes 10 and 20; 25 to 50 is for 20 and passes 30, 40 and 50; 50 to 75 is for 50 and passes 60 and
        // 70; the last, to 100, is for 70 and passes 80, 90 and 100.
        Assert.Equal([0, 25, 50, 75], begins.Select(b => (int)b.TotalMilliseconds));
        Assert.Equal(2 + 3 + 2 + 3, status.Value.MissedDeadlines);
    }
}
