using System;

namespace Rabit.Mavlink.Protocols;

/// <summary>
/// Watches a time since boot: where it goes back, the system has rebooted (MAVLink guide, "Routing"). One time that
/// does not continue the others is nothing, a datagram that the network repeated or a wrong one; two that continue each
/// other are the clock.
/// </summary>
internal struct BootTime
{
    // The 32-bit milliseconds start again after 49.7 days; a jump from the last minute to the first is that and no
    // reboot.
    private const long WrapWindowMs = 60_000;

    // Messages with a time since boot may be that far between.
    private const long MaxPauseMs = 60_000;

    private long _newest;
    private long _suspect;
    private bool _isKnown;
    private bool _hasSuspect;

    /// <summary>Takes a time since boot, and returns whether it can only be that of a new boot.</summary>
    /// <param name="milliseconds">The time.</param>
    /// <param name="toleranceMs">
    /// How far it may fall back because frames overtook each other, and be ahead without a second one that is.
    /// </param>
    public bool HasRebooted(long milliseconds, long toleranceMs)
    {
        bool isWrap = IsWrap(_newest, milliseconds);
        if (!_isKnown || isWrap || Math.Abs(milliseconds - _newest) <= toleranceMs
            || IsWrap(milliseconds, _newest))
        {
            // Just after the wrap an old message, from just before it, is no progress.
            if (!_isKnown || isWrap || (milliseconds > _newest && !IsWrap(milliseconds, _newest)))
                _newest = milliseconds;
            (_isKnown, _hasSuspect) = (true, false);
            return false;
        }

        if (!_hasSuspect || milliseconds <= _suspect || milliseconds - _suspect > MaxPauseMs)
        {
            (_hasSuspect, _suspect) = (true, milliseconds);
            return false;
        }

        bool hasRebooted = milliseconds < _newest;
        (_hasSuspect, _newest) = (false, milliseconds);
        return hasRebooted;
    }

    private static bool IsWrap(long before, long after)
        => before > uint.MaxValue - WrapWindowMs && before <= uint.MaxValue && after < WrapWindowMs;
}
