using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Microsoft.Extensions.DependencyInjection;
using Xunit;

namespace Rabit.Hosting.Tests;

/// <summary>What a service manager is notified of.</summary>
public sealed class SystemdTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task Service_StartsAndStops_IsReadyAfterTheBarrierAndSaysHowLongTheStopMayTake(bool isAbstract)
    {
        using var systemd = new FakeSystemd(isAbstract);
        var journal = new Journal();
        using var host = new TestHost(
            s => systemd.AddTo(s.AddSingleton(journal).AddRabit(r => r.AddManager<Source>().AddManager<Sink>())),
            shutdownTimeout: TimeSpan.FromSeconds(7));
        await host.StartAsync();
        Assert.Equal("source-up sink-up ", journal.Text);
        Assert.Equal("READY=1", systemd.Next());
        Assert.Equal("STATUS=2 managers run", systemd.Next());
        Assert.Null(systemd.Next(0.1));   // no watchdog was asked for

        await host.StopAsync();

        Assert.Equal("STOPPING=1\nEXTEND_TIMEOUT_USEC=7000000\nSTATUS=stops in order", systemd.Next());
    }

    [Fact]
    public async Task Startup_Fails_IsNeverReady()
    {
        using var systemd = new FakeSystemd(isAbstract: true);
        using var host = new TestHost(s => systemd.AddTo(s.AddRabit(r => r.AddManager(_ => new Orphan("first")))));
        await Assert.ThrowsAnyAsync<Exception>(host.StartAsync);

        Assert.DoesNotContain("READY=1", systemd.For(0.2));
    }

    [Fact]
    public async Task Watchdog_ManagerHangs_IsFedAtHalfItsTimeUntilThen()
    {
        using var systemd = new FakeSystemd(isAbstract: false);
        systemd.Environment["WATCHDOG_USEC"] = "400000";
        systemd.Environment["WATCHDOG_PID"] = "77";
        using var stuck = new Stuck { WaitsFor = TimeSpan.FromSeconds(1.5) };
        var settings = new Dictionary<string, string?> { ["Rabit:UnitOfWorkLimit"] = "00:00:00.3" };
        using var host = new TestHost(
            s => systemd.AddTo(s.AddRabit(r => r.AddManager(_ => stuck)), processId: 77), settings);
        await host.StartAsync();
        List<string> good = systemd.For(1);
        Assert.InRange(good.Count(t => t == "WATCHDOG=1"), 3, 6);

        Assert.StartsWith("STATUS=stuck hangs: ", systemd.Until("STATUS=stuck hangs").Last());
        Assert.DoesNotContain("WATCHDOG=1", systemd.For(0.7));
        stuck.Release();
        systemd.Until("WATCHDOG=1");
        await host.StopAsync();
    }

    [Theory]
    [InlineData("400000", "76")]
    [InlineData("0", null)]
    [InlineData("-1", null)]
    [InlineData("often", null)]
    public async Task Watchdog_OfAnotherProcessOrNone_IsNotFed(string microseconds, string? pid)
    {
        using var systemd = new FakeSystemd(isAbstract: true);
        systemd.Environment["WATCHDOG_USEC"] = microseconds;
        if (pid is not null)
            systemd.Environment["WATCHDOG_PID"] = pid;
        using var host = new TestHost(
            s => systemd.AddTo(s.AddRabit(r => r.AddManager(_ => new Actor("actor", _ => { }))), processId: 77));
        await host.StartAsync();

        Assert.DoesNotContain("WATCHDOG=1", systemd.For(0.5));
        await host.StopAsync();
    }

    [Theory]
    [InlineData("/nowhere/at/all")]
    [InlineData("vsock:2:1234")]
    public async Task Socket_CannotBeReached_IsAWarningAndTheServiceRuns(string address)
    {
        using var host = new TestHost(s => s
            .AddSingleton(new SystemdEnvironment(n => n == "NOTIFY_SOCKET" ? address : null, processId: 1))
            .AddRabitSystemd().AddRabit(r => r.AddManager(_ => new Actor("actor", _ => { }))));
        await host.StartAsync();
        await host.StopAsync();

        RecordedEntry warning = Assert.Single(host.Log.Entries, e => e.Id == RabitEventIds.CannotNotify);
        Assert.Contains(address, warning.Text);
        Assert.Equal(0, host.ExitCode);
    }

    [Fact]
    public async Task Host_NotAService_NotifiesNothing()
    {
        using var host = new TestHost(s => s
            .AddSingleton(new SystemdEnvironment(_ => null, processId: 1))
            .AddRabitSystemd().AddRabit(r => r.AddManager(_ => new Actor("actor", _ => { }))));
        await host.StartAsync();
        await host.StopAsync();

        Assert.DoesNotContain(host.Log.Entries, e => e.Id == RabitEventIds.CannotNotify);
    }
}
