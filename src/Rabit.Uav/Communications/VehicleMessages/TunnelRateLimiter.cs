using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// How many bytes of vehicle messages one link may still carry: so many a second, never more than one second's worth at
/// once.
/// </summary>
internal sealed class TunnelRateLimiter(int bytesPerSecond)
{
    private double _bytes = bytesPerSecond;
    private TimeSpan _filledAt;

    /// <summary>Whether so many bytes may go out now.</summary>
    public bool HasRoom(int bytes, TimeSpan now)
    {
        if (now > _filledAt)
        {
            _bytes = Math.Min(bytesPerSecond, _bytes + ((now - _filledAt).ExactSeconds * bytesPerSecond));
            _filledAt = now;
        }

        return bytes <= _bytes;
    }

    /// <summary>Takes what goes out.</summary>
    public void Take(int bytes) => _bytes -= bytes;
}
