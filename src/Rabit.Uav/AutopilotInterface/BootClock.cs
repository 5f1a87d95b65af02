namespace Rabit.Uav.AutopilotInterface;

/// <summary>Watches the autopilot's time since boot: where it goes down, the autopilot has begun anew (MAVLink guide, "Routing").</summary>
internal sealed class BootClock
{
    // Messages may overtake each other on their way by a second or two, never by more.
    private const uint ToleranceMs = 3_000;

    // The 32-bit milliseconds start again after 49.7 days; a jump from the last minute to the first is that and no reboot.
    private const uint WrapWindowMs = 60_000;

    private uint? _newest;

    /// <summary>Takes a time since boot, and says whether it can only come from a new boot.</summary>
    public bool HasRebooted(uint timeBootMs)
    {
        if (_newest is not { } newest || timeBootMs >= newest)
        {
            // Just after the wrap an old message, from just before it, is no progress.
            if (_newest is not { } known || !IsWrap(timeBootMs, known))
                _newest = timeBootMs;
            return false;
        }

        if (IsWrap(newest, timeBootMs))
        {
            _newest = timeBootMs;
            return false;
        }

        if (newest - timeBootMs <= ToleranceMs)
            return false;
        _newest = timeBootMs;
        return true;
    }

    private static bool IsWrap(uint before, uint after) => before > uint.MaxValue - WrapWindowMs && after < WrapWindowMs;
}
