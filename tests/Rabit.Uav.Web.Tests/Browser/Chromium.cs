using System;
using System.Collections.Concurrent;
using System.Diagnostics;
using System.IO;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Web.Tests.Browser;

/// <summary>A headless Chromium, spoken to by the DevTools protocol. One for all tests of a class.</summary>
public sealed class Chromium : IAsyncLifetime
{
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(60);   // on an idle machine

    private readonly string _folder = Path.Combine(Path.GetTempPath(), "rabit-web-" + Guid.NewGuid().ToString("N"));
    private readonly ClientWebSocket _socket = new();
    private readonly SemaphoreSlim _sending = new(1);
    private readonly ConcurrentDictionary<int, TaskCompletionSource<JsonElement>> _waiting = new();
    private readonly ConcurrentQueue<Action<string, string, JsonElement>> _listeners = new();
    private readonly CancellationTokenSource _stop = new();
    private Process? _process;
    private Task _receiving = Task.CompletedTask;
    private int _lastId;

    public async Task InitializeAsync()
    {
        if (BrowserFactAttribute.FindProgram() is not { } program)
            return;
        Directory.CreateDirectory(_folder);
        _process = Process.Start(new ProcessStartInfo(
            program,
            [
                "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
                "--disable-background-networking", "--disable-extensions", "--hide-scrollbars",
                "--remote-debugging-port=0", "--user-data-dir=" + _folder, "about:blank",
            ])
        {
            UseShellExecute = false,
            RedirectStandardError = true,
            RedirectStandardOutput = true,
        })!;
        _process.OutputDataReceived += (_, _) => { };
        _process.BeginOutputReadLine();
        Uri address = await ReadAddressAsync(_process.StandardError).WaitAsync(TestTimeout.LimitOf(MaxWait));
        await _socket.ConnectAsync(address, CancellationToken.None);
        _receiving = ReceiveAsync();
    }

    public async Task DisposeAsync()
    {
        await _stop.CancelAsync();
        await _receiving;
        _socket.Dispose();
        if (_process is not null)
        {
            _process.Kill(entireProcessTree: true);
            await _process.WaitForExitAsync();
            _process.Dispose();
            DeleteFolder();
        }
    }

    /// <summary>Opens an empty tab of its own.</summary>
    internal async Task<BrowserTab> OpenTabAsync()
    {
        JsonElement context = await SendAsync(null, "Target.createBrowserContext", new { });
        JsonElement target = await SendAsync(null, "Target.createTarget", new
        {
            url = "about:blank",
            browserContextId = context.GetProperty("browserContextId").GetString(),
        });
        JsonElement session = await SendAsync(null, "Target.attachToTarget", new
        {
            targetId = target.GetProperty("targetId").GetString(),
            flatten = true,
        });
        var tab = new BrowserTab(this, session.GetProperty("sessionId").GetString()!);
        await tab.EnableAsync();
        return tab;
    }

    /// <summary>Passes each event on: session, method, parameters. On the thread that receives.</summary>
    internal void Listen(Action<string, string, JsonElement> listener) => _listeners.Enqueue(listener);

    internal async Task<JsonElement> SendAsync(string? session, string method, object parameters)
    {
        int id = Interlocked.Increment(ref _lastId);
        var answer = new TaskCompletionSource<JsonElement>(TaskCreationOptions.RunContinuationsAsynchronously);
        _waiting[id] = answer;
        string text = session is null
            ? JsonSerializer.Serialize(new { id, method, @params = parameters })
            : JsonSerializer.Serialize(new { id, method, @params = parameters, sessionId = session });
        await _sending.WaitAsync();
        try
        {
            await _socket.SendAsync(
                Encoding.UTF8.GetBytes(text), WebSocketMessageType.Text, endOfMessage: true, CancellationToken.None);
        }
        finally
        {
            _sending.Release();
        }

        return await answer.Task.WaitAsync(TestTimeout.LimitOf(MaxWait));
    }

    private static async Task<Uri> ReadAddressAsync(StreamReader errors)
    {
        const string Mark = "DevTools listening on ";
        while (await errors.ReadLineAsync() is { } line)
        {
            if (!line.StartsWith(Mark, StringComparison.Ordinal))
                continue;
            _ = DrainAsync(errors);
            return new Uri(line[Mark.Length..]);
        }

        throw new InvalidOperationException("Chromium ended at its start.");
    }

    private static async Task DrainAsync(StreamReader errors)
    {
        while (await errors.ReadLineAsync() is not null)
        {
            // What a browser says of the machine is of no interest here.
        }
    }

    private async Task ReceiveAsync()
    {
        var buffer = new byte[1 << 16];
        try
        {
            while (true)
            {
                using var message = new MemoryStream();
                ValueWebSocketReceiveResult received;
                do
                {
                    received = await _socket.ReceiveAsync(buffer.AsMemory(), _stop.Token);
                    message.Write(buffer, 0, received.Count);
                }
                while (!received.EndOfMessage);
                if (received.MessageType == WebSocketMessageType.Close)
                    return;
                Handle(JsonDocument.Parse(message.ToArray()).RootElement);
            }
        }
        catch (Exception e) when (e is OperationCanceledException or WebSocketException)
        {
            foreach (TaskCompletionSource<JsonElement> waiting in _waiting.Values)
                waiting.TrySetCanceled();
        }
    }

    private void Handle(JsonElement message)
    {
        if (!message.TryGetProperty("id", out JsonElement id))
        {
            string session = message.TryGetProperty("sessionId", out JsonElement s) ? s.GetString()! : string.Empty;
            foreach (Action<string, string, JsonElement> listener in _listeners)
                listener(session, message.GetProperty("method").GetString()!, message.GetProperty("params"));
            return;
        }

        if (!_waiting.TryRemove(id.GetInt32(), out TaskCompletionSource<JsonElement>? answer))
            return;
        if (message.TryGetProperty("error", out JsonElement error))
            answer.TrySetException(new InvalidOperationException("Chromium: " + error));
        else
            answer.TrySetResult(message.GetProperty("result"));
    }

    // Its last processes may still write for a moment.
    private void DeleteFolder()
    {
        try
        {
            Directory.Delete(_folder, recursive: true);
        }
        catch (IOException)
        {
            // A folder of temporary files stays.
        }
    }
}
