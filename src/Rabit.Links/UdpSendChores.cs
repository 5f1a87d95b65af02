using System;
using System.Net;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// When a UDP client looks up the name of its host again, because nothing comes, and when it sends an empty datagram.
/// The reader's thread, but for what it says of writes, which any thread does.
/// </summary>
internal sealed class UdpSendChores(LinkOptions options, bool isNamed)
{
    private readonly TimeProvider _clock = options.Clock;
    private long _quietSince = options.Clock.GetTimestamp(); // received from, or looked up, last
    private long _written = options.Clock.GetTimestamp(); // interlocked access

    /// <summary>Whether there is anything to do at all.</summary>
    public bool Any { get; } = isNamed || options.KeepAlive is not null;

    public bool IsLookUpDue => isNamed && Left(_quietSince, options.ResolveAfter) <= TimeSpan.Zero;

    public bool IsKeepAliveDue
        => options.KeepAlive is { } interval && Left(Interlocked.Read(ref _written), interval) <= TimeSpan.Zero;

    /// <summary>How long to wait at most before there is something to do; at least 1.</summary>
    public int Milliseconds
    {
        get
        {
            TimeSpan left = isNamed ? Left(_quietSince, options.ResolveAfter) : TimeSpan.MaxValue;
            if (options.KeepAlive is { } interval && Left(Interlocked.Read(ref _written), interval) is var alive
                && alive < left)
                left = alive;
            return (int)Math.Max(1, Math.Min(int.MaxValue, Math.Ceiling(left.TotalMilliseconds)));
        }
    }

    public void Received() => _quietSince = _clock.GetTimestamp();

    public void LookedUp() => _quietSince = _clock.GetTimestamp();

    public void Written()
    {
        if (options.KeepAlive is not null) Interlocked.Exchange(ref _written, _clock.GetTimestamp());
    }

    public static bool IsName(string host) => !IPAddress.TryParse(host, out _);

    private TimeSpan Left(long since, TimeSpan time) => time - _clock.GetElapsedTime(since);
}
