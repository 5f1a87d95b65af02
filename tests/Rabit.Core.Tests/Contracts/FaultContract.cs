using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.6 and 1.7: what an exception does.</summary>
public abstract class FaultContract(TimeKind kind) : ContractTests(kind)
{
    [Theory, Trait("Clause", "1.7")]
    [InlineData(ManagerStage.Startup)]
    [InlineData(ManagerStage.UnitOfWork)]
    [InlineData(ManagerStage.Shutdown)]
    public void Fault_AnyStage_IsInLogStatusAndResult(ManagerStage stage)
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        Throw(manager, stage, "boom");

        run.Start();
        ReactorResult result = stage == ManagerStage.Shutdown ? run.Finish() : run.FinishByItself();

        ManagerResult ended = result.Managers[0];
        Assert.Equal(1, result.ExitCode);
        Assert.Equal(ManagerOutcome.Faulted, ended.Outcome);
        Assert.Equal(1, ended.FaultCount);
        ManagerFault fault = Assert.Single(ended.Faults);
        Assert.Equal(("m", stage, "boom"), (fault.Manager, fault.Stage, fault.Exception.Message));
        RabitLogEntry entry = Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault);
        Assert.Equal("m", entry.Source);
        Assert.Same(fault.Exception, entry.Exception);
        ManagerStatus status = run.StatusOf(manager);
        Assert.Equal(1, status.Faults);
        Assert.Contains("boom", status.LastFault, StringComparison.Ordinal);
        Assert.Contains("boom", ended.ToString(), StringComparison.Ordinal);
    }

    /// <summary>Logs and results are read line by line.</summary>
    [Fact, Trait("Clause", "1.7")]
    public void Fault_TextsOfSeveralLines_AreOneInLogAndResult()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.OnUnit = () =>
        {
            manager.StopAll("to\nstop");
            throw new InvalidOperationException("two\r\nlines");
        };

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Contains(run.Log, e => e.Text.Contains("two lines", StringComparison.Ordinal));
        Assert.All(run.Log, e => Assert.DoesNotContain("\n", e.ToString(), StringComparison.Ordinal));
        Assert.DoesNotContain("\n", result.Managers[0].ToString(), StringComparison.Ordinal);
        Assert.Equal(2, result.ToString().Split('\n').Length);
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "1.6")]
    [InlineData(ManagerStage.Startup)]
    [InlineData(ManagerStage.UnitOfWork)]
    public void Fault_Default_StopsTheSystemAndEveryStartedManagerShutsDown(ManagerStage stage)
    {
        using TestRun run = NewRun();
        ScriptedManager bystander = run.Add("bystander");
        ScriptedManager faulty = run.Add("faulty");
        ScriptedManager last = run.Add("last");
        Throw(faulty, stage, "boom");

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Contains("faulty in " + stage, result.StopReason, StringComparison.Ordinal);
        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
        Assert.Equal(ManagerOutcome.Faulted, result.Managers[1].Outcome);
        Assert.Equal((1, 1), (bystander.Startups, bystander.Shutdowns));
        Assert.Equal((1, 1), (faulty.Startups, faulty.Shutdowns));
        Assert.Equal(last.Startups, last.Shutdowns);
        if (stage == ManagerStage.Startup)
            Assert.Equal(ManagerOutcome.NotStarted, result.Managers[2].Outcome);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Fault_Default_RunsNoFurtherUnitOfThatManager()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        faulty.WakeUpDelay = TimeSpan.FromMilliseconds(1);
        Throw(faulty, ManagerStage.UnitOfWork, "boom");

        run.Start();
        run.FinishByItself();

        Assert.Equal(1, faulty.Units);
    }

    [Fact, Trait("Clause", "1.7")]
    public void CarryOn_EveryUnitThrows_BacksOffByDoublingUpToTheMaxDelay()
    {
        var begins = new List<TimeSpan>();
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        faulty.FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromMilliseconds(4), TimeSpan.FromMilliseconds(16));
        faulty.WakeUpDelay = TimeSpan.FromMilliseconds(1);
        faulty.OnUnit = () =>
        {
            begins.Add(faulty.Time);
            throw new InvalidOperationException("again");
        };

        run.Start();
        run.Until(() => faulty.Units >= 6, "it carries on");
        ReactorResult result = run.Finish();

        double[] expected = [4, 8, 16, 16, 16];
        for (int i = 0; i < expected.Length; i++)
        {
            double gap = (begins[i + 1] - begins[i]).TotalMilliseconds;
            Assert.True(gap >= expected[i], $"fault {i}: {gap} ms");
            if (!Kind.HasThreads)
                Assert.Equal(expected[i], gap);
        }

        Assert.Equal(1, result.ExitCode);
        Assert.Equal(ManagerOutcome.Faulted, result.Managers[0].Outcome);
        Assert.Equal(result.Managers[0].Runs, result.Managers[0].FaultCount);
    }

    [Fact, Trait("Clause", "1.7")]
    public void CarryOn_AfterASuccessfulUnit_RestartsTheBackOff()
    {
        var begins = new List<TimeSpan>();
        using TestRun run = NewRun(options => options.Time = CreateTime());
        ScriptedManager faulty = run.Add("faulty");
        faulty.FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromMilliseconds(2), TimeSpan.FromSeconds(1000));
        faulty.WakeUpDelay = TimeSpan.FromMilliseconds(1);

        // Eight faults in a row would end in a back-off of 256 ms; with a successful unit between them it stays at 2
        // ms.
        faulty.OnUnit = () =>
        {
            begins.Add(faulty.Time);
            if (faulty.Units % 2 == 0)
                throw new InvalidOperationException("every second time");
        };

        run.Start();
        run.Until(() => faulty.Units >= 40, "it carries on");
        run.Finish();

        if (!Kind.HasThreads)
            Assert.Equal(TimeSpan.FromMilliseconds(19 * 3 + 1), begins[39] - begins[0]);
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.4")]
    public void CarryOn_WakesDuringTheBackOff_AreKeptAndRunNoEarlier()
    {
        TimeSpan firstAt = default;
        TimeSpan secondAt = default;
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        ScriptedManager waker = run.Add("waker");
        faulty.FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(50));
        faulty.OnUnit = () =>
        {
            if (faulty.Units == 1)
            {
                firstAt = faulty.Time;
                throw new InvalidOperationException("once");
            }

            secondAt = secondAt == default ? faulty.Time : secondAt;
        };

        run.StartAndSettle();
        run.On(waker, faulty.WakeUp);
        run.Until(() => run.StatusOf(faulty).Runs == 2, "it carries on");
        run.Finish();

        Assert.True(secondAt - firstAt >= TimeSpan.FromMilliseconds(50), $"{secondAt - firstAt}");
        Assert.Equal(WakeUpCauses.Timer | WakeUpCauses.Request, faulty.Causes[1]);
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.6")]
    public void CarryOn_StopDuringTheBackOff_EndsAtOnce()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        faulty.FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromDays(1), TimeSpan.FromDays(1));
        Throw(faulty, ManagerStage.UnitOfWork, "boom");

        run.Start();
        run.Until(() => run.StatusOf(faulty).Faults == 1, "it throws");
        ReactorResult result = run.Finish();

        Assert.Equal(1, faulty.Shutdowns);
        Assert.Equal(ManagerOutcome.Faulted, result.Managers[0].Outcome);
    }

    [Fact, Trait("Clause", "1.7")]
    public void CarryOn_StartupThrows_TheUnitsRunAllTheSame()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        faulty.FaultPolicy = FaultPolicy.CarryOn;
        Throw(faulty, ManagerStage.Startup, "boom");

        run.StartAndSettle();
        run.OnAndSettle(faulty, () => { });
        Assert.Equal(ManagerState.Running, run.StatusOf(faulty).State);
        ReactorResult result = run.Finish();

        Assert.Equal(ManagerStage.Startup, Assert.Single(result.Managers[0].Faults).Stage);
    }

    [Fact, Trait("Clause", "1.7")]
    public void CarryOn_ManyFaults_KeepsTheFirstTenAndCountsAll()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        faulty.FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromTicks(1), TimeSpan.FromTicks(1));
        faulty.OnUnit = () => throw new InvalidOperationException("number " + faulty.Units);

        run.Start();
        run.Until(() => faulty.Units >= 25, "it carries on");
        ManagerResult result = run.Finish().Managers[0];

        Assert.Equal(10, result.Faults.Count);
        Assert.All(
            result.Faults.Select((f, i) => (f.Exception.Message, i)),
            f => Assert.Equal("number " + (f.i + 1), f.Message));
        Assert.True(result.FaultCount >= 25);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Log_ThatThrows_HarmsNoManager()
    {
        using TestRun run = NewRun(
            options => options.Log = _ => throw new InvalidOperationException("the disk is full"));
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.OnAndSettle(manager, () => manager.Say("hello"));

        Assert.Equal(0, run.Finish().ExitCode);
    }

    [Fact, Trait("Clause", "1.7")]
    public void FaultPolicy_BadDelays_AreRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(
            () => FaultPolicy.CarryOnAfter(TimeSpan.Zero, TimeSpan.FromSeconds(1)));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => FaultPolicy.CarryOnAfter(TimeSpan.FromSeconds(2), TimeSpan.FromSeconds(1)));
    }

    private static void Throw(ScriptedManager manager, ManagerStage stage, string text)
    {
        void Fail() => throw new InvalidOperationException(text);
        if (stage == ManagerStage.Startup)
            manager.OnStartup = Fail;
        else if (stage == ManagerStage.UnitOfWork)
            manager.OnUnit = Fail;
        else
            manager.OnShutdown = Fail;
    }
}

public sealed class FaultInRealTime() : FaultContract(TimeKind.Real);

public sealed class FaultInVirtualTime() : FaultContract(TimeKind.Virtual);
