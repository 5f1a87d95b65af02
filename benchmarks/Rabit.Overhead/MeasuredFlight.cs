using System;
using System.IO;
using System.Net;
using System.Threading.Tasks;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Diagnostics.HealthChecks;
using Microsoft.Extensions.Hosting;
using Rabit.Core;
using Rabit.Diagnostics;
using Rabit.Hosting;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;
using Rabit.Uav.Web;

namespace Rabit.Overhead;

/// <summary>
/// The process that is measured: the flight of UavConsole in real time, vehicle and camera simulated, each manager on a
/// thread of its own. It says where its page and its socket are, and flies until its standard input ends.
/// </summary>
internal sealed class MeasuredFlight(Parts parts)
{
    private static readonly TimeSpan HealthPeriod = TimeSpan.FromSeconds(5);

    private readonly LiveLog _log = new();

    public async Task<int> RunAsync()
    {
        using UavSystem uav = UavSystem.Open(Compose());
        await using LivePage? page = await OpenPageAsync();
        if (parts.HasFlag(Parts.Hosting))
            await RunHostedAsync(uav, page);
        else
            await RunAloneAsync(uav, page);
        return 0;
    }

    private static UavOptions Compose()
    {
        string file = Path.Combine(AppContext.BaseDirectory, "search.json");
        MissionPlan mission = MissionPlan.Parse(File.ReadAllText(file), file);
        var worldOptions = new SimulationOptions { Seed = 1, TargetCount = 5 };
        worldOptions.TakePlacesFrom(mission);
        var world = new SimulatedWorld(worldOptions);
        var links = new MemoryLinkPair("vehicle");
        return new UavOptions
        {
            OpenLinks = [links.A],
            OtherManagers = [world.CreateVehicle(links.B)],
            Mission = mission,
            MayCommand = true,
            Camera = world.CreateCamera(),
            Imaging = new ImageProcessingOptions { Camera = world.CameraModel, Mount = world.CameraMount },
        };
    }

    private async Task<LivePage?> OpenPageAsync()
    {
        if (!parts.HasFlag(Parts.Page))
            return null;
        var page = new LivePage(new LivePageOptions { EndPoint = new IPEndPoint(IPAddress.Loopback, 0) });
        await page.StartAsync();
        return page;
    }

    private async Task RunAloneAsync(UavSystem uav, LivePage? page)
    {
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions
        {
            Log = entry =>
            {
                _log.Add(entry);
                Console.WriteLine(entry.ToString());
            },
        });
        Show(uav, page, reactor);
        using RabitDiagnostics? diagnostics = OpenDiagnostics(reactor);
        Task<ReactorResult> run = reactor.RunAsync();
        SayWhere(page, diagnostics);
        WaitForTheEnd();
        reactor.Stop();
        await run;
    }

    private async Task RunHostedAsync(UavSystem uav, LivePage? page)
    {
        HostApplicationBuilder builder = Host.CreateApplicationBuilder();
        builder.Services.AddRabit(rabit => rabit
            .CreateReactor((_, options) => uav.CreateReactor(options))
            .Setup((_, reactor) => Show(uav, page, reactor)));
        builder.Services.AddHealthChecks().AddRabit();
        builder.Services.AddSingleton<IHealthCheckPublisher, NoPublisher>();
        builder.Services.Configure<HealthCheckPublisherOptions>(o => o.Period = HealthPeriod);
        builder.Services.AddRabitSystemd();
        using IHost host = builder.Build();
        await host.StartAsync();
        using RabitDiagnostics? diagnostics =
            OpenDiagnostics(host.Services.GetRequiredService<HostedReactors>()["rabit"]);
        SayWhere(page, diagnostics);
        WaitForTheEnd();
        await host.StopAsync();
    }

    private void Show(UavSystem uav, LivePage? page, RabitReactor reactor)
        => page?.Add(reactor, new LiveVehicleOptions
        {
            LinkCount = uav.LinkCount,
            ImageChips = () => uav.ImageProcessing.ImageChips,
            Log = _log,
        });

    private RabitDiagnostics? OpenDiagnostics(RabitReactor reactor)
        => parts.HasFlag(Parts.Tool) ? RabitDiagnostics.Open(reactor) : null;

    private static void SayWhere(LivePage? page, RabitDiagnostics? diagnostics)
    {
        if (diagnostics?.Fault is { } fault)
            Console.Error.WriteLine(fault);
        Console.WriteLine($"{FlightProcess.Where}{page?.Address}\t{diagnostics?.SocketPath}");
    }

    private static void WaitForTheEnd() => Console.In.ReadToEnd();

    private sealed class NoPublisher : IHealthCheckPublisher
    {
        public Task PublishAsync(HealthReport report, System.Threading.CancellationToken cancellationToken)
            => Task.CompletedTask;
    }
}
