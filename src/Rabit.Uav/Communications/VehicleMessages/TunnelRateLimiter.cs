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

    /// <summary>Takes so many bytes out, if there are so many.</summary>
    public bool TryTake(int bytes, TimeSpan now)
    {
        if (now > _filledAt)
        {
            _bytes = Math.Min(bytesPerSecond, _bytes + ((now - _filledAt).TotalSeconds * bytesPerSecond));
            _filledAt = now;
        }

        if (bytes > _bytes)
            return false;
        _bytes -= bytes;
        return true;
    }
}
