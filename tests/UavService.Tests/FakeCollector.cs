using System;
using System.Collections.Generic;
using System.IO;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Threading.Tasks;

namespace UavService.Tests;

/// <summary>A collector of metrics: takes one request by HTTP after the other.</summary>
internal sealed class FakeCollector : IDisposable
{
    private static readonly byte[] Answer
        = "HTTP/1.1 200 OK\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"u8.ToArray();

    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly TaskCompletionSource<string> _first = new(TaskCreationOptions.RunContinuationsAsynchronously);

    private readonly string _text;

    /// <param name="text">A request that has it is kept: the first may come before all managers run.</param>
    public FakeCollector(string text)
    {
        _text = text;
        _listener.Start();
        _ = AnswerAsync();
    }

    public string Endpoint => $"http://127.0.0.1:{((IPEndPoint)_listener.LocalEndpoint).Port}/v1/metrics";

    /// <summary>Head and body of the first request that has the text; a character for each byte.</summary>
    public Task<string> FirstAsync => _first.Task.WaitAsync(TimeSpan.FromSeconds(120));

    public void Dispose() => _listener.Dispose();

    private async Task AnswerAsync()
    {
        try
        {
            while (true)
            {
                using TcpClient client = await _listener.AcceptTcpClientAsync();
                using NetworkStream stream = client.GetStream();
                string request = await ReadAsync(stream);
                await stream.WriteAsync(Answer);
                if (request.Contains(_text, StringComparison.Ordinal))
                    _first.TrySetResult(request);
            }
        }
        catch (Exception e) when (e is SocketException or IOException or ObjectDisposedException)
        {
            _first.TrySetException(e);   // the end, or a service that went away
        }
    }

    private static async Task<string> ReadAsync(NetworkStream stream)
    {
        var text = new StringBuilder();
        var buffer = new byte[65536];
        while (Missing(text.ToString()) > 0)
        {
            int count = await stream.ReadAsync(buffer);
            if (count == 0)
                break;
            text.Append(Encoding.Latin1.GetString(buffer, 0, count));
        }

        return text.ToString();
    }

    private static int Missing(string text)
    {
        int body = text.IndexOf("\r\n\r\n", StringComparison.Ordinal);
        if (body < 0)
            return 1;
        const string Name = "Content-Length: ";
        int length = text.IndexOf(Name, StringComparison.OrdinalIgnoreCase);
        return int.Parse(text.AsSpan(length + Name.Length, text.IndexOf('\r', length) - length - Name.Length), null)
            - (text.Length - body - 4);
    }
}
