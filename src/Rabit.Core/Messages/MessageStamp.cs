using System;

namespace Rabit.Core;

/// <summary>What a posted value is stamped with. A plain value.</summary>
public readonly struct MessageStamp
{
    internal MessageStamp(int version, TimeSpan time)
    {
        Version = version;
        Time = time;
    }

    /// <summary>
    /// Counts the posts of a message; zero means that nothing was posted yet. Newness is decided by this number and
    /// never by a clock. It wraps around after 2^32 posts: compare for equality only.
    /// </summary>
    public int Version { get; }

    /// <summary>
    /// When the value was true, by the clock of the run (<see cref="RabitManager.Now"/>): the time of the post unless
    /// the poster gave another.
    /// </summary>
    public TimeSpan Time { get; }
}
