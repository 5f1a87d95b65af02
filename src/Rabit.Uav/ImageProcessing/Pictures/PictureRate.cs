using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Which pictures of a camera are taken where it gives more than are wanted: as many, in the mean, and none lost of a
/// camera that gives just as many with some jitter. One thread.
/// </summary>
internal sealed class PictureRate(double? framesPerSecond)
{
    // By ticks: some runtimes make whole milliseconds of a number of seconds.
    private readonly TimeSpan _period = framesPerSecond is { } rate
        ? TimeSpan.FromTicks((long)(TimeSpan.TicksPerSecond / rate))
        : TimeSpan.Zero;

    private TimeSpan _due;

    public bool IsLimited => _period > TimeSpan.Zero;

    /// <summary>Whether a picture is taken.</summary>
    /// <param name="now">When it came.</param>
    public bool Takes(TimeSpan now)
    {
        if (!IsLimited)
            return true;
        var half = TimeSpan.FromTicks(_period.Ticks / 2);
        if (now < _due - half)
            return false;
        _due = _due + _period > now + half ? _due + _period : now + half;
        return true;
    }
}
