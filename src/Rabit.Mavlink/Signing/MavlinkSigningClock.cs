using System;
using Rabit.Mavlink.Signing;

namespace Rabit.Mavlink;

/// <summary>
/// The time that signatures carry: tens of microseconds since 2015-01-01 UTC (MAVLink guide, "Message signing"). It
/// never goes back and never gives a value twice, although wall clocks step and computers restart. One clock per
/// process and key, shared by all its signers and its verifier; it has no time of its own: <see cref="Advance"/> it
/// once per cycle. One thread at a time.
/// </summary>
/// <remarks>
/// A wall clock that is ahead is followed at once. One that is behind, because it was set back or a computer without a
/// clock has just started, is waited for: until it has caught up, the signing clock continues at half its speed.
/// </remarks>
public sealed class MavlinkSigningClock
{
    /// <summary>How many steps of the clock a second has.</summary>
    public const int TicksPerSecond = 100_000;

    private const int TimeSpanTicksPerTick = (int)(TimeSpan.TicksPerSecond / TicksPerSecond);

    // What is stored is not the present but a time that will not be passed before the next is stored. So a restart may
    // begin there, whenever the power failed. Stored 10 s before it is reached: every 30 s.
    private const long ReservedTicks = 40 * TicksPerSecond;
    private const long RenewBeforeTicks = 10 * TicksPerSecond;

    // After a write that failed.
    private const long RetryTicks = 1 * TicksPerSecond;

    private static readonly DateTime Epoch = new(2015, 1, 1, 0, 0, 0, DateTimeKind.Utc);

    private readonly TimestampSlots? _slots;
    private bool _isSet;
    private TimeSpan _elapsed;

    // In the 0.1 µs of TimeSpan, so that half a step is not lost.
    private long _steady;

    // The newest time stamp used by us or accepted from others.
    private long _last;
    private long _saveAt;

    /// <summary>
    /// Makes a clock that nothing is stored of: for a computer whose wall clock can be relied on, and for tests.
    /// </summary>
    /// <param name="earliest">It does not give a time stamp before this one.</param>
    /// <exception cref="ArgumentOutOfRangeException">Not a number of 48 bits.</exception>
    public MavlinkSigningClock(long earliest = 0)
    {
        if (earliest is < 0 or > SignatureFormat.MaxTimestamp)
            throw new ArgumentOutOfRangeException(
                nameof(earliest), earliest, $"A time stamp is 0 to {SignatureFormat.MaxTimestamp}.");
        Start(earliest);
    }

    /// <summary>Makes a clock that continues from what was stored.</summary>
    /// <param name="store">Read here, written by <see cref="Advance"/> and <see cref="Save"/>.</param>
    /// <exception cref="ArgumentNullException">No store.</exception>
    public MavlinkSigningClock(IMavlinkTimestampStore store)
    {
        _slots = new TimestampSlots(store ?? throw new ArgumentNullException(nameof(store)));
        Start(_slots.Newest);
    }

    /// <summary>The present, as far as this clock knows: what the next signature will carry at least.</summary>
    public long Timestamp => Math.Max(_steady / TimeSpanTicksPerTick, _last);

    /// <summary>How often the store did not take what it was given. While it does not, a restart may go back.</summary>
    public long FailedSaves { get; private set; }

    /// <summary>The time stamp of a time; before 2015 it is 0.</summary>
    /// <param name="utc">In UTC.</param>
    /// <returns>Tens of microseconds since 2015-01-01.</returns>
    public static long ToTimestamp(DateTime utc) => WallOf(utc) / TimeSpanTicksPerTick;

    /// <summary>The time of a time stamp.</summary>
    /// <param name="timestamp">Tens of microseconds since 2015-01-01 UTC, 48 bits.</param>
    /// <returns>In UTC.</returns>
    public static DateTime ToUtc(long timestamp) => Epoch.AddTicks(timestamp * TimeSpanTicksPerTick);

    /// <summary>Advances the clock to the present time. Stores its state where that is due, about every 30 s.</summary>
    /// <param name="utcNow">The wall clock, in UTC. It may step.</param>
    /// <param name="elapsed">Time since any fixed moment, from a clock that does not step.</param>
    /// <exception cref="ArgumentException">The time is local.</exception>
    public void Advance(DateTime utcNow, TimeSpan elapsed)
    {
        if (utcNow.Kind == DateTimeKind.Local)
            throw new ArgumentException("Signing time is UTC; the time given is local.", nameof(utcNow));
        long passed = _isSet ? Math.Max(0, (elapsed - _elapsed).Ticks) : 0;
        _isSet = true;
        _elapsed = elapsed;
        _steady = Math.Max(WallOf(utcNow), Math.Min(_steady + (passed / 2), MaxSteady));
        if (_slots is not null && Timestamp >= _saveAt)
            Store(Timestamp + ReservedTicks, Timestamp + ReservedTicks - RenewBeforeTicks);
    }

    /// <summary>
    /// Stores the exact state of the clock. For an orderly shutdown; after it, a restart begins here and not up to 40 s
    /// ahead.
    /// </summary>
    /// <returns>Whether it was stored; false also where there is no store.</returns>
    public bool Save() => _slots is not null && Store(Timestamp + 1, Timestamp);

    /// <summary>A time stamp for a frame of ours: later than all before it.</summary>
    /// <exception cref="InvalidOperationException">
    /// The clock was never advanced, or has reached the end of its 48 bits.
    /// </exception>
    internal long Next()
    {
        if (!_isSet)
            throw new InvalidOperationException("The signing clock was not set yet: call Advance first.");
        if (_last >= SignatureFormat.MaxTimestamp)
            throw new InvalidOperationException(
                "The signing clock has reached its end: no later time stamp fits into 48 bits.");
        return _last = Math.Max(_last + 1, _steady / TimeSpanTicksPerTick);
    }

    /// <summary>Takes note of the time stamp of a frame whose signature is right.</summary>
    internal void Accept(long timestamp) => _last = Math.Max(_last, timestamp);

    private static long MaxSteady => SignatureFormat.MaxTimestamp * TimeSpanTicksPerTick;

    private static long WallOf(DateTime utc) => Math.Min(Math.Max((utc - Epoch).Ticks, 0), MaxSteady);

    private void Start(long earliest)
    {
        _steady = earliest * TimeSpanTicksPerTick;
        _last = earliest - 1;
    }

    private bool Store(long timestamp, long saveAt)
    {
        bool isStored = _slots!.TryWrite(Math.Min(timestamp, SignatureFormat.MaxTimestamp));
        _saveAt = isStored ? saveAt : Timestamp + RetryTicks;
        if (!isStored)
            FailedSaves++;
        return isStored;
    }
}
