using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>
/// Contract 4.5 in virtual time: a modelled duration beyond the limit is found at its very time, and the same in every
/// run.
/// </summary>
public sealed class ModelledHangTests
{
    private static readonly TimeSpan At = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(5);

    [Fact, Trait("Clause", "4.5")]
    public void LongUnit_IsFoundAtItsLimitAndIsBackAtItsEnd()
    {
        var seen = new List<(TimeSpan, ManagerState)>();
        using TestRun run = NewRun(TimeSpan.FromSeconds(8), out ScriptedManager hanging, HangPolicy.Report);
        ScriptedManager watcher = run.Add("watcher");
        MessageSubscriber<ManagerStatus> status = watcher.SubscribeToStatus("m", wakeOnPost: true);
        watcher.OnUnit = () =>
        {
            if (status.Fetch())
                seen.Add((watcher.Time, status.Value.State));
        };

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromSeconds(20));
        ReactorResult result = run.Finish();

        Assert.Contains((At + Limit, ManagerState.Hanging), seen);
        Assert.Equal(ManagerState.Running, seen.First(s => s.Item1 > At + Limit).Item2);
        Assert.Equal(TimeSpan.FromSeconds(11), seen.First(s => s.Item1 > At + Limit).Item1);
        ManagerHang hang = Assert.Single(result.Managers[0].Hangs);
        Assert.Equal(
            (ManagerStage.UnitOfWork, At, Limit, "searching"), (hang.Stage, hang.Since, hang.Duration, hang.Doing));
        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);

        // A run each second, 0 to 3 s and 12 to 20 s: its timer starts when it is back.
        Assert.Equal(4 + 9, hanging.Units);
    }

    [Theory, Trait("Clause", "4.5")]
    [InlineData(4)]
    [InlineData(5)]
    public void LongUnit_WithinItsLimit_IsNeverFoundHanging(int seconds)
    {
        using TestRun run = NewRun(TimeSpan.FromSeconds(seconds), out ScriptedManager manager, HangPolicy.Report);
        manager.OnUnit = () =>
        {
            // Asleep for longer than the limit afterwards.
            if (manager.Time >= At)
                manager.WakeUpDelay = TimeSpan.FromSeconds(60);
        };

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromSeconds(40));
        ReactorResult result = run.Finish();

        Assert.Equal(0, result.Managers[0].HangCount);
        Assert.Equal(4, manager.Units);
    }

    [Fact, Trait("Clause", "4.5")]
    public void LongUnit_NeverBack_StopsTheSystemAtItsLimit()
    {
        using TestRun run = NewRun(TimeSpan.MaxValue, out _, HangPolicy.StopSystem);

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Equal(At + Limit, result.Duration);
        Assert.Contains("m hangs in UnitOfWork for 5.000 s: searching", result.StopReason, StringComparison.Ordinal);
        Assert.Equal(1, result.Managers[0].HangCount);
    }

    [Theory, Trait("Clause", "4.5")]
    [InlineData(8)]
    [InlineData(-1)]
    public void LongUnit_RunEndsBeforeIt_IsCutAndDoesNotReturn(int seconds)
    {
        TimeSpan duration = seconds < 0 ? TimeSpan.MaxValue : TimeSpan.FromSeconds(seconds);
        using TestRun run = NewRun(duration, out ScriptedManager hanging, HangPolicy.Report);
        string? doing = null;
        hanging.OnShutdown = () => doing = hanging.Doing;

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromSeconds(9));
        ReactorResult result = run.Finish();

        Assert.Equal((1, 1), (result.Managers[0].HangCount, hanging.Shutdowns));
        Assert.DoesNotContain(run.Log, e => e.Text.Contains("has returned", StringComparison.Ordinal));
        Assert.Null(doing);
        ManagerStatus status = result.Managers[0].Status;
        Assert.Equal((ManagerState.Stopped, TimeSpan.Zero), (status.State, status.HangingSince));
        Assert.Equal((4, TimeSpan.FromSeconds(6)), (status.UnitOfWorkTime.Count, status.UnitOfWorkTime.Max));
    }

    [Theory, Trait("Clause", "4.5"), Trait("Clause", "4.4")]
    [InlineData(10, true)]
    [InlineData(-1, true)]
    [InlineData(10, false)]
    [InlineData(-1, false)]
    public void LongUnit_RunEndsBeforeIt_MissedTheDeadlinesThatHavePassed(int seconds, bool isWatched)
    {
        TimeSpan duration = seconds < 0 ? TimeSpan.MaxValue : TimeSpan.FromSeconds(seconds);
        HangPolicy policy = isWatched ? HangPolicy.Report : HangPolicy.Off;
        using TestRun run = NewRun(duration, out ScriptedManager hanging, policy);
        hanging.Period = TimeSpan.FromMilliseconds(20);

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromSeconds(8));
        ReactorResult result = run.Finish();

        // 3.02 s to 8 s.
        Assert.Equal(250, result.Managers[0].Status.MissedDeadlines);
    }

    [Fact, Trait("Clause", "4.5"), Trait("Clause", "4.4")]
    public void LongUnit_WithAPeriod_CountsMissedDeadlinesWhenItIsBack()
    {
        using TestRun run = NewRun(TimeSpan.FromSeconds(8), out ScriptedManager hanging, HangPolicy.Report);
        hanging.Period = TimeSpan.FromMilliseconds(20);

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromSeconds(10));
        Assert.Equal(0, run.StatusOf(hanging).MissedDeadlines);
        run.Reactor.RunFor(TimeSpan.FromSeconds(2));
        ReactorResult result = run.Finish();

        // 3.02 s to 11 s.
        Assert.Equal(400, result.Managers[0].Status.MissedDeadlines);
        Assert.Equal(TimeSpan.FromSeconds(8), result.Managers[0].Status.UnitOfWorkTime.Max);
    }

    [Fact, Trait("Clause", "4.4")]
    public void ModelledDuration_RunEndsWithinIt_MissedTheDeadlinesThatHavePassed()
    {
        using TestRun run = NewRun(TimeSpan.FromSeconds(4), out ScriptedManager manager, HangPolicy.Report);
        manager.Period = TimeSpan.FromMilliseconds(20);

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromSeconds(5));

        Assert.Equal(100, run.Finish().Managers[0].Status.MissedDeadlines);
    }

    [Fact, Trait("Clause", "4.5"), Trait("Clause", "5.2")]
    public void LongUnit_OneSeed_OneLog()
    {
        Assert.Equal(LogOf(), LogOf());

        static string LogOf()
        {
            using TestRun run = NewRun(TimeSpan.FromSeconds(8), out _, HangPolicy.Report);
            run.Add("other").WakeUpDelay = TimeSpan.FromSeconds(1);
            run.Start();
            run.Reactor.RunFor(TimeSpan.FromSeconds(20));
            run.Finish();
            return string.Join("\n", run.Log);
        }
    }

    [Fact, Trait("Clause", "4.5")]
    public void UsualDuration_BeyondTheLimit_IsFoundEachTime()
    {
        var time = new VirtualTime(seed: 1);
        time.SetUnitOfWorkDuration("m", TimeSpan.FromSeconds(2));
        using var run = new TestRun(TimeKind.Virtual, options => options.Time = time);
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromSeconds(1);
        manager.HangPolicy = HangPolicy.Report.WithLimits(TimeSpan.FromSeconds(1));

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromSeconds(29));
        ReactorResult result = run.Finish();

        Assert.Equal((10, 10), (manager.Units, result.Managers[0].HangCount));
        Assert.Equal(10, result.Managers[0].Hangs.Count);
    }

    [Fact, Trait("Clause", "4.2")]
    public void LongUnit_OfNoSuchManager_IsAWiringFault()
    {
        var time = new VirtualTime();
        time.AddLongUnitOfWork("ghost", TimeSpan.Zero, TimeSpan.Zero);
        using var run = new TestRun(TimeKind.Virtual, options => options.Time = time);
        run.Add("m");

        Assert.Contains(
            "'ghost'", Assert.Single(Assert.Throws<RabitWiringException>(run.Start).Faults), StringComparison.Ordinal);
    }

    private static TestRun NewRun(TimeSpan duration, out ScriptedManager hanging, HangPolicy policy)
    {
        var time = new VirtualTime(seed: 1);
        time.AddLongUnitOfWork("m", At, duration);
        var run = new TestRun(TimeKind.Virtual, options =>
        {
            options.Time = time;
            options.HangPolicy = policy;
        });
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromSeconds(1);
        manager.OnUnit = () => manager.Doing = "searching";
        hanging = manager;
        return run;
    }
}
