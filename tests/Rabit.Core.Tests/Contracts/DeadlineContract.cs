using System;
using System.Collections.Generic;
using System.Diagnostics;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 4.4: the deadline of each unit of work.</summary>
public abstract class DeadlineContract(TimeKind kind) : ContractTests(kind)
{
    private static readonly TimeSpan Duration = TimeSpan.FromMilliseconds(2);

    [Fact, Trait("Clause", "4.4")]
    public void UnitOfWork_PastItsDeadline_IsCountedAndCalledBack()
    {
        using TestRun run = NewLongRun(out ScriptedManager manager);
        var late = new List<TimeSpan>();
        manager.UnitOfWorkDeadline = TimeSpan.FromMilliseconds(1);
        manager.OnLate = late.Add;

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal(manager.Units, late.Count);
        Assert.All(late, time => Assert.True(time >= Duration));
        Assert.Equal(late.Count, run.StatusOf(manager).LateUnitsOfWork);
    }

    [Fact, Trait("Clause", "4.4")]
    public void UnitOfWork_WithinItsDeadlineOrWithoutOne_IsNotLate()
    {
        using TestRun run = NewLongRun(out ScriptedManager manager);
        manager.UnitOfWorkDeadline = TimeSpan.FromHours(1);
        manager.OnLate = _ => run.Board.Write("late");
        run.Add("free").OnLate = _ => run.Board.Write("late");

        run.StartAndSettle();
        run.OnAndSettle(manager, () => manager.UnitOfWorkDeadline = null);
        run.Finish();

        Assert.Empty(run.Board.Entries);
        Assert.Equal(0, run.StatusOf(manager).LateUnitsOfWork);
    }

    [Fact, Trait("Clause", "4.4")]
    public void UnitOfWork_OnTimeAfterALateOne_IsNotCounted()
    {
        using TestRun run = NewLongRun(out ScriptedManager manager);
        manager.UnitOfWorkDeadline = TimeSpan.FromTicks(1);
        manager.OnLate = _ => manager.UnitOfWorkDeadline = TimeSpan.FromHours(1);

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal((3, 1), (manager.Units, run.StatusOf(manager).LateUnitsOfWork));
    }

    [Fact, Trait("Clause", "4.4"), Trait("Clause", "1.7")]
    public void LateCallback_ThatThrows_IsAFaultOfTheUnitOfWork()
    {
        using TestRun run = NewLongRun(out ScriptedManager manager);
        manager.UnitOfWorkDeadline = TimeSpan.FromTicks(1);
        manager.OnLate = _ => throw new InvalidOperationException("too late");

        run.Start();
        ReactorResult result = run.FinishByItself();

        ManagerFault fault = Assert.Single(result.Managers[0].Faults);
        Assert.Equal(ManagerStage.UnitOfWork, fault.Stage);
        Assert.Equal("too late", fault.Exception.Message);
        Assert.Equal(1, result.Managers[0].Status.LateUnitsOfWork);
    }

    [Fact, Trait("Clause", "4.4"), Trait("Clause", "1.7")]
    public void UnitOfWork_PastItsDeadlineThatThrows_IsCountedAndCalledBack()
    {
        using TestRun run = NewLongRun(out ScriptedManager manager);
        var late = new List<TimeSpan>();
        manager.FaultPolicy = FaultPolicy.CarryOn;
        manager.UnitOfWorkDeadline = TimeSpan.FromMilliseconds(1);
        manager.OnLate = late.Add;
        manager.ThrowIn(ManagerStage.UnitOfWork, manager.OnUnit);

        run.StartAndSettle();
        ReactorResult result = run.Finish();

        Assert.Equal(manager.Units, late.Count);
        Assert.All(late, time => Assert.True(time >= Duration));
        Assert.Equal(late.Count, result.Managers[0].Status.LateUnitsOfWork);
        Assert.Equal(late.Count, result.Managers[0].Status.Faults);
    }

    [Fact, Trait("Clause", "4.4"), Trait("Clause", "1.7")]
    public void LateCallback_ThatThrowsAfterAFault_IsLoggedAndTheFaultStays()
    {
        using TestRun run = NewLongRun(out ScriptedManager manager);
        manager.UnitOfWorkDeadline = TimeSpan.FromTicks(1);
        manager.OnLate = _ => throw new InvalidOperationException("too late");
        manager.ThrowIn(ManagerStage.UnitOfWork, manager.OnUnit);

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Equal("boom", Assert.Single(result.Managers[0].Faults).Exception.Message);
        Assert.Equal(1, result.Managers[0].Status.LateUnitsOfWork);
        Assert.Contains(
            run.Log, e => e.Kind == RabitLogKind.Fault && e.Text.Contains("too late", StringComparison.Ordinal));
    }

    [Theory, Trait("Clause", "4.4")]
    [InlineData(0)]
    [InlineData(-1)]
    public void UnitOfWorkDeadline_NotPositive_IsRefusedByName(long ticks)
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("control");

        string text = Assert.Throws<ArgumentOutOfRangeException>(
            () => manager.UnitOfWorkDeadline = TimeSpan.FromTicks(ticks)).Message;
        Assert.Contains("'control'", text, StringComparison.Ordinal);
    }

    // Its units of work take time: in virtual time by their model.
    private TestRun NewLongRun(out ScriptedManager manager)
    {
        TestRun run = NewRun(o => (o.Time as VirtualTime)?.SetUnitOfWorkDuration("control", Duration));
        manager = run.Add("control");
        if (Kind.HasThreads)
            manager.OnUnit = TakeTime;
        return run;
    }

    private static void TakeTime()
    {
        var took = Stopwatch.StartNew();
        while (took.Elapsed <= Duration)
        {
            // It computes.
        }
    }
}

public sealed class DeadlineInRealTime() : DeadlineContract(TimeKind.Real);

public sealed class DeadlineInVirtualTime() : DeadlineContract(TimeKind.Virtual)
{
    [Theory, Trait("Clause", "4.4")]
    [InlineData(0, 0)]
    [InlineData(-1, 1)]
    public void UnitOfWork_EndsOnItsDeadline_IsInTimeAndATickLaterLate(long moreTicks, long late)
    {
        TimeSpan duration = TimeSpan.FromMilliseconds(2);
        using TestRun run = NewRun(o => ((VirtualTime)o.Time).SetUnitOfWorkDuration("control", duration));
        ScriptedManager manager = run.Add("control");
        manager.UnitOfWorkDeadline = duration + TimeSpan.FromTicks(moreTicks);

        run.StartAndSettle();
        run.Finish();

        Assert.Equal(1, manager.Units);
        Assert.Equal(late, run.StatusOf(manager).LateUnitsOfWork);
    }
}
