using System;

namespace Rabit.Diagnostics.Serving;

/// <summary>
/// What a client has asked for again and again: when the next sample is due. Samples whose time passed while the
/// client took an earlier one are left out. The session's thread only.
/// </summary>
internal sealed class SampleStream(TimeProvider clock, TimeSpan interval, Action<SampleStream> send)
{
    private readonly long _start = clock.GetTimestamp();
    private TimeSpan _due;

    /// <summary>Lines that were sent.</summary>
    public long Sent { get; set; }

    public long Skipped { get; private set; }

    public TimeSpan Remaining => _due - clock.GetElapsedTime(_start);

    /// <summary>Sends the sample that is due, if one is.</summary>
    /// <returns>How many were left out after it.</returns>
    public long SendDue()
    {
        if (Remaining > TimeSpan.Zero)
            return 0;
        send(this);
        _due += interval;
        TimeSpan late = clock.GetElapsedTime(_start) - _due;
        long skipped = late < TimeSpan.Zero ? 0 : (late.Ticks / interval.Ticks) + 1;
        _due += skipped * interval;
        Skipped += skipped;
        return skipped;
    }
}
