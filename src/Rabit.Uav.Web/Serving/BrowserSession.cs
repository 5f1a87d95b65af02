using System;
using System.Net.WebSockets;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Uav.Web.State;

namespace Rabit.Uav.Web.Serving;

/// <summary>
/// A browser that watches: sends what has changed, and waits until the browser has taken it before it looks what has
/// changed by then. It keeps a buffer and one number.
/// </summary>
/// <param name="socket">To the browser.</param>
/// <param name="state">What it is to know.</param>
/// <param name="counters">Of the page.</param>
/// <param name="sendTimeout">How long a browser may take for one message.</param>
internal sealed class BrowserSession(WebSocket socket, PageState state, PageCounters counters, TimeSpan sendTimeout)
{
    private static readonly TimeSpan GoodbyeTimeout = TimeSpan.FromSeconds(1);

    /// <returns>Whether the browser left by itself, or the page stopped; false where it was cut off.</returns>
    public async Task<bool> RunAsync(CancellationToken stop)
    {
        using var ended = CancellationTokenSource.CreateLinkedTokenSource(stop);
        Task<bool> receiving = ReceiveAsync(ended);
        bool isSent = await SendAllAsync(ended).ConfigureAwait(false);
        await ended.CancelAsync().ConfigureAwait(false);
        bool isOrderly = await receiving.ConfigureAwait(false);
        if (isSent && isOrderly)
            await LeaveAsync().ConfigureAwait(false);
        socket.Abort();
        return isSent && isOrderly;
    }

    // Says goodbye where that is still possible.
    private async Task LeaveAsync()
    {
        using var late = new CancellationTokenSource(GoodbyeTimeout);
        try
        {
            if (socket.State is WebSocketState.CloseReceived or WebSocketState.Open)
                await socket.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, null, late.Token)
                    .ConfigureAwait(false);
        }
        catch (Exception e) when (e is WebSocketException or OperationCanceledException or InvalidOperationException)
        {
            // It has gone without.
        }
    }

    private async Task<bool> SendAllAsync(CancellationTokenSource ended)
    {
        var message = new byte[PageState.MaxMessageBytes];
        long has = 0;
        try
        {
            while (true)
            {
                Task news = state.News;
                int length = state.Fill(ref has, message, out bool isComplete);
                if (length > 0 && !await SendAsync(message.AsMemory(0, length), ended).ConfigureAwait(false))
                    return false;
                if (isComplete)
                    await news.WaitAsync(ended.Token).ConfigureAwait(false);
            }
        }
        catch (OperationCanceledException)
        {
            return true;
        }
        catch (WebSocketException)
        {
            // It is gone; the receiving side says in which way.
            return true;
        }
    }

    private async Task<bool> SendAsync(ReadOnlyMemory<byte> message, CancellationTokenSource ended)
    {
        using var late = CancellationTokenSource.CreateLinkedTokenSource(ended.Token);
        late.CancelAfter(sendTimeout);
        try
        {
            await socket.SendAsync(message, WebSocketMessageType.Text, endOfMessage: true, late.Token)
                .ConfigureAwait(false);
            counters.CountMessage(message.Length);
            return true;
        }
        catch (OperationCanceledException) when (!ended.IsCancellationRequested)
        {
            return false;
        }
    }

    // A browser has nothing to say here but that it leaves. Whatever else comes ends it.
    private async Task<bool> ReceiveAsync(CancellationTokenSource ended)
    {
        try
        {
            ValueWebSocketReceiveResult received =
                await socket.ReceiveAsync(new byte[16].AsMemory(), ended.Token).ConfigureAwait(false);
            return received.MessageType == WebSocketMessageType.Close;
        }
        catch (OperationCanceledException)
        {
            return true;
        }
        catch (WebSocketException e)
        {
            return e.WebSocketErrorCode == WebSocketError.ConnectionClosedPrematurely;
        }
        finally
        {
            await ended.CancelAsync().ConfigureAwait(false);
        }
    }
}
