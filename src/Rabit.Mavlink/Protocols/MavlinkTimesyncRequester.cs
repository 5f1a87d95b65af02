using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>
/// Requests the autopilot's time, five times a second for two seconds and once a second from then on, and recognises
/// its own requests in the answers (MAVLink guide, "Time Synchronization Protocol v2"). A state machine: time comes in,
/// requests go out.
/// </summary>
public sealed class MavlinkTimesyncRequester
{
    /// <summary>How often in the beginning.</summary>
    public static readonly TimeSpan FastPeriod = TimeSpan.FromMilliseconds(200);

    /// <summary>How often later.</summary>
    public static readonly TimeSpan SlowPeriod = TimeSpan.FromSeconds(1);

    private static readonly TimeSpan FastFor = TimeSpan.FromSeconds(2);
    private const int NanosecondsPerTick = 100;

    // At the fast rate more than the longest round trip that is of any use.
    private const int Remembered = 32;

    private readonly long[] _open = new long[Remembered];
    private int _next;
    private TimeSpan _startedAt;
    private TimeSpan _due;

    /// <summary>Whether it sends requests.</summary>
    public bool IsStarted { get; private set; }

    /// <summary>Whether it sends requests at the fast rate, because the answers are still few.</summary>
    /// <param name="now">The time.</param>
    /// <returns>Whether it does.</returns>
    public bool IsFast(TimeSpan now) => IsStarted && now - _startedAt < FastFor;

    /// <summary>
    /// When to call <see cref="TryNext"/> again; <see cref="TimeSpan.MaxValue"/> while it is stopped.
    /// </summary>
    public TimeSpan NextDue => IsStarted ? _due : TimeSpan.MaxValue;

    /// <summary>
    /// Requests at the fast rate again, from now on; open requests stay open. Does nothing while it is stopped.
    /// </summary>
    /// <param name="now">The time.</param>
    public void Hasten(TimeSpan now)
    {
        if (!IsStarted)
            return;
        _startedAt = now;
        if (_due > now + FastPeriod)
            _due = now + FastPeriod;
    }

    /// <summary>Starts, or starts over: open requests are discarded.</summary>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Start(TimeSpan now)
    {
        IsStarted = true;
        _startedAt = now;
        _due = now;
        Array.Clear(_open, 0, _open.Length);
    }

    /// <summary>Sends no requests until the next start.</summary>
    public void Stop() => IsStarted = false;

    /// <summary>Returns the request to send now, if any; the caller fills in the target.</summary>
    /// <param name="now">The time.</param>
    /// <param name="request">The request; it has our time.</param>
    /// <returns>Whether to send it.</returns>
    public bool TryNext(TimeSpan now, out Timesync request)
    {
        request = default;
        if (!IsStarted || now < _due)
            return false;

        // On a grid, so that late calls do not slow it down; missed requests are not made up for.
        TimeSpan period = IsFast(now) ? FastPeriod : SlowPeriod;
        _due += period;
        if (_due <= now)
            _due = now + period;

        request.Ts1 = NanosecondsOf(now);
        _open[_next] = request.Ts1;
        _next = (_next + 1) % Remembered;
        return true;
    }

    /// <summary>
    /// Whether a TIMESYNC answers a request of ours that is still open, and when that was made. True once for each.
    /// </summary>
    /// <param name="message">The received message.</param>
    /// <param name="askedAt">When the request was sent, by our clock.</param>
    /// <returns>Whether it answers one of our requests.</returns>
    public bool IsAnswer(in Timesync message, out TimeSpan askedAt)
    {
        askedAt = TimeSpan.Zero;
        if (message.Tc1 == 0)
            return false;
        for (int i = 0; i < Remembered; i++)
        {
            if (_open[i] == 0 || _open[i] != message.Ts1)
                continue;
            _open[i] = 0;
            askedAt = new TimeSpan((message.Ts1 - 1) / NanosecondsPerTick);
            return true;
        }

        return false;
    }

    // Never zero, which marks a free slot.
    private static long NanosecondsOf(TimeSpan time) => (time.Ticks * NanosecondsPerTick) + 1;
}
