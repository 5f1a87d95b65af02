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

    /// <summary>Chooses the limits; what is left out has its default.</summary>
    /// <param name="connectTimeout">See <see cref="ConnectTimeout"/>; 1 ms to 1 h.</param>
    /// <param name="writeTimeout">See <see cref="WriteTimeout"/>; 1 ms to 1 h.</param>
    /// <exception cref="ArgumentOutOfRangeException">A limit is shorter than 1 ms or longer than 1 h.</exception>
    public LinkOptions(TimeSpan? connectTimeout = null, TimeSpan? writeTimeout = null)
    {
        ConnectTimeout = Checked(connectTimeout ?? TimeSpan.FromSeconds(5), nameof(connectTimeout));
        WriteTimeout = Checked(writeTimeout ?? TimeSpan.FromSeconds(1), nameof(writeTimeout));
    }

    /// <summary>The defaults.</summary>
    public static LinkOptions Default { get; } = new();

    /// <summary>How long to wait for each address of a host to take a connection. Default 5 s.</summary>
    public TimeSpan ConnectTimeout { get; }

    /// <summary>How long one write may wait for room on the way out. Default 1 s.</summary>
    public TimeSpan WriteTimeout { get; }

    internal int WriteTimeoutMilliseconds => (int)Math.Ceiling(WriteTimeout.TotalMilliseconds);

    private static TimeSpan Checked(TimeSpan limit, string name)
    {
        if (limit < TimeSpan.FromMilliseconds(1) || limit > Longest)
            throw new ArgumentOutOfRangeException(name, limit, "a time-out of a link is 1 ms to 1 h");
        return limit;
    }
}
