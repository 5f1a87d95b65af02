using System;
using System.Net;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation;

namespace Rabit.Uav.Web.Tests;

/// <summary>A small simulated search at a multiple of the pace of a real flight, shown on a page.</summary>
internal sealed class PageFlight : IAsyncDisposable
{
    public const string Token = "a-token-that-tests-know-0123";

    private const string Mission =
        """
        {
          "name": "small meadow",
          "area": [[47.39730, 8.54470], [47.39780, 8.54470], [47.39780, 8.54560], [47.39730, 8.54560]],
          "keepOuts": [[[47.39752, 8.54520], [47.39757, 8.54520], [47.39757, 8.54526], [47.39752, 8.54526]]],
          "heightMetres": 30, "speedMetresPerSecond": 5, "laneSpacingMetres": 22
        }
        """;

    private readonly UavSystem _uav;
    private readonly bool _ownsPage;
    private readonly Task<ReactorResult> _run;
    private readonly MessageSubscriber<MissionStatus> _mission;
    private readonly MessageSubscriber<VehicleState> _vehicle;

    private PageFlight(LivePage page, bool ownsPage, string name, double pace, long seed)
    {
        (Page, _ownsPage) = (page, ownsPage);
        MissionPlan plan = MissionPlan.Parse(Mission, name);
        var options = new SimulationOptions { Seed = seed, TargetCount = 2 };
        options.TakePlacesFrom(plan);
        World = new SimulatedWorld(options);
        var links = new MemoryLinkPair("vehicle");
        var log = new LiveLog();
        _uav = UavSystem.Open(new UavOptions
        {
            OpenLinks = [links.A],
            OtherManagers = [World.CreateVehicle(links.B)],
            Subscriptions = [LivePage.CreateSubscription()],
            Mission = plan,
            MayCommand = true,
            Camera = World.CreateCamera(),
            Imaging = new ImageProcessingOptions { Camera = World.CameraModel, Mount = World.CameraMount },
            Seed = seed,
            Time = new VirtualTime(seed) { Pace = pace },
        });
        RabitReactor reactor = _uav.CreateReactor(
            new ReactorOptions { Log = log.Add, MaxStopDelay = TimeSpan.FromSeconds(5), StopsOnSignals = false });
        Page.Add(reactor, new LiveVehicleOptions
        {
            Name = name,
            LinkCount = _uav.LinkCount,
            Operator = _uav.MissionControl,
            ImageChips = () => _uav.ImageProcessing.ImageChips,
            Log = log,
            ShowsOtherVehicles = true,
        });
        Reactor = reactor;
        _mission = reactor.Workspace.Subscribe<MissionStatus>(MessageNames.Mission);
        _vehicle = reactor.Workspace.Subscribe<VehicleState>(MessageNames.VehicleState);
        _run = reactor.RunAsync();
    }

    public LivePage Page { get; }

    public RabitReactor Reactor { get; }

    public SimulatedWorld World { get; }

    public MissionStatus MissionStatus => Latest(_mission);

    public VehicleState Vehicle => Latest(_vehicle);

    /// <summary>Opens a page of its own.</summary>
    public static async Task<PageFlight> StartAsync(
        double pace = 8, long seed = 4, int port = 0, string? token = Token, string name = "alpha")
    {
        var page = new LivePage(new LivePageOptions
        {
            EndPoint = new IPEndPoint(IPAddress.Loopback, port),
            Token = token is null ? null : LivePageToken.Create(token),
        });
        await page.StartAsync();
        return new PageFlight(page, ownsPage: true, name, pace, seed);
    }

    /// <summary>Shows another vehicle on a page that is there.</summary>
    public static PageFlight StartOn(LivePage page, string name, double pace = 8, long seed = 5)
        => new(page, ownsPage: false, name, pace, seed);

    public async Task StopAsync()
    {
        Reactor.Stop("the test is over");
        await _run;
    }

    public async ValueTask DisposeAsync()
    {
        await StopAsync();
        if (_ownsPage)
            await Page.DisposeAsync();
        _uav.Dispose();
    }

    private T Latest<T>(MessageSubscriber<T> subscriber)
    {
        if (!Reactor.IsWired)
            return default!;
        subscriber.Fetch();
        return subscriber.Value;
    }
}
