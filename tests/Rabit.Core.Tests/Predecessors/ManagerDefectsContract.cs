using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Predecessors;

/// <summary>
/// What managers of the C++ and C# predecessors got wrong; the numbers are those of docs/concepts/predecessors.md.
/// </summary>
public abstract class ManagerDefectsContract(TimeKind kind) : ContractTests(kind)
{
    // There: flags that threads share without any guard.
    [Fact, Trait("Defect", "1")]
    public void Stop_AskedForOnAnyThread_IsSeenByASleeper()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromDays(1);

        run.StartAndSettle();
        OnAThread(() => run.Reactor.Stop("from a thread of its own"));
        ReactorResult result = run.FinishByItself();

        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
        Assert.Equal(1, manager.Shutdowns);
    }

    // There: the flag "woken" was cleared after the unit of work had begun, and took a wake with it that came in
    // between.
    [Fact, Trait("Defect", "2")]
    public void Wake_AtTheEndOfAUnit_BringsOneMore()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        ScriptedManager poster = run.Add("poster");
        MessagePublisher<int> publisher = poster.Publish<int>("number");
        MessageSubscriber<int> subscriber = manager.Subscribe<int>("number", wakeOnPost: true);
        int seen = 0;
        manager.OnUnit = () =>
        {
            subscriber.Fetch();
            seen = subscriber.Value;
            run.Board.Changed();
        };

        run.StartAndSettle();
        for (int i = 1; i <= 200; i++)
        {
            int number = i;
            run.On(poster, () =>
            {
                publisher.Value = number;
                publisher.Post();
            });
            run.Until(() => seen == number, $"post {number} is seen without a timer");
        }
    }

    // There: a wait without a condition took a spurious wake for a wake-up, and counted it.
    [Fact, Trait("Defect", "3")]
    public void Run_NoWakeUp_DoesNotHappen()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request], manager.Causes);
        Assert.Equal(2, run.StatusOf(manager).Runs);
    }

    // There: posters counted in the statistics of the manager that they woke, while it cleared and posted them.
    [Fact, Trait("Defect", "4")]
    public void Statistics_WakesOfManyManagers_AreAllCounted()
    {
        using TestRun run = NewRun();
        ScriptedManager woken = run.Add("woken");
        ScriptedManager[] wakers = [run.Add("a"), run.Add("b"), run.Add("c")];

        run.StartAndSettle();
        foreach (ScriptedManager waker in wakers)
        {
            run.OnAndSettle(waker, () =>
            {
                for (int i = 0; i < 100; i++)
                    woken.WakeUp();
            });
        }

        run.Until(
            () => run.StatusOf(woken).WakeUps is var counts && counts.Request + counts.Merged == 300,
            "all wakes are counted");
        run.OnAndSettle(woken, () => { });
        WakeUpStatistics after = run.StatusOf(woken).WakeUps;
        run.Finish();

        // The last one is the test's own.
        Assert.Equal(301, after.Request + after.Merged);
    }

    // There: outside every try block, so that an exception ended the process.
    [Theory, Trait("Defect", "5")]
    [InlineData(ManagerStage.Startup)]
    [InlineData(ManagerStage.Shutdown)]
    public void Fault_InStartupOrShutdown_EndsOnlyTheRun(ManagerStage stage)
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        Action fail = () => throw new FormatException("a kind of its own");
        if (stage == ManagerStage.Startup)
            manager.OnStartup = fail;
        else
            manager.OnShutdown = fail;

        run.Start();
        ReactorResult result = run.Finish();

        Assert.Equal(stage, Assert.Single(result.Managers[0].Faults).Stage);
    }

    // There: an exception jumped over the sleep, and the manager ran again at once, for ever.
    [Fact, Trait("Defect", "6")]
    public void Fault_InEveryUnit_DoesNotTakeTheWholeProcessor()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromMilliseconds(10), TimeSpan.FromMilliseconds(80));
        manager.WakeUpDelay = TimeSpan.FromTicks(1);
        var at = new List<TimeSpan>();
        manager.OnUnit = () =>
        {
            at.Add(manager.Time);
            throw new InvalidOperationException("always");
        };

        run.Start();
        run.Until(() => manager.Units >= 6, "it has failed six times");
        run.Finish();

        double[] gaps = at.Skip(1).Zip(at, (later, earlier) => (later - earlier).TotalMilliseconds).Take(5).ToArray();
        Assert.All(
            gaps.Zip([10, 20, 40, 80, 80], (gap, least) => (gap, least)),
            g => Assert.True(g.gap >= g.least, $"{g.gap} < {g.least}"));
    }

    // There: a message "stop all" arrived over the manager's own request to stop, and took it back.
    [Fact, Trait("Defect", "7")]
    public void Stop_OfAManagerAndOfOthersTogether_IsNotTakenBack()
    {
        using TestRun run = NewRun();
        ScriptedManager one = run.Add("one");
        ScriptedManager two = run.Add("two");
        one.OnUnit = () => one.StopAll("one has had enough");
        two.OnUnit = () => two.StopAll("two has had enough");

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Contains("has had enough", result.StopReason, StringComparison.Ordinal);
        Assert.All(result.Managers, m => Assert.Equal(ManagerOutcome.Ended, m.Outcome));
    }

    // There: a stop did not wake the manager, and the program ended up to ten seconds later.
    [Fact, Trait("Defect", "8")]
    public void Stop_LongTimer_DoesNotWaitForIt()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromHours(10);

        run.StartAndSettle();
        TimeSpan before = run.Reactor.Now;
        run.Finish();

        // As long as it took there, on an idle machine; in virtual time it takes none.
        TimeSpan limit = Kind == TimeKind.Virtual
            ? TimeSpan.FromSeconds(10)
            : TimeSpan.FromTicks(TestTimeout.Limit.Ticks / 2);
        Assert.InRange(run.Reactor.Now - before, TimeSpan.Zero, limit);
    }

    // There: half a second became whole seconds, that is none, and the manager ran without ever sleeping.
    [Theory, Trait("Defect", "9")]
    [InlineData(0.5)]
    [InlineData(40.25)]
    public void WakeUpDelay_FractionOfAUnit_IsKept(double milliseconds)
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var delay = TimeSpan.FromTicks((long)(milliseconds * TimeSpan.TicksPerMillisecond));
        manager.WakeUpDelay = delay;
        var at = new List<TimeSpan>();
        manager.OnUnit = () => at.Add(manager.Time);

        run.Start();
        run.Until(() => manager.Units >= 4, "four units have run");
        run.Finish();

        Assert.Equal(delay, manager.WakeUpDelay);
        Assert.All(at.Skip(1).Zip(at, (later, earlier) => later - earlier), gap => Assert.True(gap >= delay, $"{gap}"));
    }

    // There: zero in one of two places switched the statistics off altogether.
    [Fact, Trait("Defect", "10")]
    public void Statistics_AfterAReset_GoOn()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        manager.ResetStatistics();
        run.On(manager, () => { });
        run.Until(() => run.StatusOf(manager) is { Runs: 1, WakeUps.Request: 1 }, "the figures begin again");
    }

    // There: getters gave the manager's own message object to every caller, on any thread.
    [Fact, Trait("Defect", "11")]
    public void Status_ReadByAnother_IsACopyOfItsOwn()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        ManagerStatus before = run.StatusOf(manager);
        run.On(manager, () => { });
        run.On(manager, () => { });

        Assert.Equal(1, before.Runs);
    }

    // There: a raw pointer to a manager stayed in the list of those to wake when the manager was gone.
    [Fact, Trait("Defect", "12")]
    public void Wake_OfAManagerThatHasEnded_DoesNothing()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.Finish();
        manager.WakeUp();
        OnAThread(manager.WakeUp);

        Assert.Equal(1, manager.Units);
        Assert.Equal(1, manager.Shutdowns);
    }

    // There: the constructor posted the status of an object whose derived part did not exist yet.
    [Fact, Trait("Defect", "13")]
    public void Constructor_Done_HasPostedNothing()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        bool wasPosted = true;
        manager.OnStartup = () => wasPosted = run.Log.Any(e => e.Source == "m");

        run.StartAndSettle();

        Assert.False(wasPosted);
    }

    // There: a manager posted before others had come to the end of their start-up, and the post was missed.
    [Fact, Trait("Defect", "32")]
    public void Startup_OfTheLast_ComesBeforeTheFirstUnitOfAll()
    {
        using TestRun run = NewRun();
        ScriptedManager[] managers = [run.Add("a"), run.Add("b"), run.Add("c")];
        int before = 0;
        foreach (ScriptedManager manager in managers)
            manager.OnUnit = () => before += managers.Count(m => m.Startups == 0);

        run.StartAndSettle();
        ReactorResult result = run.Finish();

        Assert.Equal(0, before);
        Assert.Equal(3, result.Managers.Count(m => m.Outcome == ManagerOutcome.Ended));
    }

    private static void OnAThread(Action action)
    {
        var thread = new System.Threading.Thread(() => action());
        thread.Start();
        thread.Join();
    }
}

public sealed class ManagerDefectsInRealTime() : ManagerDefectsContract(TimeKind.Real);

public sealed class ManagerDefectsInVirtualTime() : ManagerDefectsContract(TimeKind.Virtual);
