using System;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.Extensions.DependencyInjection;
using Rabit.Core;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Hosting.Tests;

/// <summary>Reactors start and stop with the host, and the host stops with them.</summary>
public sealed class LifetimeTests
{
    [Fact]
    public async Task Host_StartAndStop_RunsTheManagersInOrder()
    {
        var journal = new Journal();
        using (var host = new TestHost(s => s.AddSingleton(journal)
            .AddRabit(r => r.AddManager<Source>().AddManager<Sink>())))
        {
            await host.StartAsync();
            Assert.Equal("source-up sink-up ", journal.Text);
            Assert.Equal(["source", "sink"], host.Reactors["rabit"].Select(m => m.Name));
            Assert.Null(host.Reactors.ResultOf("rabit"));

            await host.StopAsync();

            Assert.Equal("source-up sink-up sink-down source-down ", journal.Text);
            ReactorResult result = host.Reactors.ResultOf("rabit")!;
            Assert.Equal((0, "the host stops"), (result.ExitCode, result.StopReason));
            Assert.Equal(0, host.ExitCode);
        }

        Assert.EndsWith("sink-disposed ", journal.Text);
    }

    [Fact]
    public async Task Reactor_EndsByItself_StopsTheHostWithItsExitCode()
    {
        using var host = new TestHost(s => s.AddRabit(r => r.AddManager(_ => new Actor("actor", a => a.End("done")))));
        await host.StartAsync();
        await host.WaitForEndAsync();

        Assert.Equal(0, host.ExitCode);
        Assert.Contains("done", host.Reactors.ResultOf("rabit")!.StopReason);
    }

    [Fact]
    public async Task Manager_Throws_StopsTheHostWithExitCode1()
    {
        using var host = new TestHost(s => s.AddRabit(
            r => r.AddManager(_ => new Actor("actor", _ => throw new InvalidOperationException("it broke")))));
        await host.StartAsync();
        await host.WaitForEndAsync();

        Assert.Equal(1, host.ExitCode);
        Assert.Contains(host.Log.Entries, e => e.Id == RabitEventIds.ReactorEnded && e.Text.Contains("it broke"));
    }

    [Fact]
    public async Task Reactors_Several_RunSideBySideAndAnyEndsTheHost()
    {
        var journal = new Journal();
        using var host = new TestHost(s => s.AddSingleton(journal)
            .AddRabit("left", r => r.AddManager<Source>().AddManager<Sink>())
            .AddRabit("right", r => r.AddManager(_ => new Actor("actor", a => a.End("done"))))
            .AddRabit("left", r => r.AddManager(_ => new Actor("late", _ => { }))));
        await host.StartAsync();
        await host.WaitForEndAsync();

        Assert.Equal(["left", "right"], host.Reactors.Names);
        Assert.Equal(["source", "sink", "late"], host.Reactors["left"].Select(m => m.Name));
        Assert.Equal("the host stops", host.Reactors.ResultOf("left")!.StopReason);
        Assert.Throws<InvalidOperationException>(() => host.Reactors["middle"]);
    }

    [Fact]
    public async Task Stop_ManagerDoesNotReturn_IsNamedWithinTheTimeOfTheHost()
    {
        using var stuck = new Stuck();
        using var host = new TestHost(
            s => s.AddRabit(r => r.AddManager(_ => stuck).AddManager(_ => new Actor("actor", _ => { }))
                .Configure(o => o.StopTimeout = TimeSpan.FromSeconds(0.2))));
        await host.StartAsync();
        Assert.True(stuck.Entered.WaitOne(TestTimeout.Limit));

        await host.StopAsync();

        RecordedEntry late = Assert.Single(host.Log.Entries, e => e.Id == RabitEventIds.NotStopped);
        Assert.Contains("stuck: ", late.Text);
        Assert.Contains("waiting for the test", late.Text);
        Assert.Equal(1, host.ExitCode);
        Assert.Equal(ManagerOutcome.Ended, host.Reactors.ResultOf("rabit")!.Managers[1].Outcome);
        stuck.Release();
    }

    [Fact]
    public async Task Stop_TimeOfTheHostIsOver_NamesWhoHasNotStopped()
    {
        using var stuck = new Stuck();
        using var host = new TestHost(
            s => s.AddRabit(r => r.AddManager(_ => stuck).AddManager(_ => new Actor("actor", _ => { }))));
        await host.StartAsync();
        Assert.True(stuck.Entered.WaitOne(TestTimeout.Limit));

        await host.StopAsync(new CancellationToken(canceled: true));

        RecordedEntry late = Assert.Single(host.Log.Entries, e => e.Id == RabitEventIds.NotStopped);
        Assert.Contains("did not stop in the time of the host: stuck", late.Text);
        Assert.Equal(1, host.ExitCode);
        stuck.Release();
        await host.WaitForReactorAsync();
    }
}
