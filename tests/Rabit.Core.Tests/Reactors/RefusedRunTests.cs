using System;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>A call that a reactor refuses says why, and leaves the run that is under way alone.</summary>
public sealed class RefusedRunTests
{
    private readonly TestBoard _board = new();

    [Fact]
    public async Task Dispose_AfterARefusedRun_StopsAllManagers()
    {
        foreach (TimeKind kind in new[] { TimeKind.Real, TimeKind.Virtual })
        {
            var manager = new ScriptedManager("m", _board);
            using (RabitReactor reactor = NewReactor(kind.Create(), manager))
            {
                reactor.Start();
                Assert.Throws<InvalidOperationException>(reactor.Run);
                await Assert.ThrowsAsync<InvalidOperationException>(() => reactor.RunAsync());
            }

            Assert.Equal(1, manager.Shutdowns);
        }
    }

    [Fact]
    public void Dispose_AfterARunInAStartup_StopsAllManagers()
    {
        foreach (TimeKind kind in new[] { TimeKind.Real, TimeKind.Virtual })
        {
            var manager = new ScriptedManager("m", _board);
            using (RabitReactor reactor = NewReactor(kind.Create(), manager))
            {
                manager.OnStartup = () => Assert.Throws<InvalidOperationException>(reactor.Run);
                reactor.Start();
            }

            Assert.Equal(1, manager.Shutdowns);
        }
    }

    [Fact]
    public async Task RunAsync_DisposedAtOnce_EndsWithAResult()
    {
        using RabitReactor reactor = NewReactor(new RealTime(), new ScriptedManager("m", _board));
        Task<ReactorResult> run = reactor.RunAsync();
        reactor.Dispose();

        Assert.Equal("disposed", (await run).StopReason);
    }

    [Fact]
    public async Task RunAsync_AgainWithACancelledToken_LeavesTheRunAlone()
    {
        var manager = new ScriptedManager("m", _board);
        using RabitReactor reactor = NewReactor(new RealTime(), manager);
        Task<ReactorResult> run = reactor.RunAsync();
        await Assert.ThrowsAsync<InvalidOperationException>(() => reactor.RunAsync(new CancellationToken(true)));
        using var later = new CancellationTokenSource();
        await Assert.ThrowsAsync<InvalidOperationException>(() => reactor.RunAsync(later.Token));
        later.Cancel();
        reactor.Stop("done");

        Assert.Equal("done", (await run).StopReason);
    }

    [Fact]
    public async Task RunAsync_CancelledBefore_StartsNothing()
    {
        foreach (TimeKind kind in new[] { TimeKind.Real, TimeKind.Virtual })
        {
            var manager = new ScriptedManager("m", _board);
            using RabitReactor reactor = NewReactor(kind.Create(), manager);

            Assert.Equal("cancelled", (await reactor.RunAsync(new CancellationToken(true))).StopReason);
            Assert.Equal(0, manager.Startups);
        }
    }

    [Fact]
    public async Task FinishAndRunFor_BesideRunAsync_SayWhoFinishesTheRun()
    {
        var manager = new ScriptedManager("m", _board);
        using RabitReactor reactor = NewReactor(new RealTime(), manager);
        Task<ReactorResult> run = reactor.RunAsync();
        while (manager.Units == 0)
            await Task.Yield();

        foreach (string text in Refusals(reactor))
            Assert.Equal("Run or RunAsync runs this reactor, and finishes the run itself.", text);
        reactor.Stop("done");
        Assert.Equal("done", (await run).StopReason);
        foreach (string text in Refusals(reactor))
            Assert.Equal("The run has finished.", text);
    }

    [Fact]
    public async Task FinishAndRunFor_WhileAnotherThreadEndsTheRun_SayThatItEnds()
    {
        using var isEnding = new ManualResetEventSlim();
        using var mayEnd = new ManualResetEventSlim();
        var manager = new ScriptedManager("m", _board)
        {
            OnShutdown = () =>
            {
                isEnding.Set();
                mayEnd.Wait();
            },
        };
        using RabitReactor reactor = NewReactor(new RealTime(), manager);
        reactor.Start();
        while (manager.Units == 0)
            await Task.Yield();
        reactor.Stop("done");
        Task<ReactorResult> finish = Task.Run(reactor.Finish);
        isEnding.Wait();
        string[] texts = Refusals(reactor);
        mayEnd.Set();
        await finish;

        foreach (string text in texts)
            Assert.Equal("The run is being ended already.", text);
        foreach (string text in Refusals(reactor))
            Assert.Equal("The run has finished.", text);
    }

    private static string[] Refusals(RabitReactor reactor) =>
    [
        Assert.Throws<InvalidOperationException>(reactor.Finish).Message,
        Assert.Throws<InvalidOperationException>(() => reactor.RunFor(TimeSpan.Zero)).Message,
    ];

    private static RabitReactor NewReactor(RabitTime time, RabitManager manager)
        => new(new ReactorOptions { Time = time, StopsOnSignals = false }) { manager };
}
