using System;

namespace Rabit.Links;

/// <summary>What came of one <see cref="IByteLink.Read"/>. A plain value; its default is "nothing yet".</summary>
public readonly struct LinkRead
{
    private LinkRead(LinkReadKind kind, int count = 0, string? reason = null, int peer = 0, TimeSpan? retryAfter = null)
    {
        Kind = kind;
        Count = count;
        Reason = reason;
        Peer = peer;
        RetryAfter = retryAfter;
    }

    /// <summary>There is nothing to read at the moment.</summary>
    public static LinkRead NothingYet => default;

    /// <summary>Whether bytes came, none are there yet, or the link has ended.</summary>
    public LinkReadKind Kind { get; }

    /// <summary>How many bytes came; 0 unless <see cref="Kind"/> is <see cref="LinkReadKind.Bytes"/>.</summary>
    public int Count { get; }

    /// <summary>
    /// Which of several peers the bytes are of, from 0, on a link that many write to at once: the bytes of each are a
    /// stream of their own. A number is used again when a peer is forgotten. 0 on all other links.
    /// </summary>
    public int Peer { get; }

    /// <summary>
    /// After what time to read again where nothing came, though no callback says so; null where a callback will.
    /// </summary>
    public TimeSpan? RetryAfter { get; }

    /// <summary>Why the link has ended, one line without the URL; null while it has not.</summary>
    public string? Reason { get; }

    /// <summary>Bytes came.</summary>
    /// <param name="count">How many, at least 1.</param>
    /// <param name="peer">See <see cref="Peer"/>.</param>
    public static LinkRead Bytes(int count, int peer = 0) => new(LinkReadKind.Bytes, count, peer: peer);

    /// <summary>There is nothing to read, and will be nothing for some time unless the callback says so.</summary>
    /// <param name="delay">See <see cref="RetryAfter"/>.</param>
    public static LinkRead NothingYetFor(TimeSpan delay) => new(LinkReadKind.NothingYet, retryAfter: delay);

    /// <summary>The link has ended.</summary>
    /// <param name="reason">Why, one line without the URL.</param>
    public static LinkRead Ended(string reason) => new(LinkReadKind.Ended, reason: reason);

    /// <summary>For logs: "12 bytes", "nothing yet", or "ended: " and the reason.</summary>
    public override string ToString() => Kind switch
    {
        LinkReadKind.Bytes => Count == 1 ? "1 byte" : $"{Count} bytes",
        LinkReadKind.Ended => $"ended: {Reason}",
        _ => "nothing yet",
    };
}
