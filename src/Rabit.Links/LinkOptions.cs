using System;

namespace Rabit.Links;

/// <summary>How long a link may wait. Immutable.</summary>
/// <example>
/// <code>
/// var options = new LinkOptions(connectTimeout: TimeSpan.FromSeconds(2));
/// using IByteLink link = LinkFactory.Open(LinkUrl.Parse("tcp:127.0.0.1:5760"), options);
/// </code>
/// </example>
public sealed class LinkOptions
{
    private static readonly TimeSpan Longest = TimeSpan.FromHours(1);
    private static readonly TimeSpan ReopenDelayLimit = TimeSpan.FromSeconds(2);

    /// <summary>Chooses the limits; what is left out has its default.</summary>
    /// <param name="connectTimeout">See <see cref="ConnectTimeout"/>; 1 ms to 1 h.</param>
    /// <param name="writeTimeout">See <see cref="WriteTimeout"/>; 1 ms to 1 h.</param>
    /// <param name="firstReopenDelay">See <see cref="FirstReopenDelay"/>; 1 ms to the longest.</param>
    /// <param name="maxReopenDelay">See <see cref="MaxReopenDelay"/>; 1 ms to 2 s.</param>
    /// <param name="clock">See <see cref="Clock"/>.</param>
    /// <param name="peerIdleTime">See <see cref="PeerIdleTime"/>; 1 ms to 1 h.</param>
    /// <param name="keepAlive">See <see cref="KeepAlive"/>; 1 ms to 1 h.</param>
    /// <param name="resolveAfter">See <see cref="ResolveAfter"/>; 1 ms to 1 h.</param>
    /// <exception cref="ArgumentOutOfRangeException">A limit is out of its range.</exception>
    public LinkOptions(
        TimeSpan? connectTimeout = null, TimeSpan? writeTimeout = null, TimeSpan? firstReopenDelay = null,
        TimeSpan? maxReopenDelay = null, TimeProvider? clock = null, TimeSpan? peerIdleTime = null,
        TimeSpan? keepAlive = null, TimeSpan? resolveAfter = null)
    {
        PeerIdleTime = Checked(peerIdleTime ?? TimeSpan.FromMinutes(1), Longest, nameof(peerIdleTime));
        KeepAlive = keepAlive is { } interval ? Checked(interval, Longest, nameof(keepAlive)) : null;
        ResolveAfter = Checked(resolveAfter ?? TimeSpan.FromSeconds(30), Longest, nameof(resolveAfter));
        ConnectTimeout = Checked(connectTimeout ?? TimeSpan.FromSeconds(5), Longest, nameof(connectTimeout));
        WriteTimeout = Checked(writeTimeout ?? TimeSpan.FromSeconds(1), Longest, nameof(writeTimeout));
        MaxReopenDelay = Checked(maxReopenDelay ?? ReopenDelayLimit, ReopenDelayLimit, nameof(maxReopenDelay));
        TimeSpan first = TimeSpan.FromMilliseconds(100);
        FirstReopenDelay = Checked(
            firstReopenDelay ?? (first < MaxReopenDelay ? first : MaxReopenDelay), MaxReopenDelay,
            nameof(firstReopenDelay));
        Clock = clock ?? TimeProvider.System;
    }

    /// <summary>The defaults.</summary>
    public static LinkOptions Default { get; } = new();

    /// <summary>How long to wait for each address of a host to take a connection. Default 5 s.</summary>
    public TimeSpan ConnectTimeout { get; }

    /// <summary>How long one write may wait for room on the way out. Default 1 s.</summary>
    public TimeSpan WriteTimeout { get; }

    /// <summary>
    /// After what time a <see cref="ReopeningLink"/> that broke is tried again first; it doubles with every failure in
    /// a row. Default 100 ms.
    /// </summary>
    public TimeSpan FirstReopenDelay { get; }

    /// <summary>Where the doubling ends. Default 2 s.</summary>
    public TimeSpan MaxReopenDelay { get; }

    /// <summary>
    /// What a <see cref="ReopeningLink"/> counts its delays by: the system's, or that of a virtual time for links that
    /// do not block.
    /// </summary>
    public TimeProvider Clock { get; }

    /// <summary>After what silence a <see cref="UdpListenLink"/> forgets a peer. Default 1 min.</summary>
    public TimeSpan PeerIdleTime { get; }

    /// <summary>
    /// After what time without a write a <see cref="UdpSendLink"/> sends an empty datagram, so that routers with
    /// address translation keep the way back open. Default null: never.
    /// </summary>
    public TimeSpan? KeepAlive { get; }

    /// <summary>
    /// After what silence a <see cref="UdpSendLink"/> looks up the name of its host again. Default 30 s.
    /// </summary>
    public TimeSpan ResolveAfter { get; }

    /// <summary>These, but where a URL says otherwise.</summary>
    internal LinkOptions With(LinkSettings url) => url.IdleTime is null && url.KeepAlive is null ? this : new(
        ConnectTimeout, WriteTimeout, FirstReopenDelay, MaxReopenDelay, Clock, url.IdleTime ?? PeerIdleTime,
        url.KeepAlive ?? KeepAlive, ResolveAfter);

    internal int WriteTimeoutMilliseconds => (int)Math.Ceiling(WriteTimeout.TotalMilliseconds);

    private static TimeSpan Checked(TimeSpan limit, TimeSpan longest, string name)
    {
        if (limit < TimeSpan.FromMilliseconds(1) || limit > longest)
            throw new ArgumentOutOfRangeException(
                name, limit,
                FormattableString.Invariant(
                    $"a time of a link is 1 ms to {(longest == Longest ? "1 h" : $"{longest.TotalSeconds:0.###} s")}"));
        return limit;
    }
}
