using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Logging;
using Xunit;

namespace Rabit.Hosting.Tests;

/// <summary>The log of the reactor in the log of the host.</summary>
public sealed class LoggingTests
{
    [Fact]
    public async Task Entries_OfAManager_HaveItsCategoryAnIdAndTheTimeOfTheReactor()
    {
        using var host = new TestHost(s => s.AddSingleton(new Journal())
            .AddRabit(r => r.AddManager<Source>().AddManager<Sink>()
                .AddManager(_ => new Actor("actor", _ => throw new InvalidOperationException("it broke")))));
        await host.StartAsync();
        await host.WaitForEndAsync();

        RecordedEntry[] ours = host.Log.Entries
            .Where(e => e.Category.StartsWith("Rabit.", StringComparison.Ordinal) && e.Id.Id < 10).ToArray();
        RecordedEntry fault = ours.First(e => e.Id == RabitEventIds.Fault);
        Assert.Equal(("Rabit.actor", LogLevel.Error), (fault.Category, fault.Level));
        Assert.Equal("it broke", fault.Exception!.Message);
        RecordedEntry starts = ours.First(e => e.Id == RabitEventIds.Lifecycle);
        Assert.Equal(("Rabit.reactor", "starts source, sink, actor"), (starts.Category, starts.Text));
        Assert.All(ours, e =>
        {
            var scope = Assert.IsAssignableFrom<IEnumerable<KeyValuePair<string, object?>>>(e.Scope);
            Assert.Equal(["Reactor", "ReactorSeconds"], scope.Select(p => p.Key));
            Assert.InRange((double)scope.Last().Value!, 0, 60);
        });
    }

    [Fact]
    public async Task Entries_OfANamedReactor_HaveItsNameInTheCategory()
    {
        using var host = new TestHost(
            s => s.AddRabit("arm", r => r.AddManager(_ => new Actor("actor", a => a.End("done")))),
            new Dictionary<string, string?> { ["Rabit:arm:LogRuns"] = "true" });
        await host.StartAsync();
        await host.WaitForEndAsync();

        Assert.Contains(
            host.Log.Entries,
            e => e.Category == "Rabit.arm.actor" && e.Id == RabitEventIds.Run && e.Level == LogLevel.Trace);
    }

    [Fact]
    public void EventIds_AreStable()
        => Assert.Equal(
            [1, 2, 3, 4, 5, 6, 10, 11, 12],
            new[]
            {
                RabitEventIds.Lifecycle, RabitEventIds.Run, RabitEventIds.Fault, RabitEventIds.Note,
                RabitEventIds.Manager, RabitEventIds.Hang, RabitEventIds.ReactorEnded, RabitEventIds.NotStopped,
                RabitEventIds.CannotNotify,
            }.Select(i => i.Id));
}
