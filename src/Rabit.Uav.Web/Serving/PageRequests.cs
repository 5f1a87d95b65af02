using System;
using System.Collections.Generic;
using System.Globalization;
using System.Net.WebSockets;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.AspNetCore.Http;
using Rabit.Uav.Web.State;

namespace Rabit.Uav.Web.Serving;

/// <summary>Answers each request: the page, its pictures and tiles, browsers that watch, commands.</summary>
internal sealed class PageRequests(
    LivePageOptions options, Func<IReadOnlyList<LiveVehicle>> vehicles, PageState state, PageCounters counters,
    CancellationToken stop)
{
    private const int MaxBodyBytes = 64 * 1024;

    private static readonly TimeSpan SendTimeout = TimeSpan.FromSeconds(10);

    private readonly PageFile _page = PageFile.Load();
    private readonly RequestGate _gate = new(options.HostNames);
    private readonly TileFolder? _tiles = options.TileFolder is { } folder ? new TileFolder(folder) : null;
    private readonly CommandEndpoint _commands =
        new(options.Token, vehicles, new CommandLimit(TimeProvider.System), counters);

    public async Task HandleAsync(HttpContext context)
    {
        ConnectionGate.MarkRequest(context.Features);
        SetHeaders(context.Response.Headers);
        try
        {
            if (!_gate.IsHostOurs(context.Request))
                Refuse(context, StatusCodes.Status421MisdirectedRequest);
            else if (context.Request.ContentLength > MaxBodyBytes)
                Refuse(context, StatusCodes.Status413PayloadTooLarge);
            else
                await AnswerAsync(context).ConfigureAwait(false);
        }
        catch (BadHttpRequestException e)
        {
            if (context.Response.HasStarted)
                throw;
            Refuse(context, e.StatusCode);
        }
        catch (OperationCanceledException) when (context.RequestAborted.IsCancellationRequested)
        {
            // The browser has left.
        }
    }

    private Task AnswerAsync(HttpContext context)
    {
        HttpRequest request = context.Request;
        string path = request.Path.Value ?? string.Empty;
        if (HttpMethods.IsPost(request.Method) && path == "/command")
            return _commands.HandleAsync(context);
        if (!HttpMethods.IsGet(request.Method))
            return RefuseAsync(context, StatusCodes.Status405MethodNotAllowed);
        if (path == "/")
            return SendAsync(context, "text/html; charset=utf-8", _page.Html);
        if (path == "/live")
            return WatchAsync(context);
        if (path == "/favicon.ico")
        {
            context.Response.StatusCode = StatusCodes.Status204NoContent;
            return Task.CompletedTask;
        }

        if (path.StartsWith("/picture/", StringComparison.Ordinal))
            return SendPictureAsync(context, path["/picture/".Length..]);
        if (request.Path.StartsWithSegments("/tiles", StringComparison.Ordinal, out PathString tile))
            return SendTileAsync(context, tile);
        return RefuseAsync(context, StatusCodes.Status404NotFound);
    }

    private async Task WatchAsync(HttpContext context)
    {
        if (!context.WebSockets.IsWebSocketRequest || !RequestGate.IsOriginOurs(context.Request))
        {
            Refuse(context, StatusCodes.Status403Forbidden);
            return;
        }

        if (!counters.TryAddBrowser(options.MaxBrowsers))
        {
            context.Response.StatusCode = StatusCodes.Status503ServiceUnavailable;
            return;
        }

        bool isOrderly = true;
        try
        {
            using WebSocket socket = await context.WebSockets.AcceptWebSocketAsync().ConfigureAwait(false);
            isOrderly = await new BrowserSession(socket, state, counters, SendTimeout).RunAsync(stop)
                .ConfigureAwait(false);
        }
        finally
        {
            counters.Count((ref LivePageCounters c) =>
            {
                c.Browsers--;
                c.BrowsersDropped += isOrderly ? 0 : 1;
            });
        }
    }

    // "VEHICLE/TRACK"; the page adds the number of the picture, so that a browser keeps it as long as it likes.
    private Task SendPictureAsync(HttpContext context, string name)
    {
        string[] parts = name.Split('/');
        byte[]? png = parts.Length == 2 && TryParse(parts[0], out int vehicle) && TryParse(parts[1], out int track)
            && vehicles() is var all && vehicle < all.Count
                ? all[vehicle].Pictures.Read(track)
                : null;
        if (png is null)
            return RefuseAsync(context, StatusCodes.Status404NotFound);
        context.Response.Headers.CacheControl = "private, max-age=3600";
        return SendAsync(context, "image/png", png);
    }

    private Task SendTileAsync(HttpContext context, PathString tile)
    {
        if (_tiles?.Find(tile.Value ?? string.Empty) is not { } file)
            return RefuseAsync(context, StatusCodes.Status404NotFound);
        context.Response.Headers.CacheControl = "private, max-age=3600";
        context.Response.ContentType = "image/png";
        return context.Response.SendFileAsync(file, context.RequestAborted);
    }

    private static bool TryParse(string text, out int value)
        => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out value);

    private static Task SendAsync(HttpContext context, string type, byte[] content)
    {
        context.Response.ContentType = type;
        context.Response.ContentLength = content.Length;
        return context.Response.Body.WriteAsync(content, context.RequestAborted).AsTask();
    }

    private Task RefuseAsync(HttpContext context, int status)
    {
        Refuse(context, status);
        return Task.CompletedTask;
    }

    private void Refuse(HttpContext context, int status)
    {
        counters.Count((ref LivePageCounters c) => c.RequestsRefused++);
        context.Response.StatusCode = status;

        // Nothing more is read of a request that is refused.
        context.Response.Headers.Connection = "close";
    }

    private void SetHeaders(IHeaderDictionary headers)
    {
        headers.ContentSecurityPolicy = _page.Policy;
        headers.XContentTypeOptions = "nosniff";
        headers["Referrer-Policy"] = "no-referrer";
        headers["Cross-Origin-Resource-Policy"] = "same-origin";
        headers.CacheControl = "no-store";
    }
}
