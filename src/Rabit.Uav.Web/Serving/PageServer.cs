using System;
using System.Linq;
using System.Net;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;

namespace Rabit.Uav.Web.Serving;

/// <summary>
/// Makes the server of a page: one address, HTTP/1.1, and limits on everything that a stranger could hold.
/// </summary>
internal static class PageServer
{
    private const int MaxBodyBytes = 64 * 1024;
    private const int MaxBufferedBytes = 16 * 1024;

    // A browser has one connection that watches and up to six for pictures.
    private const int ConnectionsForPictures = 64;

    private static readonly TimeSpan HeadersTimeout = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan IdleTimeout = TimeSpan.FromSeconds(5);
    // Who holds a request open at the end must not hold the program.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan PingPeriod = TimeSpan.FromSeconds(10);

    public static WebApplication Create(LivePageOptions options, PageCounters counters, RequestDelegate handle)
    {
        // Empty: neither the settings nor the environment of the program open another address.
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.WebHost.UseKestrelCore();
        builder.Services.AddSingleton<IHostLifetime, NoLifetime>();
        builder.Services.Configure<HostOptions>(host => host.ShutdownTimeout = StopTimeout);
        var gate = new ConnectionGate(options.MaxBrowsers + ConnectionsForPictures, counters);
        builder.WebHost.ConfigureKestrel(kestrel =>
        {
            kestrel.AddServerHeader = false;
            SetLimits(kestrel.Limits);
            kestrel.Listen(options.EndPoint, listen =>
            {
                listen.Protocols = HttpProtocols.Http1;
                listen.Use(next => connection => gate.PassAsync(connection, next));
            });
        });
        WebApplication app = builder.Build();
        app.UseWebSockets(new WebSocketOptions { KeepAliveInterval = PingPeriod, KeepAliveTimeout = PingPeriod });
        app.Run(handle);
        return app;
    }

    /// <summary>Where it listens; after the start.</summary>
    public static Uri AddressOf(WebApplication app)
        => new(app.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>()!.Addresses.First());

    private static void SetLimits(KestrelServerLimits limits)
    {
        limits.MaxRequestBodySize = MaxBodyBytes;
        limits.MaxRequestBufferSize = MaxBufferedBytes;

        // Little waits for a slow browser: what comes after it is newer.
        limits.MaxResponseBufferSize = MaxBufferedBytes;
        limits.MaxRequestLineSize = 2048;
        limits.MaxRequestHeadersTotalSize = MaxBufferedBytes;
        limits.RequestHeadersTimeout = HeadersTimeout;
        limits.KeepAliveTimeout = IdleTimeout;
    }
}
