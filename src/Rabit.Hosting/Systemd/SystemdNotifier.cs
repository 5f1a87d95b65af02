using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Net.Sockets;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Options;

namespace Rabit.Hosting;

/// <summary>
/// Reports to systemd (Type=notify): READY when all reactors have started, STATUS where it changes, WATCHDOG while no
/// manager hangs, STOPPING and the time that the ordered stop may take. Any thread.
/// </summary>
internal sealed class SystemdNotifier(
    SystemdEnvironment environment, HostedReactors reactors, IHostApplicationLifetime lifetime,
    IOptions<HostOptions> host, ILogger<SystemdNotifier> logger)
    : IHostedService, IDisposable
{
    private static readonly TimeSpan StatusEvery = TimeSpan.FromSeconds(1);

    private readonly object _gate = new();
    private readonly List<ReactorWatch> _watches = WatchesOf(reactors);   // all of these under _gate
    private readonly List<ReactorWatch> _watchdogs = WatchesOf(reactors);
    private readonly List<Timer> _timers = [];
    private NotificationSocket? _socket;
    private string _status = string.Empty;
    private bool _isStopping;
    private bool _hasFailed;

    public Task StartAsync(CancellationToken cancellationToken)
    {
        if (environment.NotifySocket is null)
            return Task.CompletedTask;
        try
        {
            _socket = new NotificationSocket(environment.NotifySocket);
        }
        catch (Exception e) when (e is FormatException or SocketException)
        {
            SystemdLog.CannotNotify(logger, environment.NotifySocket, e.Message);
            return Task.CompletedTask;
        }

        lifetime.ApplicationStarted.Register(Begin);
        lifetime.ApplicationStopping.Register(BeginStop);
        return Task.CompletedTask;
    }

    public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    public void Dispose()
    {
        lock (_gate)
        {
            _timers.ForEach(t => t.Dispose());
            _socket?.Dispose();
            _socket = null;
        }
    }

    private static List<ReactorWatch> WatchesOf(HostedReactors reactors)
        => reactors.Names.Select(n => new ReactorWatch(reactors, n)).ToList();

    private void Begin()
    {
        lock (_gate)
        {
            Send("READY=1");
            _timers.Add(new Timer(_ => ReportStatus(), state: null, TimeSpan.Zero, StatusEvery));
            if (environment.WatchdogTimeout is { } timeout)
            {
                var half = TimeSpan.FromTicks(Math.Max(TimeSpan.TicksPerMillisecond, timeout.Ticks / 2));
                _timers.Add(new Timer(_ => FeedWatchdog(), state: null, TimeSpan.Zero, half));
            }
        }
    }

    private void BeginStop()
    {
        long microseconds = RabitHostOptions.WholeStop(host.Value.ShutdownTimeout).Ticks / 10;
        lock (_gate)
        {
            _isStopping = true;
            Send(string.Format(
                CultureInfo.InvariantCulture, "STOPPING=1\nEXTEND_TIMEOUT_USEC={0}\nSTATUS=stops in order",
                microseconds));
        }
    }

    private void ReportStatus()
    {
        lock (_gate)
        {
            string status = string.Join("; ", _watches.Select(w => w.Look().StatusLine)).Replace('\n', ' ');
            if (_isStopping || status == _status)
                return;
            _status = status;
            Send("STATUS=" + status);
        }
    }

    // Goes on during the stop, which may take longer than the watchdog waits. Another look than that of the status,
    // which counts from look to look.
    private void FeedWatchdog()
    {
        lock (_gate)
        {
            if (_watchdogs.TrueForAll(w => w.Look().Condition != ReactorCondition.Hangs))
                Send("WATCHDOG=1");
        }
    }

    private void Send(string text)
    {
        if (_socket is null)
            return;
        try
        {
            _socket.Send(text);
            _hasFailed = false;
        }
        catch (SocketException e)
        {
            if (!_hasFailed)
                SystemdLog.CannotNotify(logger, environment.NotifySocket!, e.Message);
            _hasFailed = true;
        }
    }
}
