using System;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Http;
using System.Net.WebSockets;
using System.Text.Json;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Web.Tests.Serving;

/// <summary>What a browser gets, and from where it may ask.</summary>
public sealed class PageTests
{
    [Fact]
    public async Task Get_Page_IsOneFileThatLoadsNothingFromElsewhere()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using HttpResponseMessage answer = await page.Http.GetAsync("/");
        string html = await answer.Content.ReadAsStringAsync();

        Assert.Equal(HttpStatusCode.OK, answer.StatusCode);
        Assert.StartsWith(
            "default-src 'none'; script-src 'sha256-", answer.Headers.GetValues("Content-Security-Policy").Single(),
            StringComparison.Ordinal);
        Assert.Equal("nosniff", answer.Headers.GetValues("X-Content-Type-Options").Single());
        Assert.DoesNotContain("://", html, StringComparison.Ordinal);
        Assert.DoesNotContain("<link", html, StringComparison.Ordinal);
        Assert.DoesNotContain("innerHTML", html, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("127.0.0.1:1", HttpStatusCode.OK)]
    [InlineData("localhost:8080", HttpStatusCode.OK)]
    [InlineData("[::1]:8080", HttpStatusCode.OK)]
    [InlineData("192.168.1.5", HttpStatusCode.OK)]
    [InlineData("drone.example", HttpStatusCode.OK)]
    [InlineData("stranger.example:8080", HttpStatusCode.MisdirectedRequest)]
    [InlineData("localhost.stranger.example", HttpStatusCode.MisdirectedRequest)]
    [InlineData("127.0.0.1.stranger.example", HttpStatusCode.MisdirectedRequest)]
    public async Task Get_ByAHost_IsAnsweredWhereItIsOurs(string host, HttpStatusCode expected)
    {
        await using EmptyPage page = await EmptyPage.StartAsync(o => o.HostNames = ["drone.example"]);
        using var request = new HttpRequestMessage(HttpMethod.Get, "/");
        request.Headers.Host = host;
        using HttpResponseMessage answer = await page.Http.SendAsync(request);
        Assert.Equal(expected, answer.StatusCode);
        Assert.Equal(expected == HttpStatusCode.OK ? 0 : 1, page.Page.Counters.RequestsRefused);
    }

    [Theory]
    [InlineData("GET", "/nowhere", HttpStatusCode.NotFound)]
    [InlineData("GET", "/live", HttpStatusCode.Forbidden)]
    [InlineData("GET", "/picture/0/1", HttpStatusCode.NotFound)]
    [InlineData("GET", "/picture/9/1", HttpStatusCode.NotFound)]
    [InlineData("GET", "/picture/-1/x", HttpStatusCode.NotFound)]
    [InlineData("GET", "/tiles/1/0/0.png", HttpStatusCode.NotFound)]
    [InlineData("GET", "/command", HttpStatusCode.NotFound)]
    [InlineData("DELETE", "/", HttpStatusCode.MethodNotAllowed)]
    [InlineData("GET", "/favicon.ico", HttpStatusCode.NoContent)]
    public async Task Get_WhatIsNotThere_IsRefused(string method, string path, HttpStatusCode expected)
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using var request = new HttpRequestMessage(new HttpMethod(method), path);
        using HttpResponseMessage answer = await page.Http.SendAsync(request);
        Assert.Equal(expected, answer.StatusCode);
    }

    [Theory]
    [InlineData("/tiles/3/2/1.png", HttpStatusCode.OK)]
    [InlineData("/tiles/3/2/2.png", HttpStatusCode.NotFound)]
    [InlineData("/tiles/3/8/1.png", HttpStatusCode.NotFound)]
    [InlineData("/tiles/3/2/..%2F1.png", HttpStatusCode.NotFound)]
    [InlineData("/tiles/..%2F..%2Fetc/2/1.png", HttpStatusCode.NotFound)]
    [InlineData("/tiles/3/2/1.txt", HttpStatusCode.NotFound)]
    public async Task Get_Tile_ComesFromTheFolderOnly(string path, HttpStatusCode expected)
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("rabit-tiles-");
        try
        {
            string tile = Path.Combine(folder.FullName, "3", "2", "1.png");
            Directory.CreateDirectory(Path.GetDirectoryName(tile)!);
            await File.WriteAllBytesAsync(tile, [1, 2, 3]);
            await using EmptyPage page = await EmptyPage.StartAsync(o => o.TileFolder = folder.FullName);
            using HttpResponseMessage answer = await page.Http.GetAsync(path);
            Assert.Equal(expected, answer.StatusCode);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    [Fact]
    public async Task Watch_Browser_GetsTheStateAndThenWhatChanges()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using ClientWebSocket socket = await page.WatchAsync("http://127.0.0.1:" + page.Page.Address!.Port);
        JsonElement about = default;
        while (!(await ReceiveAsync(socket)).GetProperty("set").TryGetProperty("0/about", out about))
            Assert.True(page.Page.Counters.Messages < 100);
        Assert.Equal("vehicle 1", about.GetProperty("name").GetString());
        JsonElement next = await ReceiveAsync(socket);
        Assert.False(next.GetProperty("set").TryGetProperty("0/about", out _));
        Assert.Equal(1, page.Page.Counters.Browsers);
        await socket.CloseAsync(WebSocketCloseStatus.NormalClosure, null, CancellationToken.None);
        await EmptyPage.WaitAsync(() => page.Page.Counters.Browsers == 0);
        Assert.Equal(0, page.Page.Counters.BrowsersDropped);
    }

    [Theory]
    [InlineData("http://stranger.example")]
    [InlineData("null")]
    [InlineData("http://127.0.0.1:1")]
    public async Task Watch_FromAnotherPage_IsRefused(string origin)
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        await Assert.ThrowsAsync<WebSocketException>(() => page.WatchAsync(origin));
        Assert.Equal((1, 0), (page.Page.Counters.RequestsRefused, page.Page.Counters.Browsers));
    }

    [Fact]
    public async Task Watch_MoreBrowsersThanMay_AreRefused()
    {
        await using EmptyPage page = await EmptyPage.StartAsync(o => o.MaxBrowsers = 2);
        using ClientWebSocket first = await page.WatchAsync();
        using ClientWebSocket second = await page.WatchAsync();
        await Assert.ThrowsAsync<WebSocketException>(() => page.WatchAsync());
        Assert.Equal((2, 1), (page.Page.Counters.Browsers, page.Page.Counters.BrowsersRefused));
        first.Abort();
        await EmptyPage.WaitAsync(() => page.Page.Counters.Browsers == 1);
        using ClientWebSocket third = await page.WatchAsync();
        await ReceiveAsync(third);
    }

    [Fact]
    public async Task Start_AddressThatIsTaken_NamesIt()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        await using var other = new LivePage(
            new LivePageOptions { EndPoint = new IPEndPoint(IPAddress.Loopback, page.Page.Address!.Port) });
        IOException fault = await Assert.ThrowsAsync<IOException>(() => other.StartAsync());
        Assert.Contains($"127.0.0.1:{page.Page.Address.Port}", fault.Message, StringComparison.Ordinal);
    }

    private static async Task<JsonElement> ReceiveAsync(ClientWebSocket socket)
    {
        var buffer = new byte[4000];
        using var late = new CancellationTokenSource(TestTimeout.Limit);
        ValueWebSocketReceiveResult received = await socket.ReceiveAsync(buffer.AsMemory(), late.Token);
        Assert.True(received.EndOfMessage);
        return JsonDocument.Parse(buffer.AsMemory(0, received.Count)).RootElement;
    }
}
