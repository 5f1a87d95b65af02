using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using Microsoft.Extensions.DependencyInjection;
using Rabit.Core;
using Xunit;

namespace Rabit.Hosting.Tests;

/// <summary>What is wrong ends the start of the host, all of it named.</summary>
public sealed class StartTests
{
    [Fact]
    public async Task Wiring_Faults_EndTheStartWithAllOfThem()
    {
        using var host = new TestHost(s => s.AddRabit(
            r => r.AddManager(_ => new Orphan("first")).AddManager(_ => new Orphan("second"))));

        RabitWiringException e = await Assert.ThrowsAsync<RabitWiringException>(host.StartAsync);

        Assert.Contains(e.Faults, f => f.Contains("beat of first"));
        Assert.Contains(e.Faults, f => f.Contains("beat of second"));
    }

    [Fact]
    public async Task Wiring_FaultsOfSeveralReactors_AreAllListedAndNothingStarts()
    {
        var journal = new Journal();
        using var host = new TestHost(s => s.AddSingleton(journal)
            .AddRabit("good", r => r.AddManager<Source>())
            .AddRabit("left", r => r.AddManager(_ => new Orphan("first")))
            .AddRabit("right", r => r.AddManager(_ => new Orphan("second"))));

        RabitWiringException e = await Assert.ThrowsAsync<RabitWiringException>(host.StartAsync);

        Assert.Contains(e.Faults, f => f.StartsWith("left: ", StringComparison.Ordinal) && f.Contains("beat of first"));
        Assert.Contains(e.Faults, f => f.StartsWith("right: ", StringComparison.Ordinal) && f.Contains("beat of second"));
        Assert.Equal("", journal.Text);
    }

    [Fact]
    public async Task Managers_ServiceIsMissing_EndTheStartWithAllOfThem()
    {
        using var host = new TestHost(s => s.AddRabit(r => r.AddManager<Source>().AddManager<Sink>()));

        RabitHostingException e = await Assert.ThrowsAsync<RabitHostingException>(host.StartAsync);

        Assert.Collection(
            e.Faults,
            f => Assert.StartsWith("rabit: Source cannot be made: ", f),
            f => Assert.StartsWith("rabit: Sink cannot be made: ", f));
        Assert.Contains("Journal", e.Message);
    }

    [Fact]
    public async Task Startup_Throws_EndsTheStartAndStopsTheOthers()
    {
        var journal = new Journal();
        using var host = new TestHost(s => s.AddSingleton(journal)
            .AddRabit("good", r => r.AddManager<Source>())
            .AddRabit("bad", r => r.AddManager<Unwilling>()));

        RabitHostingException e = await Assert.ThrowsAsync<RabitHostingException>(host.StartAsync);

        Assert.Contains("no camera", e.Message);
        Assert.Equal(1, host.ExitCode);
        Assert.Equal("source-up source-down ", journal.Text);
    }

    [Fact]
    public async Task Settings_Wrong_AreAllNamedByTheirKeys()
    {
        var settings = new Dictionary<string, string?>
        {
            ["Rabit:LogRuns"] = "often",
            ["Rabit:StopTimeout"] = "5",
            ["Rabit:UnitOfWorkLimit"] = "-00:00:01",
            ["Rabit:arm:MaxStopDelay"] = "00:00:20",
            ["Rabit:arm:TotalStopTimeot"] = "00:00:05",
            ["Rabit:leg:TotalStopTimeout"] = "00:00:09.5",
        };
        using var host = new TestHost(
            s => s.AddRabit(_ => { }).AddRabit("arm", _ => { }).AddRabit("leg", _ => { }), settings);

        RabitHostingException e = await Assert.ThrowsAsync<RabitHostingException>(host.StartAsync);

        Assert.Collection(
            e.Faults,
            f => Assert.Equal("Rabit:LogRuns is 'often'; it must be true or false", f),
            f => Assert.Equal("Rabit:StopTimeout is '5'; it must be a time, as 00:00:02.5", f),
            f => Assert.Equal("Rabit:UnitOfWorkLimit is -00:00:01; it must be 0, for none, or above", f),
            f => Assert.StartsWith("Rabit:arm:TotalStopTimeot is not known; there are: LogRuns, ", f),
            f => Assert.StartsWith("Rabit:arm:MaxStopDelay is 00:00:20; the host leaves 00:00:08 ", f),
            f => Assert.StartsWith("Rabit:leg:TotalStopTimeout is 00:00:09.5000000, with MaxStopDelay 00:00:09.5", f));
    }

    [Fact]
    public async Task Settings_OfTheConfiguration_CountMoreThanThoseInCode()
    {
        ReactorOptions? seen = null;
        var settings = new Dictionary<string, string?>
        {
            ["Rabit:StopTimeout"] = "00:00:00.5",
            ["Rabit:UnitOfWorkLimit"] = "0:0:3",
            ["Rabit:StopsOnHang"] = "true",
        };
        using var host = new TestHost(
            s => s.AddRabit(r => r.AddManager(_ => new Actor("actor", _ => { }))
                .Configure(o => (o.StopTimeout, o.MaxStopDelay) = (TimeSpan.FromSeconds(1), TimeSpan.FromSeconds(4)))
                .ConfigureReactor((_, o) => seen = o)),
            settings);
        await host.StartAsync();
        await host.StopAsync();

        Assert.Equal(TimeSpan.FromSeconds(0.5), seen!.StopTimeout);
        Assert.Equal(TimeSpan.FromSeconds(4), seen.MaxStopDelay);
        Assert.Equal(TimeSpan.FromSeconds(4), seen.TotalStopTimeout);   // what is left of the host's ten
        Assert.Equal(TimeSpan.FromSeconds(3), seen.HangPolicy.UnitOfWorkLimit);
        Assert.True(seen.HangPolicy.StopsSystem);
        Assert.False(seen.StopsOnSignals);
    }

    [Theory]
    [InlineData("")]
    [InlineData("a:b")]
    public void AddRabit_BadName_IsRefused(string name)
        => Assert.Throws<ArgumentException>(() => new ServiceCollection().AddRabit(name, _ => { }));

    private sealed class Unwilling() : RabitManager("unwilling")
    {
        protected override void Startup() => throw new InvalidOperationException("no camera");

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
