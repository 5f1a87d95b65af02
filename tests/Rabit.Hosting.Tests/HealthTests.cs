using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Diagnostics.HealthChecks;
using Rabit.Core;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Hosting.Tests;

/// <summary>Health checks from the status of the managers.</summary>
public sealed class HealthTests
{
    [Fact]
    public async Task Check_AllManagersRun_IsHealthyWithTheirData()
    {
        using TestHost host = Make(r => r.AddManager<Source>().AddManager<Sink>());
        HealthReportEntry before = await CheckAsync(host);
        Assert.Equal((HealthStatus.Unhealthy, "rabit has not started"), (before.Status, before.Description));
        await host.StartAsync();

        HealthReportEntry running = await WaitForAsync(
            host, HealthStatus.Healthy, e => (long)e.Data["source.runs"] > 0);
        Assert.Equal("2 managers run", running.Description);
        Assert.Equal("Running", running.Data["source.state"]);
        Assert.InRange((long)running.Data["source.runs"], 1, 100_000);
        Assert.Equal(
            ["faults", "hangs", "missedDeadlines", "restarts", "runs", "state"],
            running.Data.Keys.Where(k => k.StartsWith("sink.", StringComparison.Ordinal)).Select(k => k.Substring(5))
                .OrderBy(k => k, StringComparer.Ordinal));

        await host.StopAsync();
        HealthReportEntry after = await CheckAsync(host);
        Assert.Equal((HealthStatus.Unhealthy, "rabit has ended: the host stops"), (after.Status, after.Description));
    }

    [Fact]
    public async Task Check_ManagerHangs_IsUnhealthyUntilItReturns()
    {
        using var stuck = new Stuck();
        using TestHost host = Make(
            r => r.AddManager(_ => stuck).Configure(o => o.UnitOfWorkLimit = TimeSpan.FromSeconds(0.2)));
        await host.StartAsync();

        HealthReportEntry hanging = await WaitForAsync(host, HealthStatus.Unhealthy);
        Assert.StartsWith("stuck hangs: ", hanging.Description);
        Assert.Equal(1L, hanging.Data["stuck.hangs"]);

        stuck.Release();
        await WaitForAsync(host, HealthStatus.Healthy);
        await host.StopAsync();
    }

    [Theory]
    [InlineData(true, HealthStatus.Degraded, "actor is restarted: ")]
    [InlineData(false, HealthStatus.Unhealthy, "actor is faulted: ")]
    public async Task Check_ManagerThrew_IsAsItsPolicySays(bool restarts, HealthStatus expected, string description)
    {
        FaultPolicy policy = restarts
            ? FaultPolicy.RestartAfter(
                TimeSpan.FromSeconds(30), TimeSpan.FromSeconds(30), 5, TimeSpan.FromMinutes(1))
            : FaultPolicy.StopManager;
        using TestHost host = Make(r => r.AddManager<Source>().AddManager(
            _ => new Actor("actor", _ => throw new InvalidOperationException("it broke")) { FaultPolicy = policy }));
        await host.StartAsync();

        HealthReportEntry entry = await WaitForAsync(host, expected);
        Assert.StartsWith(description, entry.Description);
        Assert.Contains("it broke", entry.Description);
        Assert.Equal(1L, entry.Data["actor.faults"]);
        await host.StopAsync();
    }

    [Fact]
    public async Task Check_DeadlinesWereMissed_IsDegradedOnce()
    {
        using TestHost host = Make(r => r.AddManager(_ => new Late()));
        await host.StartAsync();

        HealthReportEntry entry = await WaitForAsync(host, HealthStatus.Degraded);
        Assert.StartsWith("late missed ", entry.Description);
        Assert.EndsWith(" deadlines since the last check", entry.Description);
        Assert.Equal("1 managers run", (await WaitForAsync(host, HealthStatus.Healthy)).Description);
        await host.StopAsync();
    }

    private static TestHost Make(Action<RabitBuilder> configure) => new(s =>
    {
        s.AddSingleton(new Journal()).AddRabit(configure);
        s.AddHealthChecks().AddRabit();
    });

    private static async Task<HealthReportEntry> CheckAsync(TestHost host)
        => (await host.Services.GetRequiredService<HealthCheckService>().CheckHealthAsync()).Entries["rabit"];

    private static async Task<HealthReportEntry> WaitForAsync(
        TestHost host, HealthStatus status, Func<HealthReportEntry, bool>? isMeant = null)
    {
        var timeout = new TestTimeout();
        var seen = new List<string>();
        do
        {
            HealthReportEntry entry = await CheckAsync(host);
            if (entry.Status == status && isMeant?.Invoke(entry) != false)
                return entry;
            seen.Add($"{entry.Status}: {entry.Description}");
        }
        while (await timeout.TryWaitAsync());

        throw new TimeoutException(string.Join("\n", seen.Distinct()));
    }
}
