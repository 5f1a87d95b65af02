using System;
using Rabit.Mavlink.Routing;

namespace Rabit.Mavlink;

/// <summary>
/// Recognises a frame that came in a moment ago already: over a loop in the network, or over a second link. By content:
/// sender, sequence number, message id, payload and checksum, not the signature, which differs by link. A command that
/// is repeated and telemetry that says the same again have another sequence number, and are none. Fixed memory;
/// allocates nothing after it was made; one thread at a time.
/// </summary>
/// <remarks>
/// Sequence numbers come again after 256 frames: what is the same after 128 frames or more of its sender is a new one.
/// The table keeps 4096 frames in sets of four; where more come within the window the oldest of a set is forgotten, so
/// that a copy may pass. The content is compared by a hash of 64 bits: two different frames within the window are taken
/// for one with a probability below 1e-15, unless they were made so on purpose; where that matters links are signed.
/// </remarks>
/// <example>
/// <code>
/// var duplicates = new MavlinkDuplicateFilter();
/// MavlinkFrame frame = MavlinkFrame.Create(new Heartbeat(), systemId: 1, componentId: 1, sequence: 0);
/// bool isFirst = !duplicates.IsDuplicate(frame, TimeSpan.FromSeconds(10));
/// bool isCopy = duplicates.IsDuplicate(frame, TimeSpan.FromSeconds(10.1));
/// </code>
/// </example>
public sealed class MavlinkDuplicateFilter
{
    /// <summary>How long a frame is recognised, if nothing else is asked for.</summary>
    public static readonly TimeSpan DefaultWindow = TimeSpan.FromMilliseconds(500);

    private const int Sets = 1024;
    private const int Ways = 4;

    // Half of the circle of sequence numbers.
    private const ushort MaxFramesBetween = 128;

    private readonly TimeSpan _window;
    private readonly Entry[] _entries = new Entry[Sets * Ways];

    // Frames of each sender (system, component) so far, without duplicates; wraps round.
    private readonly ushort[] _framesOfSender = new ushort[0x10000];

    /// <summary>Makes a filter that knows no frame.</summary>
    /// <param name="window">How long a frame is recognised; null for <see cref="DefaultWindow"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">The window is not above zero.</exception>
    public MavlinkDuplicateFilter(TimeSpan? window = null)
    {
        _window = window ?? DefaultWindow;
        if (_window <= TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(window), window, "The window must be above zero.");
    }

    /// <summary>Duplicates so far.</summary>
    public long Duplicates { get; private set; }

    /// <summary>Returns whether the same frame came within the window; one that did not is remembered.</summary>
    /// <param name="frame">A frame that came in, in the order of arrival.</param>
    /// <param name="now">The time, by any clock that never goes back.</param>
    public bool IsDuplicate(in MavlinkFrame frame, TimeSpan now)
    {
        int sender = (frame.SystemId << 8) | frame.ComponentId;
        ulong hash = FrameHash.Of(frame);
        if (Find(hash, sender, now))
        {
            Duplicates++;
            return true;
        }

        Remember(hash, sender, now);
        return false;
    }

    /// <summary>Whether a frame came, or was remembered, within the window. Changes nothing.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="now">The time.</param>
    public bool Contains(in MavlinkFrame frame, TimeSpan now)
        => Find(FrameHash.Of(frame), (frame.SystemId << 8) | frame.ComponentId, now);

    /// <summary>Remembers a frame that is sent, so that its echo is recognised.</summary>
    /// <param name="frame">The frame, as it is sent.</param>
    /// <param name="now">The time.</param>
    public void Remember(in MavlinkFrame frame, TimeSpan now)
        => Remember(FrameHash.Of(frame), (frame.SystemId << 8) | frame.ComponentId, now);

    private bool Find(ulong hash, int sender, TimeSpan now)
    {
        foreach (ref readonly Entry entry in SetOf(hash))
        {
            if (entry.IsUsed && entry.Hash == hash && now - entry.Time <= _window)
                return (ushort)(_framesOfSender[sender] - entry.FramesOfSender) < MaxFramesBetween;
        }

        return false;
    }

    private void Remember(ulong hash, int sender, TimeSpan now)
    {
        Span<Entry> set = SetOf(hash);
        int oldest = 0;
        for (int way = 0; way < set.Length; way++)
        {
            if (!set[way].IsUsed || set[way].Hash == hash)
            {
                oldest = way;
                break;
            }

            if (set[way].Time < set[oldest].Time)
                oldest = way;
        }

        set[oldest] = new Entry
        {
            IsUsed = true,
            Hash = hash,
            Time = now,
            FramesOfSender = ++_framesOfSender[sender],
        };
    }

    private Span<Entry> SetOf(ulong hash) => _entries.AsSpan((int)(hash >> 54) * Ways, Ways);

    private struct Entry
    {
        public ulong Hash;
        public TimeSpan Time;
        public ushort FramesOfSender;
        public bool IsUsed;
    }
}
