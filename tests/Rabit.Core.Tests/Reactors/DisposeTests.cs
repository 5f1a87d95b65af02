using System;
using System.Threading.Tasks;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>A reactor that is disposed, or finished where it cannot be.</summary>
public sealed class DisposeTests
{
    private readonly TestBoard _board = new();

    [Fact, Trait("Clause", "4.3")]
    public void Dispose_StartedAndNotFinished_StopsAllManagers()
    {
        foreach (TimeKind kind in new[] { TimeKind.Real, TimeKind.Virtual })
        {
            var manager = new ScriptedManager("m", _board);
            using (RabitReactor reactor = NewReactor(kind.Create(), manager))
                reactor.Start();

            Assert.Equal(1, manager.Startups);
            Assert.Equal(1, manager.Shutdowns);
        }
    }

    [Fact, Trait("Clause", "4.3")]
    public void Dispose_AgainOrAfterTheRun_HasNoEffect()
    {
        var manager = new ScriptedManager("m", _board);
        RabitReactor reactor = NewReactor(new VirtualTime(), manager);
        reactor.Start();
        reactor.Stop("done");
        Assert.Equal("done", reactor.Finish().StopReason);
        reactor.Dispose();
        reactor.Dispose();

        Assert.Equal(1, manager.Shutdowns);
    }

    [Fact, Trait("Clause", "4.3")]
    public void Dispose_BeforeTheStart_LetsItStartNoMore()
    {
        RabitReactor reactor = NewReactor(new RealTime(), new ScriptedManager("m", _board));
        reactor.Dispose();

        Assert.Throws<ObjectDisposedException>(reactor.Start);
    }

    [Fact, Trait("Clause", "4.3")]
    public async Task Dispose_WhileAnotherThreadRunsIt_AsksForTheStop()
    {
        var manager = new ScriptedManager("m", _board);
        using RabitReactor reactor = NewReactor(new RealTime(), manager);
        Task<ReactorResult> run = reactor.RunAsync();
        while (manager.Units == 0)
            await Task.Yield();
        reactor.Dispose();

        Assert.Equal("disposed", (await run).StopReason);
    }

    [Fact, Trait("Clause", "4.3")]
    public void FinishRunForAndRun_InAUnitOfWork_AreErrorsThatSaySo()
    {
        foreach (TimeKind kind in new[] { TimeKind.Real, TimeKind.Virtual })
        {
            using var run = new TestRun(kind);
            ScriptedManager manager = run.Add("pilot");
            run.StartAndSettle();
            run.On(manager, () =>
            {
                string text = Assert.Throws<InvalidOperationException>(run.Reactor.Finish).Message;
                Assert.Contains("'pilot'", text, StringComparison.Ordinal);
                Assert.Contains("StopSystem", text, StringComparison.Ordinal);
                Assert.Throws<InvalidOperationException>(() => run.Reactor.RunFor(TimeSpan.Zero));
            });

            Assert.Equal(0, run.Finish().ExitCode);
        }
    }

    [Fact, Trait("Clause", "4.3")]
    public void Dispose_InAUnitOfWork_StopsTheRun()
    {
        foreach (TimeKind kind in new[] { TimeKind.Real, TimeKind.Virtual })
        {
            using var run = new TestRun(kind);
            ScriptedManager manager = run.Add("pilot");
            manager.OnUnit = run.Reactor.Dispose;
            run.Start();

            Assert.Equal("disposed", run.FinishByItself().StopReason);
        }
    }

    [Fact, Trait("Clause", "5.2")]
    public void Run_OfAnotherReactorInAUnitOfWork_IsAllowed()
    {
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager outer = run.Add("planner");
        run.StartAndSettle();
        run.On(outer, () =>
        {
            var inner = new ScriptedManager("inner", new TestBoard());
            using RabitReactor simulated = NewReactor(new VirtualTime(), inner);
            simulated.Start();
            simulated.RunFor(TimeSpan.FromHours(1));
            simulated.Stop();
            simulated.Finish();
            Assert.Equal(2, inner.Units);
        });
    }

    private static RabitReactor NewReactor(RabitTime time, RabitManager manager)
        => new(new ReactorOptions { Time = time, StopsOnSignals = false }) { manager };
}
