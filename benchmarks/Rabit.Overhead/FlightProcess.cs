using System;
using System.Diagnostics;
using System.IO;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using System.Threading;
using System.Threading.Tasks;

namespace Rabit.Overhead;

/// <summary>
/// A flight in a process of its own, and the clients of its page and its diagnostics, which are in this process: what
/// they cost is not measured.
/// </summary>
internal sealed class FlightProcess : IDisposable
{
    /// <summary>Begins the line that says where page and socket are.</summary>
    public const string Where = "where: ";

    private const string StatusEverySecond = "{\"request\":\"status\",\"everyMilliseconds\":1000}\n";

    private readonly Process _process;
    private readonly Socket? _notifications;
    private readonly string? _notifySocket;
    private readonly CancellationTokenSource _stop = new();
    private readonly TaskCompletionSource<string> _where = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private long _bytesOfPage;
    private long _bytesOfTool;

    public FlightProcess(Parts parts)
    {
        Parts = parts;
        var start = new ProcessStartInfo(Environment.ProcessPath!, [OverheadProgram.Flight, parts.ToString()])
        {
            UseShellExecute = false,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
        };
        if (parts.HasFlag(Parts.Hosting))
        {
            _notifySocket = Path.Combine(Path.GetTempPath(), "rabit-overhead-" + Guid.NewGuid().ToString("N"));
            _notifications = new Socket(AddressFamily.Unix, SocketType.Dgram, ProtocolType.Unspecified);
            _notifications.Bind(new UnixDomainSocketEndPoint(_notifySocket));
            start.Environment["NOTIFY_SOCKET"] = _notifySocket;
        }

        _process = Process.Start(start)!;
        _process.OutputDataReceived += (_, e) =>
        {
            if (e.Data?.StartsWith(Where, StringComparison.Ordinal) == true)
                _where.TrySetResult(e.Data.Substring(Where.Length));
        };
        _process.BeginOutputReadLine();
    }

    public Parts Parts { get; }

    /// <summary>Processor time so far, seconds, user and system.</summary>
    public double ProcessorSeconds
    {
        get
        {
            _process.Refresh();
            return _process.TotalProcessorTime.TotalSeconds;
        }
    }

    /// <summary>What the clients have received so far.</summary>
    public (long Page, long Tool) Bytes => (Interlocked.Read(ref _bytesOfPage), Interlocked.Read(ref _bytesOfTool));

    /// <summary>Connects the clients; they receive until the end.</summary>
    public async Task ConnectAsync()
    {
        string[] where = (await _where.Task.WaitAsync(TimeSpan.FromMinutes(1))).Split('\t');
        int browsers = Parts.HasFlag(Parts.TwentyBrowsers) ? 20 : Parts.HasFlag(Parts.Page) ? 1 : 0;
        for (int i = 0; i < browsers; i++)
            _ = WatchPageAsync(new Uri(where[0].Replace("http", "ws", StringComparison.Ordinal) + "live"));
        if (Parts.HasFlag(Parts.Tool))
            _ = AskStatusAsync(where[1]);
        if (_notifications is not null)
            _ = DrainAsync(_notifications);
    }

    public void Dispose()
    {
        _stop.Cancel();
        _process.StandardInput.Close();
        if (!_process.WaitForExit(TimeSpan.FromMinutes(1)))
            _process.Kill();
        _process.Dispose();
        _notifications?.Dispose();
        if (_notifySocket is not null)
            File.Delete(_notifySocket);
        _stop.Dispose();
    }

    private async Task WatchPageAsync(Uri address)
    {
        using var socket = new ClientWebSocket();
        await socket.ConnectAsync(address, _stop.Token);
        byte[] buffer = new byte[65536];
        while (!_stop.IsCancellationRequested)
            Interlocked.Add(ref _bytesOfPage, (await socket.ReceiveAsync(buffer, _stop.Token)).Count);
    }

    private async Task AskStatusAsync(string path)
    {
        using var socket = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified);
        await socket.ConnectAsync(new UnixDomainSocketEndPoint(path), _stop.Token);
        await socket.SendAsync(Encoding.UTF8.GetBytes(StatusEverySecond), _stop.Token);
        byte[] buffer = new byte[65536];
        while (!_stop.IsCancellationRequested)
            Interlocked.Add(ref _bytesOfTool, await socket.ReceiveAsync(buffer, _stop.Token));
    }

    private async Task DrainAsync(Socket socket)
    {
        byte[] buffer = new byte[4096];
        while (!_stop.IsCancellationRequested)
            await socket.ReceiveAsync(buffer, _stop.Token);
    }
}
