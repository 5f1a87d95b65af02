namespace Rabit.Mavlink.Protocols;

/// <summary>
/// Watches a time since boot: where it goes back, the system has rebooted (MAVLink guide, "Routing").
/// </summary>
internal struct BootTime
{
    // The 32-bit milliseconds start again after 49.7 days; a jump from the last minute to the first is that and no
    // reboot.
    private const uint WrapWindowMs = 60_000;

    private uint _newest;
    private bool _isKnown;

    /// <summary>Takes a time since boot, and returns whether it can only be that of a new boot.</summary>
    /// <param name="milliseconds">The time.</param>
    /// <param name="toleranceMs">How far it may fall back because frames overtook each other.</param>
    public bool HasRebooted(uint milliseconds, uint toleranceMs)
    {
        if (!_isKnown || milliseconds >= _newest)
        {
            // Just after the wrap an old message, from just before it, is no progress.
            if (!_isKnown || !IsWrap(milliseconds, _newest))
                _newest = milliseconds;
            _isKnown = true;
            return false;
        }

        bool isWrap = IsWrap(_newest, milliseconds);
        if (!isWrap && _newest - milliseconds <= toleranceMs)
            return false;
        _newest = milliseconds;
        return !isWrap;
    }

    private static bool IsWrap(uint before, uint after)
        => before > uint.MaxValue - WrapWindowMs && after < WrapWindowMs;
}
