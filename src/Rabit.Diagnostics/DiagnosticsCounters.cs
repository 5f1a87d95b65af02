namespace Rabit.Diagnostics;

/// <summary>What became of the clients so far. A plain value.</summary>
public readonly record struct DiagnosticsCounters
{
    /// <summary>Clients that are connected now.</summary>
    public int Connected { get; init; }

    /// <summary>Clients that were let in.</summary>
    public long Accepted { get; init; }

    /// <summary>Clients that were turned away: of another user, or too many at once.</summary>
    public long Refused { get; init; }

    /// <summary>
    /// Requests that were refused: no JSON, unknown, too long, too many, or for something that is not there. Each was
    /// answered with what is wrong.
    /// </summary>
    public long RefusedRequests { get; init; }

    /// <summary>Clients that were disconnected since they took nothing, or asked for nothing, for too long.</summary>
    public long Dropped { get; init; }

    /// <summary>Samples that a client did not get since it had not taken the ones before.</summary>
    public long SkippedSamples { get; init; }
}
