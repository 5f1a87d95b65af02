using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>
/// Contract 4.1 to 4.3 and 5.1: workspaces, the start, the barrier, the stop and the result; the clock.
/// </summary>
public abstract class ReactorContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "4.1")]
    public void Workspaces_ManyInParallel_DoNotSeeEachOther()
    {
        const int Many = 4;
        var threads = new List<Thread>();
        int[] seen = new int[Many];
        for (int i = 0; i < Many; i++)
        {
            int number = i;
            var thread = new Thread(() => seen[number] = RunOne(number));
            threads.Add(thread);
            thread.Start();
        }

        Assert.All(threads, thread => Assert.True(thread.Join(TestTimeout.Limit)));
        Assert.Equal([0, 1, 2, 3], seen);

        int RunOne(int number)
        {
            int got = -1;
            using TestRun run = NewRun();
            ScriptedManager poster = run.Add("poster");
            ScriptedManager fetcher = run.Add("fetcher");
            MessagePublisher<int> publisher = poster.Publish<int>("number");
            MessageSubscriber<int> subscriber = fetcher.Subscribe<int>("number");
            run.StartAndSettle();
            for (int i = 0; i < 100; i++)
            {
                run.On(poster, () =>
                {
                    publisher.Value = number;
                    publisher.Post();
                });
            }

            run.On(fetcher, () => got = subscriber.Fetch() ? subscriber.Value : -1);
            return got;
        }
    }

    [Fact, Trait("Clause", "4.3")]
    public void StopTimeout_AsLongAsCanBe_IsNoFaultOfTheStop()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.StopTimeout = TimeSpan.MaxValue;
        run.StartAndSettle();

        ReactorResult result = run.Finish();

        Assert.Equal((0, ManagerOutcome.Ended), (result.ExitCode, result.Managers[0].Outcome));
    }

    [Fact, Trait("Clause", "4.2")]
    public void Constructor_OfManagerOrReactor_RunsNothing()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.Publish<int>("height");

        Assert.Equal(0, manager.Startups);
        Assert.Empty(run.Log);
        Assert.Equal(string.Empty, run.Reactor.Workspace.DescribeWiring());
        Assert.Throws<InvalidOperationException>(() => manager.Time);
    }

    [Fact, Trait("Clause", "4.2")]
    public void WiringFault_AtStart_StartsNothing()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.Subscribe<int>("height");

        Assert.Throws<RabitWiringException>(run.Start);

        Assert.Equal(0, manager.Startups);
    }

    [Fact, Trait("Clause", "4.2")]
    public void WiringFault_ThenFinish_IsAnErrorAndDoesNotHang()
    {
        using TestRun run = NewRun();
        run.Add("m").Subscribe<int>("height");

        Assert.Throws<RabitWiringException>(run.Start);

        Assert.Throws<InvalidOperationException>(() => run.Reactor.Finish());
        Assert.Throws<InvalidOperationException>(() => run.Reactor.RunFor(TimeSpan.FromSeconds(1)));
    }

    [Fact, Trait("Clause", "4.2")]
    public void Declaration_AfterTheStart_IsAnErrorThatNamesManagerAndEnd()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        run.StartAndSettle();

        foreach (Action declare in new Action[]
        {
            () => manager.Publish<int>("late"), () => manager.Subscribe<int>("late"),
            () => manager.Send<int>("late"), () => manager.Receive<int>("late"),
        })
        {
            string text = Assert.Throws<InvalidOperationException>(declare).Message;
            Assert.Contains("'m'", text, StringComparison.Ordinal);
            Assert.Contains("'late'", text, StringComparison.Ordinal);
        }
    }

    [Fact, Trait("Clause", "4.3")]
    public void Startup_SeveralManagers_InOrderAndAllBeforeTheFirstUnit()
    {
        using TestRun run = NewRun();
        foreach (string name in new[] { "a", "b", "c" })
        {
            ScriptedManager manager = run.Add(name);
            manager.OnStartup = () => run.Board.Write("startup " + name);
            manager.OnUnit = () => run.Board.Write("unit");
        }

        run.StartAndSettle();

        Assert.Equal(["startup a", "startup b", "startup c", "unit", "unit", "unit"], run.Board.Entries);
    }

    /// <summary>
    /// The first is still in its own when the others could begin theirs: that they do not is seen by their order only.
    /// </summary>
    [Fact, Trait("Clause", "1.1"), Trait("Clause", "4.3")]
    public void Startup_ThatTakesTime_HoldsUpTheOtherStartupsAndAllUnits()
    {
        using TestRun run = NewRun();
        foreach (string name in new[] { "a", "b" })
        {
            ScriptedManager manager = run.Add(name);
            manager.OnStartup = () =>
            {
                run.Board.Write("begin " + name);
                Thread.Sleep(100);
                run.Board.Write("end " + name);
            };
            manager.OnUnit = () => run.Board.Write("unit");
        }

        run.StartAndSettle();

        Assert.Equal(["begin a", "end a", "begin b", "end b", "unit", "unit"], run.Board.Entries);
    }

    [Fact, Trait("Clause", "4.3")]
    public void Stop_SeveralManagers_ShutDownInReverseOrder()
    {
        using TestRun run = NewRun();
        foreach (string name in new[] { "a", "b", "c" })
            run.Add(name).OnShutdown = () => run.Board.Write(name);

        run.StartAndSettle();
        ReactorResult result = run.Finish("landed");

        Assert.Equal(["c", "b", "a"], run.Board.Entries);
        Assert.Equal("landed", result.StopReason);
        Assert.Equal(["a", "b", "c"], result.Managers.Select(m => m.Name).ToArray());
        Assert.All(result.Managers, m => Assert.Equal(ManagerOutcome.Ended, m.Outcome));
        Assert.Null(result.Failure);
        Assert.Contains("landed", result.ToString(), StringComparison.Ordinal);
        Assert.Contains("a: Ended, 1 runs", result.ToString(), StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.3")]
    public void Stop_DuringStartup_EndsThoseThatBeganAndStartsNoOther()
    {
        using TestRun run = NewRun();
        ScriptedManager first = run.Add("first");
        ScriptedManager second = run.Add("second");
        first.OnStartup = () => first.StopAll("no fuel");

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Equal((1, 0, 1), (first.Startups, first.Units, first.Shutdowns));
        Assert.Equal((0, 0, 0), (second.Startups, second.Units, second.Shutdowns));
        Assert.Equal(
            [ManagerOutcome.Ended, ManagerOutcome.NotStarted], result.Managers.Select(m => m.Outcome).ToArray());
        Assert.Equal(0, result.ExitCode);
    }

    [Fact, Trait("Clause", "4.3")]
    public void Stop_BeforeTheStart_RunsNothing()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        run.Reactor.Stop("never mind");

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Equal(0, manager.Startups);
        Assert.Equal("never mind", result.StopReason);
    }

    [Fact, Trait("Clause", "4.3")]
    public async Task RunAsync_UntilAManagerStops_GivesTheResult()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(1);
        manager.OnUnit = () =>
        {
            if (manager.Units == 5)
                manager.StopAll("done");
        };

        ReactorResult result = await run.Reactor.RunAsync();

        Assert.Equal("m: done", result.StopReason);

        // With threads its timer may come once more before the stop does.
        Assert.InRange(result.Managers[0].Runs, 5, Kind.HasThreads ? long.MaxValue : 5);
    }

    [Fact, Trait("Clause", "4.3")]
    public async Task RunAsync_Cancelled_EndsWithTheResult()
    {
        using var stop = new CancellationTokenSource();
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.OnUnit = stop.Cancel;

        ReactorResult result = await run.Reactor.RunAsync(stop.Token);

        Assert.Equal("cancelled", result.StopReason);
        Assert.Equal(1, manager.Shutdowns);
    }

    [Fact, Trait("Clause", "4.3")]
    public async Task RunAsync_WiringFault_ComesToWhoeverAwaits()
    {
        using TestRun run = NewRun();
        run.Add("m").Subscribe<int>("height");

        await Assert.ThrowsAsync<RabitWiringException>(() => run.Reactor.RunAsync());
    }

    [Fact, Trait("Clause", "4.3")]
    public void Reactor_UsedOutOfOrder_IsAnError()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        Assert.Throws<InvalidOperationException>(() => run.Reactor.Add(manager));
        Assert.Throws<InvalidOperationException>(() => run.Reactor.Finish());
        Assert.Throws<InvalidOperationException>(() => run.Reactor.RunFor(TimeSpan.Zero));

        run.StartAndSettle();
        Assert.Throws<InvalidOperationException>(run.Reactor.Start);
        Assert.Throws<InvalidOperationException>(() => run.Reactor.Add(new ScriptedManager("late", run.Board)));

        run.Finish();
        Assert.Throws<InvalidOperationException>(() => run.Reactor.Finish());
        Assert.Throws<InvalidOperationException>(() => run.Reactor.RunFor(TimeSpan.Zero));
    }

    [Fact, Trait("Clause", "4.3")]
    public void Manager_InTwoReactors_IsAnErrorByName()
    {
        using TestRun first = NewRun();
        using TestRun second = NewRun();
        ScriptedManager shared = first.Add("shared");
        second.Reactor.Add(shared);

        first.StartAndSettle();
        var error = Assert.Throws<InvalidOperationException>(second.Start);

        Assert.Contains("'shared'", error.Message, StringComparison.Ordinal);
        first.OnAndSettle(shared, () => { });
        Assert.Equal(0, first.Finish().ExitCode);
    }

    [Fact, Trait("Clause", "4.3")]
    public void Options_ChangedAfterTheReactorIsMade_HaveNoEffect()
    {
        ReactorOptions? kept = null;
        using TestRun run = NewRun(options => kept = options);
        run.Add("m");
        kept!.Time = null!;
        kept.StopTimeout = TimeSpan.FromDays(-1);
        kept.Log = null;

        run.StartAndSettle();

        Assert.Equal(0, run.Finish().ExitCode);
        Assert.NotEmpty(run.Log);
    }

    [Fact, Trait("Clause", "4.3")]
    public void Options_OutOfRange_AreAllNamedTogether()
    {
        var options = new ReactorOptions { Time = null!, StopTimeout = TimeSpan.Zero, Name = "two\nlines" };

        string text = Assert.Throws<ArgumentException>(() => new RabitReactor(options)).Message;

        Assert.Contains("Name has a line break", text, StringComparison.Ordinal);
        Assert.Contains(nameof(ReactorOptions.Time), text, StringComparison.Ordinal);
        Assert.Contains(nameof(ReactorOptions.StopTimeout), text, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.3")]
    public void RunFor_BadOrEndlessDuration_IsRefusedOrLastsUntilTheStop()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(1);
        manager.OnUnit = () =>
        {
            if (manager.Units == 20)
                manager.StopAll("done");
        };

        run.Start();
        Assert.Throws<ArgumentOutOfRangeException>(() => run.Reactor.RunFor(TimeSpan.FromTicks(-1)));
        Assert.False(run.Reactor.RunFor(TimeSpan.MaxValue));
        Assert.Equal("m: done", run.FinishByItself().StopReason);
    }

    [Fact, Trait("Clause", "4.3")]
    public void Log_OfARun_HasStartStopAndHowEachEnded()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.OnStartup = () => manager.Say("hello");

        run.StartAndSettle();
        run.Finish("enough");

        Assert.Equal(
            ["Lifecycle reactor: starts m", "Manager m: hello", "Lifecycle reactor: stops: enough",
                "Lifecycle m: m: Ended, 1 runs"],
            run.Log.Select(e => $"{e.Kind} {e.Source}: {e.Text}").ToArray());
    }

    [Fact, Trait("Clause", "5.1")]
    public void Clock_OfEverything_IsTheOneGivenToTheReactor()
    {
        RabitTime time = CreateTime();
        using TestRun run = NewRun(options => options.Time = time);
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, TimeSpan.Zero) { AtTheEnd = ReaderStep.WaitForSignal };
        manager.AttachReader("line", source);

        run.StartAndSettle();
        run.Until(() => run.Board.Count("open") == 1, "the reader opens its source");
        run.On(manager, () =>
        {
            Assert.Same(time.Clock, manager.RunClock);
            Assert.InRange(manager.Time, TimeSpan.Zero, run.Reactor.Now);
        });

        Assert.Same(time.Clock, source.Context.Clock);
        Assert.InRange(source.Context.Now, TimeSpan.Zero, run.Reactor.Now);
    }

    [Fact, Trait("Clause", "5.1")]
    public void RunFor_ADuration_PassesThatMuchTimeOfTheClock()
    {
        using TestRun run = NewRun();
        run.Add("m");

        run.StartAndSettle();
        TimeSpan begin = run.Reactor.Now;
        Assert.True(run.Reactor.RunFor(TimeSpan.FromMilliseconds(30)));

        Assert.True(run.Reactor.Now - begin >= TimeSpan.FromMilliseconds(30));
    }
}

public sealed class ReactorInRealTime() : ReactorContract(TimeKind.Real);

public sealed class ReactorInVirtualTime() : ReactorContract(TimeKind.Virtual);
