using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.AspNetCore.Builder;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Communications;
using Rabit.Uav.Web.Collecting;
using Rabit.Uav.Web.Serving;
using Rabit.Uav.Web.State;

namespace Rabit.Uav.Web;

/// <summary>
/// Shows flights in browsers while they last: one page, and what has changed five times a second. It reads what the
/// managers post by a manager of its own in each reactor; all else runs on threads of its own, so that no browser
/// delays a manager. With a token a browser can command the mission; without one it only watches.
/// </summary>
/// <remarks>
/// Make it, start it, add each vehicle before its reactor starts, run the reactors, dispose of it after them. The page
/// speaks HTTP without encryption: over a network that others use it belongs into a VPN or an SSH tunnel.
/// </remarks>
/// <example>
/// <code>
/// var log = new LiveLog();
/// RabitReactor reactor = uav.CreateReactor(new ReactorOptions { Log = log.Add });
/// await using var page = new LivePage(new LivePageOptions());   // http://127.0.0.1:8080
/// await page.StartAsync();
/// page.Add(reactor, new LiveVehicleOptions { LinkCount = uav.LinkCount, Log = log });
/// reactor.Run();
/// </code>
/// </example>
public sealed class LivePage : IAsyncDisposable
{
    private static readonly TimeSpan Period = TimeSpan.FromMilliseconds(200);

    private readonly LivePageOptions _options;
    private readonly Lock _gate = new();                 // guards the change of the next
    private volatile LiveVehicle[] _vehicles = [];       // a new array for each that comes
    private readonly PageState _state = new();
    private readonly PageCounters _counters = new();
    private readonly CancellationTokenSource _stop = new();
    private WebApplication? _server;
    private Task _writing = Task.CompletedTask;
    private bool _isDisposed;

    /// <summary>Makes a page; nothing is opened yet.</summary>
    /// <param name="options">Checked and read now; later changes have no effect.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public LivePage(LivePageOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        options.Validate(nameof(options));
        _options = options.Copy();
    }

    /// <summary>Where browsers find it; null before the start.</summary>
    public Uri? Address { get; private set; }

    /// <summary>What it has done and refused so far. Any thread.</summary>
    public LivePageCounters Counters
    {
        get
        {
            LivePageCounters counters = _counters.Value;
            foreach (LiveVehicle vehicle in _vehicles)
                counters.MomentsDropped += vehicle.Dropped;
            return counters;
        }
    }

    /// <summary>
    /// The subscription that brings the page the positions of other vehicles: for
    /// <see cref="UavOptions.Subscriptions"/>, with <see cref="LiveVehicleOptions.ShowsOtherVehicles"/>.
    /// </summary>
    public static MavlinkSubscription CreateSubscription()
        => new(LivePageManager.PositionsQueue) { MessageIds = [GlobalPositionInt.MavlinkId] };

    /// <summary>
    /// Adds a vehicle, and to its reactor the manager that reads for the page. Before the start of the reactor, and
    /// after all managers that are to be shown.
    /// </summary>
    /// <param name="reactor">Of the vehicle; each reactor once.</param>
    /// <param name="options">Read now; later changes have no effect.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    public void Add(RabitReactor reactor, LiveVehicleOptions options)
    {
        ArgumentNullException.ThrowIfNull(reactor);
        ArgumentNullException.ThrowIfNull(options);
        lock (_gate)
            _vehicles = [.. _vehicles, new LiveVehicle(_vehicles.Length, reactor, options)];
    }

    /// <summary>Opens the address.</summary>
    /// <param name="cancellationToken">Gives the start up.</param>
    /// <exception cref="IOException">The address cannot be opened; the text names it and says why.</exception>
    /// <exception cref="InvalidOperationException">It was started before.</exception>
    public async Task StartAsync(CancellationToken cancellationToken = default)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        if (_server is not null)
            throw new InvalidOperationException("The live page was started before.");
        var requests = new PageRequests(_options, () => _vehicles, _state, _counters, _stop.Token);
        _server = PageServer.Create(_options, _counters, requests.HandleAsync);
        try
        {
            await _server.StartAsync(cancellationToken).ConfigureAwait(false);
        }
        catch (Exception e) when (e is IOException or System.Net.Sockets.SocketException)
        {
            throw new IOException($"The live page cannot listen at {_options.EndPoint}: {e.Message}", e);
        }

        Address = PageServer.AddressOf(_server);
        _writing = WriteAsync();
    }

    /// <summary>Closes the page; browsers keep what they saw last, and look for it again.</summary>
    public async ValueTask DisposeAsync()
    {
        if (_isDisposed)
            return;
        _isDisposed = true;
        await _stop.CancelAsync().ConfigureAwait(false);
        await _writing.ConfigureAwait(false);
        if (_server is not null)
        {
            await _server.StopAsync().ConfigureAwait(false);
            await _server.DisposeAsync().ConfigureAwait(false);
        }

        _stop.Dispose();
    }

    private async Task WriteAsync()
    {
        using var writer = new ItemWriter(_state);
        using var timer = new PeriodicTimer(Period);
        long start = TimeProvider.System.GetTimestamp();
        try
        {
            do
            {
                Write(writer, TimeProvider.System.GetElapsedTime(start));
            }
            while (await timer.WaitForNextTickAsync(_stop.Token).ConfigureAwait(false));
        }
        catch (OperationCanceledException)
        {
            // The page is closed.
        }
    }

    private void Write(ItemWriter writer, TimeSpan realTime)
    {
        try
        {
            foreach (LiveVehicle vehicle in _vehicles)
                vehicle.Write(writer, _state, realTime);
            WriteAboutPage(writer, realTime);
            _state.Signal();
        }
        catch (Exception e) when (e is not OutOfMemoryException)
        {
            // One value that cannot be written must not take the page away.
            _counters.Count((ref LivePageCounters c) => c.Faults++);
        }
    }

    // Once a second something comes, so that a browser notices when nothing does.
    private void WriteAboutPage(ItemWriter writer, TimeSpan realTime)
    {
        LivePageCounters counters = Counters;
        writer.Object("page").Count("vehicles", _vehicles.Length).Number("up", Math.Floor(realTime.TotalSeconds), 0)
            .Count("browsers", counters.Browsers).Flag("token", _options.Token is not null)
            .Flag("tiles", _options.TileFolder is not null)
            .Count("refused", counters.RequestsRefused + counters.ConnectionsRefused + counters.BrowsersRefused
                + counters.CommandsRefused + counters.ConnectionsWithoutRequest)
            .Count("faults", counters.Faults).End();
    }
}
