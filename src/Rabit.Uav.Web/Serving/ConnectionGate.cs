using System;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.AspNetCore.Connections;

namespace Rabit.Uav.Web.Serving;

/// <summary>
/// Lets no more connections in than the page can have, and counts those that never become a request: the server below
/// ends them by its time-outs.
/// </summary>
internal sealed class ConnectionGate(int max, PageCounters counters)
{
    private static readonly object RequestSeen = new();

    private int _open;

    public async Task PassAsync(ConnectionContext connection, ConnectionDelegate next)
    {
        if (Interlocked.Increment(ref _open) > max)
        {
            Interlocked.Decrement(ref _open);
            counters.Count((ref LivePageCounters c) => c.ConnectionsRefused++);
            connection.Abort();
            return;
        }

        try
        {
            await next(connection).ConfigureAwait(false);
        }
        finally
        {
            Interlocked.Decrement(ref _open);
            if (!connection.Items.ContainsKey(RequestSeen))
                counters.Count((ref LivePageCounters c) => c.ConnectionsWithoutRequest++);
        }
    }

    /// <summary>A request of the connection could be read.</summary>
    public static void MarkRequest(Microsoft.AspNetCore.Http.Features.IFeatureCollection features)
    {
        if (features.Get<Microsoft.AspNetCore.Connections.Features.IConnectionItemsFeature>() is { } connection)
            connection.Items[RequestSeen] = true;
    }
}
