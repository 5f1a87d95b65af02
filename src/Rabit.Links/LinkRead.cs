namespace Rabit.Links;

/// <summary>What came of one <see cref="IByteLink.Read"/>. A plain value; its default is "nothing yet".</summary>
public readonly struct LinkRead
{
    private LinkRead(LinkReadKind kind, int count, string? reason)
    {
        Kind = kind;
        Count = count;
        Reason = reason;
    }

    /// <summary>There is nothing to read at the moment.</summary>
    public static LinkRead NothingYet => default;

    /// <summary>Whether bytes came, none are there yet, or the link has ended.</summary>
    public LinkReadKind Kind { get; }

    /// <summary>How many bytes came; 0 unless <see cref="Kind"/> is <see cref="LinkReadKind.Bytes"/>.</summary>
    public int Count { get; }

    /// <summary>Why the link has ended, one line without the URL; null while it has not.</summary>
    public string? Reason { get; }

    /// <summary>Bytes came.</summary>
    /// <param name="count">How many, at least 1.</param>
    public static LinkRead Bytes(int count) => new(LinkReadKind.Bytes, count, null);

    /// <summary>The link has ended.</summary>
    /// <param name="reason">Why, one line without the URL.</param>
    public static LinkRead Ended(string reason) => new(LinkReadKind.Ended, 0, reason);

    /// <summary>For logs: "12 bytes", "nothing yet", or "ended: " and the reason.</summary>
    public override string ToString() => Kind switch
    {
        LinkReadKind.Bytes => Count == 1 ? "1 byte" : $"{Count} bytes",
        LinkReadKind.Ended => $"ended: {Reason}",
        _ => "nothing yet",
    };
}
