using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// How many bytes of vehicle messages one link may still carry: so many a second, never more than one second's worth at
/// once, but one datagram, however slow it is.
/// </summary>
/// <param name="bytesPerSecond">Above zero.</param>
/// <param name="longestDatagram">Bytes of the longest one with its header.</param>
internal sealed class TunnelRateLimiter(int bytesPerSecond, int longestDatagram)
{
    private readonly int _most = Math.Max(bytesPerSecond, longestDatagram);
    private double _bytes = Math.Max(bytesPerSecond, longestDatagram);
    private TimeSpan _filledAt;

    /// <summary>Whether so many bytes may go out now.</summary>
    public bool HasRoom(int bytes, TimeSpan now)
    {
        if (now > _filledAt)
        {
            _bytes = Math.Min(_most, _bytes + ((now - _filledAt).ExactSeconds * bytesPerSecond));
            _filledAt = now;
        }

        return bytes <= _bytes;
    }

    /// <summary>How long until so many bytes may go out; zero where they may now.</summary>
    public TimeSpan TimeToRoom(int bytes, TimeSpan now)
        => HasRoom(bytes, now)
            ? TimeSpan.Zero
            : TimeSpan.FromTicks((long)Math.Ceiling((bytes - _bytes) / bytesPerSecond * TimeSpan.TicksPerSecond));

    /// <summary>Takes what goes out.</summary>
    public void Take(int bytes) => _bytes -= bytes;
}
