using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>Contract 5.2: in virtual time a unit of work takes no time or its modelled duration.</summary>
public sealed class ModelledDurationTests
{
    [Fact, Trait("Clause", "5.2")]
    public void ModelledDuration_OfAUnit_KeepsTheManagerBusyAndItsWakes()
    {
        var time = new VirtualTime();
        time.SetUnitOfWorkDuration("worker", TimeSpan.FromMilliseconds(30));
        using TestRun run = NewRun(time);
        ScriptedManager worker = run.Add("worker");
        ScriptedManager waker = run.Add("waker");
        worker.WakeUpDelay = TimeSpan.FromMilliseconds(100);
        waker.WakeUpDelay = TimeSpan.FromMilliseconds(10);
        var begins = new List<double>();
        worker.OnUnit = () => begins.Add(worker.Time.TotalMilliseconds);
        waker.OnUnit = () =>
        {
            if (waker.Time == TimeSpan.FromMilliseconds(10) || waker.Time == TimeSpan.FromMilliseconds(20))
                worker.WakeUp();
        };

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(300));
        run.Finish();

        // Busy to 30, then at once for the two wakes, busy to 60; the timer counts from 60 and from 190.
        Assert.Equal([0.0, 30.0, 160.0, 290.0], begins);
        ManagerStatus status = run.StatusOf(worker);
        Assert.Equal(TimeSpan.FromMilliseconds(30), status.UnitOfWorkTime.Min);
        Assert.Equal(TimeSpan.FromMilliseconds(30), status.UnitOfWorkTime.Max);
        Assert.Equal(1, status.WakeUps.Merged);
    }

    [Fact, Trait("Clause", "5.2"), Trait("Clause", "4.4")]
    public void ModelledDuration_WakeWhileBusy_IsNoWakeFromSleep()
    {
        var time = new VirtualTime();
        time.SetUnitOfWorkDuration("worker", TimeSpan.FromMilliseconds(30));
        using TestRun run = NewRun(time);
        ScriptedManager worker = run.Add("worker");
        ScriptedManager waker = run.Add("waker");
        waker.WakeUpDelay = TimeSpan.FromMilliseconds(10);
        waker.OnUnit = () =>
        {
            if (waker.Units == 2)
                worker.WakeUp();
        };

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(100));

        ManagerStatus status = run.StatusOf(worker);
        Assert.Equal(2, status.Runs);
        Assert.Equal((1, TimeSpan.Zero), (status.WakeLatency.Count, status.WakeLatency.Max));
    }

    [Fact, Trait("Clause", "5.2"), Trait("Clause", "4.4")]
    public void ModelledDuration_StartupAndShutdown_TakeNone()
    {
        var time = new VirtualTime();
        time.SetUnitOfWorkDuration("worker", TimeSpan.FromMilliseconds(30));
        using TestRun run = NewRun(time);
        run.Add("worker");
        MessageSubscriber<ManagerStatus> status = run.Reactor.Workspace.SubscribeToStatus("worker");

        run.Start();
        status.Fetch();
        Assert.Equal(TimeSpan.Zero, status.Stamp.Time);
        run.Reactor.RunFor(TimeSpan.FromSeconds(10));
        run.Finish();
        status.Fetch();

        Assert.Equal(ManagerState.Stopped, status.Value.State);
        Assert.Equal(TimeSpan.FromSeconds(10), status.Stamp.Time);
    }

    [Fact, Trait("Clause", "5.2"), Trait("Clause", "4.2")]
    public void ModelledDuration_OfNoManager_IsReportedTogetherWithTheOtherFaults()
    {
        var time = new VirtualTime();
        time.SetUnitOfWorkDuration("ghost", TimeSpan.FromMilliseconds(1));
        using TestRun run = NewRun(time);
        run.Add("m").Subscribe<int>("height");

        IReadOnlyList<string> faults = Assert.Throws<RabitWiringException>(run.Start).Faults;

        Assert.Equal(2, faults.Count);
        Assert.Contains(faults, f => f.Contains("'ghost'", StringComparison.Ordinal));
        Assert.Contains(faults, f => f.Contains("'height'", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "5.2")]
    public void ModelledDuration_OfARange_IsDrawnFromTheSeedAndStaysInside()
    {
        TimeSpan shortest = TimeSpan.FromMilliseconds(2);
        TimeSpan longest = TimeSpan.FromMilliseconds(5);
        List<TimeSpan> first = Durations(seed: 1, shortest, longest);

        Assert.All(first, d => Assert.InRange(d, shortest, longest));
        Assert.True(first.Max() - first.Min() > TimeSpan.FromTicks(29_000));
        Assert.Equal(first, Durations(seed: 1, shortest, longest));
        Assert.NotEqual(first, Durations(seed: 2, shortest, longest));
    }

    [Fact, Trait("Clause", "5.2")]
    public void ModelledDuration_OfAnother_ChangesNoDrawOfThisOne()
    {
        TimeSpan shortest = TimeSpan.FromMilliseconds(2);
        TimeSpan longest = TimeSpan.FromMilliseconds(5);

        Assert.Equal(Durations(seed: 1, shortest, longest), Durations(seed: 1, shortest, longest, neighbour: longest));
    }

    [Fact, Trait("Clause", "5.2")]
    public void ModelledDuration_ChangedBetweenSteps_HoldsFromTheNextUnit()
    {
        var time = new VirtualTime();
        using TestRun run = NewRun(time);
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(10);
        run.Start();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(15));

        time.SetUnitOfWorkDuration("m", TimeSpan.FromMilliseconds(7));
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(5));

        Assert.Equal(TimeSpan.FromMilliseconds(7), run.StatusOf(manager).UnitOfWorkTime.Max);
        Assert.Equal(TimeSpan.Zero, run.StatusOf(manager).UnitOfWorkTime.Min);
        var error = Assert.Throws<ArgumentException>(() => time.SetUnitOfWorkDuration("ghost", TimeSpan.Zero));
        Assert.Contains("'ghost'", error.Message, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.2")]
    public void ModelledDuration_OfAMistypedNameAfterTheStart_SuggestsTheOneThatWasMeant()
    {
        var time = new VirtualTime();
        using TestRun run = NewRun(time);
        run.Add("navigation");
        run.Start();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(15));

        string text = Assert.Throws<ArgumentException>(
            () => time.AddLongUnitOfWork("navigaton", TimeSpan.Zero, TimeSpan.Zero)).Message;
        Assert.Contains(
            "No manager 'navigaton' has started. Did you mean 'navigation'?", text, StringComparison.Ordinal);
    }

    private static List<TimeSpan> Durations(
        long seed, TimeSpan shortest, TimeSpan longest, TimeSpan neighbour = default)
    {
        var time = new VirtualTime(seed);
        time.SetUnitOfWorkDuration("worker", shortest, longest);
        time.SetUnitOfWorkDuration("neighbour", TimeSpan.Zero, neighbour);
        using TestRun run = NewRun(time);
        ScriptedManager worker = run.Add("worker");
        run.Add("neighbour").WakeUpDelay = TimeSpan.FromMilliseconds(3);
        worker.WakeUpDelay = TimeSpan.FromMilliseconds(1);
        var begins = new List<TimeSpan>();
        worker.OnUnit = () => begins.Add(worker.Time);
        run.Start();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(500));

        // It sleeps for a millisecond after each unit of work.
        return begins.Skip(1).Zip(begins, (next, begin) => next - begin - worker.WakeUpDelay).ToList();
    }

    private static TestRun NewRun(VirtualTime time) => new(TimeKind.Virtual, options => options.Time = time);
}
