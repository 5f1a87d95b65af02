using System;
using System.Collections.Generic;
using System.IO;
using System.Net;
using System.Net.Http;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Web.Tests.Serving;

/// <summary>What a stranger can do: nothing that a manager notices, and nothing that is not counted.</summary>
public sealed class HostileTests
{
    private const string Upgrade =
        "GET /live HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
            + "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n";

    [Fact]
    public async Task Connections_AThousand_AreRefusedAndThePageComesBack()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using ClientWebSocket watching = await page.WatchAsync();
        var strangers = new List<TcpClient>();
        for (int i = 0; i < 1000; i++)
            strangers.Add(await TryConnectAsync(page));
        await EmptyPage.WaitAsync(() => page.Page.Counters.ConnectionsRefused >= 1000 - 96);

        // Who watched goes on watching, and the managers work.
        await ReceiveAsync(watching);
        long ticks = page.Ticks.Count;
        await EmptyPage.WaitAsync(() => page.Ticks.Count > ticks + 20);
        strangers.ForEach(s => s.Dispose());
        await EmptyPage.WaitAsync(() => page.Page.Counters.ConnectionsWithoutRequest >= 90);
        using HttpResponseMessage answer = await page.Http.GetAsync("/");
        Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
    }

    // All at once, since each takes as long as the page waits for a request.
    [Fact]
    public async Task Request_HalfOpen_IsEndedAndCounted()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using TcpClient get = await page.ConnectAsync("GET / HTTP/1.1\r\nHost: loc");
        using TcpClient post = await page.ConnectAsync("POST /command HTTP/1.1\r\n");
        using TcpClient letter = await page.ConnectAsync("G");
        await Task.WhenAll(ReadToEndAsync(get), ReadToEndAsync(post), ReadToEndAsync(letter));
        await EmptyPage.WaitAsync(() => page.Page.Counters.ConnectionsWithoutRequest == 3);
    }

    // The host alone would wait for it for 30 s.
    [Fact]
    public async Task Close_WhileABodyIsHalfSent_DoesNotWaitForIt()
    {
        EmptyPage page = await EmptyPage.StartAsync();
        using TcpClient client = await page.ConnectAsync(
            "POST /command HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
                + $"Authorization: Bearer {EmptyPage.Token}\r\nContent-Length: 5000\r\n\r\n{{");
        await Task.Delay(200);
        await page.DisposeAsync().AsTask().WaitAsync(TimeSpan.FromSeconds(20));
    }

    [Theory]
    [InlineData("\u0016\u0003\u0001\u0002\u0000\u0001\u0000\u0001\u00fc\u0003\u0003")]
    [InlineData("GET / HTTP/9.9\r\n\r\n")]
    [InlineData("EXPLODE\r\n\r\n")]
    [InlineData("GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n")]
    [InlineData("GET / HTTP/1.1\r\n\r\n")]
    [InlineData("GET http://stranger.example/ HTTP/1.1\r\nHost: localhost\r\n\r\n")]
    public async Task Request_Malformed_IsRefusedAndCounted(string text)
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using TcpClient client = await page.ConnectAsync(text);
        string answer = await ReadToEndAsync(client);
        Assert.DoesNotContain("200 OK", answer, StringComparison.Ordinal);
        await EmptyPage.WaitAsync(
            () => page.Page.Counters.ConnectionsWithoutRequest + page.Page.Counters.RequestsRefused == 1);
    }

    [Fact]
    public async Task Request_LineWithoutEnd_IsRefused()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using TcpClient client = await page.ConnectAsync("GET /" + new string('a', 10_000));
        Assert.Contains("414", await ReadToEndAsync(client), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(new byte[] { 0xf1, 0x85, 0, 0, 0, 0, 1, 2, 3, 4, 5 })]           // reserved bits
    [InlineData(new byte[] { 0x81, 0x05, 1, 2, 3, 4, 5 })]                         // not masked
    [InlineData(new byte[] { 0x83, 0x80, 0, 0, 0, 0 })]                            // an operation that there is not
    [InlineData(new byte[] { 0x89, 0xfe, 0x40, 0, 0, 0, 0, 0 })]                   // a ping that is too long
    [InlineData(new byte[] { 0x81, 0x85, 0, 0, 0, 0, 1, 2, 3, 4, 5 })]           // a text: browsers say nothing
    public async Task Watch_FrameThatMayNotBe_CutsTheBrowserOff(byte[] frame)
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using TcpClient client = await page.ConnectAsync(Upgrade);
        await EmptyPage.WaitAsync(() => page.Page.Counters.Browsers == 1);
        await client.GetStream().WriteAsync(frame);
        await EmptyPage.WaitAsync(() => page.Page.Counters.Browsers == 0);
        Assert.Equal(1, page.Page.Counters.BrowsersDropped);
        long ticks = page.Ticks.Count;
        await EmptyPage.WaitAsync(() => page.Ticks.Count > ticks + 5);
    }

    [Fact]
    public async Task Get_WithALongBody_IsRefused()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using TcpClient client = await page.ConnectAsync(
            "GET / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000000\r\n\r\n");
        Assert.Contains("413", await ReadToEndAsync(client), StringComparison.Ordinal);
        Assert.Equal(1, page.Page.Counters.RequestsRefused);
    }

    // The page may have closed it before the connection was made.
    private static async Task<TcpClient> TryConnectAsync(EmptyPage page)
    {
        try
        {
            return await page.ConnectAsync();
        }
        catch (SocketException)
        {
            return new TcpClient();
        }
    }

    // An end, in order or not.
    private static async Task<string> ReadToEndAsync(TcpClient client)
    {
        var text = new StringBuilder();
        var buffer = new byte[4096];
        using var late = new CancellationTokenSource(TestTimeout.Limit);
        try
        {
            while (await client.GetStream().ReadAsync(buffer, late.Token) is > 0 and int read)
                text.Append(Encoding.Latin1.GetString(buffer, 0, read));
        }
        catch (IOException)
        {
            // It was reset.
        }

        return text.ToString();
    }

    private static async Task ReceiveAsync(ClientWebSocket socket)
    {
        using var late = new CancellationTokenSource(TestTimeout.Limit);
        await socket.ReceiveAsync(new byte[4000].AsMemory(), late.Token);
    }
}
