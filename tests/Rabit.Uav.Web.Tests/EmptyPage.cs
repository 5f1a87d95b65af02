using System;
using System.Net;
using System.Net.Http;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Uav.Web.Tests;

/// <summary>A page of a reactor with one manager that counts in real time, and an operator who only listens.</summary>
internal sealed class EmptyPage : IAsyncDisposable
{
    public const string Token = "a-token-that-tests-know-0123";

    private readonly RabitReactor _reactor;
    private readonly Task<ReactorResult> _run;

    private EmptyPage(LivePage page)
    {
        Page = page;
        _reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false }) { Ticks };
        page.Add(_reactor, new LiveVehicleOptions { Operator = Operator });
        _run = _reactor.RunAsync();
        Http = new HttpClient { BaseAddress = page.Address };
    }

    public LivePage Page { get; }

    public HttpClient Http { get; }

    public RecordedOperator Operator { get; } = new();

    public TickManager Ticks { get; } = new();

    public static async Task<EmptyPage> StartAsync(Action<LivePageOptions>? change = null)
    {
        var options = new LivePageOptions
        {
            EndPoint = new IPEndPoint(IPAddress.Loopback, 0),
            Token = LivePageToken.Create(Token),
        };
        change?.Invoke(options);
        var page = new LivePage(options);
        await page.StartAsync();
        return new EmptyPage(page);
    }

    public async Task<ClientWebSocket> WatchAsync(string? origin = null)
    {
        var socket = new ClientWebSocket();
        if (origin is not null)
            socket.Options.SetRequestHeader("Origin", origin);
        await socket.ConnectAsync(new Uri($"ws://127.0.0.1:{Page.Address!.Port}/live"), CancellationToken.None);
        return socket;
    }

    /// <summary>A connection to say what no browser says.</summary>
    public async Task<TcpClient> ConnectAsync(string text = "")
    {
        var client = new TcpClient();
        await client.ConnectAsync(IPAddress.Loopback, Page.Address!.Port);
        if (text.Length > 0)
            await client.GetStream().WriteAsync(Encoding.Latin1.GetBytes(text));
        return client;
    }

    public static async Task WaitAsync(Func<bool> condition)
    {
        var timeout = new TestTimeout();
        while (!condition())
            Assert.True(await timeout.TryWaitAsync(), "It never came so.");
    }

    public async ValueTask DisposeAsync()
    {
        Http.Dispose();
        _reactor.Stop("the test is over");
        await _run;
        await Page.DisposeAsync();
    }

    public sealed class TickManager : RabitManager
    {
        private long _count;

        public TickManager()
            : base("ticks")
            => WakeUpDelay = TimeSpan.FromMilliseconds(10);

        public long Count => Interlocked.Read(ref _count);

        protected override void ExecuteUnitOfWork() => Interlocked.Increment(ref _count);
    }
}
