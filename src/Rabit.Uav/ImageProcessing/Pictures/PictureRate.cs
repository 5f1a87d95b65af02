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

    private TimeSpan? _due;   // of the next picture; null before the first

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

        // After a gap, as before the first one, the time begins again: else the next would be taken at once.
        _due = (_due is { } due && now <= due + half ? due : now) + _period;
        return true;
    }
}
