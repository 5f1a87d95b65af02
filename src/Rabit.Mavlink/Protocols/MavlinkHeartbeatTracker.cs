using System;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Tracks which components are connected (MAVLink guide, "Heartbeat/Connection Protocol"): by their heartbeats, their
/// loss and return, and their reboots by a time since boot that goes back. No I/O, no clock. One thread; nothing is
/// allocated per frame.
/// </summary>
/// <example>
/// <code>
/// var tracker = new MavlinkHeartbeatTracker();
///
/// // For every checked frame: tracker.Handle(frame, now). After that, and at tracker.NextDue at the latest:
/// static void Report(MavlinkHeartbeatTracker tracker, TimeSpan now)
/// {
///     while (tracker.TryTakeEvent(now, out MavlinkComponentEvent happened, out MavlinkComponent component))
///         Console.WriteLine($"{component.Address}: {happened}");
/// }
/// </code>
/// </example>
/// <remarks>
/// The time since boot is that of SYSTEM_TIME, ATTITUDE, ATTITUDE_QUATERNION, LOCAL_POSITION_NED and
/// GLOBAL_POSITION_INT. It may fall back by <see cref="ReorderTolerance"/>, since frames overtake each other, and wraps
/// to zero after 49.7 days; neither is a reboot, nor is one message that does not continue the others, before or ahead:
/// it takes a second one that continues it. So a reboot within the first seconds after another is not detected.
/// </remarks>
public sealed class MavlinkHeartbeatTracker
{
    /// <summary>How long without a heartbeat a component counts as lost: five heartbeats at 1 Hz.</summary>
    public static readonly TimeSpan DefaultLossTimeout = TimeSpan.FromSeconds(5);

    /// <summary>How far the time since boot may fall back without a reboot.</summary>
    public static readonly TimeSpan ReorderTolerance = TimeSpan.OfMilliseconds(ReorderToleranceMs);

    private const uint ReorderToleranceMs = 3000;
    private const long NanosecondsPerMillisecond = 1_000_000;

    private readonly Entry[] _entries;
    private readonly TimeSpan _lossTimeout;

    /// <summary>Makes a tracker.</summary>
    /// <param name="capacity">
    /// How many components it holds; the heartbeats of others are counted in <see cref="Overflow"/>.
    /// </param>
    /// <param name="lossTimeout">
    /// How long without a heartbeat a component counts as lost; null for <see cref="DefaultLossTimeout"/>.
    /// </param>
    /// <exception cref="ArgumentOutOfRangeException">The capacity is below 1.</exception>
    public MavlinkHeartbeatTracker(int capacity = 64, TimeSpan? lossTimeout = null)
    {
        if (capacity < 1)
            throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "The capacity is at min 1.");
        _entries = new Entry[capacity];
        _lossTimeout = lossTimeout ?? DefaultLossTimeout;
    }

    /// <summary>How many components are known; lost ones stay.</summary>
    public int Count { get; private set; }

    /// <summary>Heartbeats of components that there was no room for.</summary>
    public long Overflow { get; private set; }

    /// <summary>One component, in the order of their first heartbeats.</summary>
    /// <param name="index">0 to <see cref="Count"/> - 1.</param>
    /// <returns>The component.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such component.</exception>
    public MavlinkComponent this[int index] => (uint)index < (uint)Count
        ? _entries[index].Value
        : throw new ArgumentOutOfRangeException(nameof(index), index, $"{Count} components are known.");

    /// <summary>
    /// When to call <see cref="TryTakeEvent"/> at the latest, unless a frame comes before;
    /// <see cref="TimeSpan.MaxValue"/> while none can be lost.
    /// </summary>
    public TimeSpan NextDue
    {
        get
        {
            TimeSpan next = TimeSpan.MaxValue;
            for (int i = 0; i < Count; i++)
            {
                if (!_entries[i].Value.IsLost && _entries[i].Value.LastAt + _lossTimeout < next)
                    next = _entries[i].Value.LastAt + _lossTimeout;
            }

            return next;
        }
    }

    /// <summary>Handles a received frame.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, TimeSpan now)
    {
        if (frame.TryDecode(out Heartbeat heartbeat))
            HandleHeartbeat(frame, heartbeat, now);
        else if (TryGetBootTime(frame, out uint milliseconds))
            HandleBootTime(frame, milliseconds);
        else if (frame.TryDecode(out Timesync time) && time.Tc1 > 0)
            HandleClock(frame, time.Tc1);
    }

    /// <summary>Takes a heartbeat that came in, where its frame was decoded before.</summary>
    /// <param name="frame">The frame, checked by the reader.</param>
    /// <param name="heartbeat">Its message.</param>
    /// <param name="now">The time, by a clock that never goes back.</param>
    public void Handle(in MavlinkFrame frame, in Heartbeat heartbeat, TimeSpan now)
        => HandleHeartbeat(frame, heartbeat, now);

    /// <summary>Takes the next event. Call it until there is none, after frames and at <see cref="NextDue"/>.</summary>
    /// <param name="now">The time.</param>
    /// <param name="happened">The event.</param>
    /// <param name="component">The component, in its present state.</param>
    /// <returns>Whether there is one.</returns>
    public bool TryTakeEvent(TimeSpan now, out MavlinkComponentEvent happened, out MavlinkComponent component)
    {
        for (int i = 0; i < Count; i++)
        {
            ref Entry entry = ref _entries[i];
            if (!entry.Value.IsLost && now >= entry.Value.LastAt + _lossTimeout)
            {
                entry.Value = entry.Value with { IsLost = true };
                entry.Open |= 1 << (int)MavlinkComponentEvent.Lost;
            }

            for (int bit = 0; entry.Open != 0 && bit <= (int)MavlinkComponentEvent.Rebooted; bit++)
            {
                if ((entry.Open & (1 << bit)) == 0)
                    continue;
                entry.Open &= ~(1 << bit);
                happened = (MavlinkComponentEvent)bit;
                component = entry.Value;
                return true;
            }
        }

        happened = default;
        component = default;
        return false;
    }

    private static bool TryGetBootTime(in MavlinkFrame frame, out uint milliseconds)
    {
        // In SYSTEM_TIME it is behind the 64-bit time, in the others in front.
        int offset = frame.MessageId switch
        {
            SystemTime.MavlinkId => sizeof(ulong),
            Attitude.MavlinkId or AttitudeQuaternion.MavlinkId or LocalPositionNed.MavlinkId
                or GlobalPositionInt.MavlinkId =>
                0,
            _ => -1,
        };
        milliseconds = 0;
        if (offset < 0)
            return false;
        for (int i = 0; i < sizeof(uint); i++)
            milliseconds |= (uint)frame.PayloadByte(offset + i) << (8 * i);
        return milliseconds != 0;
    }

    private void HandleHeartbeat(in MavlinkFrame frame, in Heartbeat heartbeat, TimeSpan now)
    {
        int index = IndexOf(frame);
        if (index < 0)
        {
            if (Count == _entries.Length)
            {
                Overflow++;
                return;
            }

            _entries[Count++] = new Entry
            {
                Value = new MavlinkComponent(
                    new MavlinkAddress(frame.SystemId, frame.ComponentId), heartbeat, now, now, 1, IsLost: false,
                    Reboots: 0),
                Open = 1 << (int)MavlinkComponentEvent.Appeared,
            };
            return;
        }

        ref Entry entry = ref _entries[index];

        // Lost since the last call of TryTakeEvent: the loss is still reported.
        if (!entry.Value.IsLost && now >= entry.Value.LastAt + _lossTimeout)
        {
            entry.Value = entry.Value with { IsLost = true };
            entry.Open |= 1 << (int)MavlinkComponentEvent.Lost;
        }

        if (entry.Value.IsLost)
            entry.Open |= 1 << (int)MavlinkComponentEvent.Returned;
        entry.Value = entry.Value with
        {
            Heartbeat = heartbeat,
            LastAt = now,
            Heartbeats = entry.Value.Heartbeats + 1,
            IsLost = false
        };
    }

    private void HandleBootTime(in MavlinkFrame frame, uint milliseconds)
    {
        int index = IndexOf(frame);
        if (index < 0)
            return;
        ref Entry entry = ref _entries[index];
        if (!entry.BootTime.HasRebooted(milliseconds, ReorderToleranceMs))
            return;
        CountReboot(ref entry);
        entry.Clock = default;
    }

    // The clock of a TIMESYNC answer starts with the boot, on autopilots; messages with a boot time may be far between.
    private void HandleClock(in MavlinkFrame frame, long nanoseconds)
    {
        int index = IndexOf(frame);
        if (index < 0)
            return;
        ref Entry entry = ref _entries[index];
        if (!entry.Clock.HasRebooted(nanoseconds / NanosecondsPerMillisecond, ReorderToleranceMs))
            return;
        CountReboot(ref entry);
        entry.BootTime = default;
    }

    private static void CountReboot(ref Entry entry)
    {
        entry.Value = entry.Value with { Reboots = entry.Value.Reboots + 1 };
        entry.Open |= 1 << (int)MavlinkComponentEvent.Rebooted;
    }

    private int IndexOf(in MavlinkFrame frame)
    {
        for (int i = 0; i < Count; i++)
        {
            if (_entries[i].Value.Address.SystemId == frame.SystemId
                && _entries[i].Value.Address.ComponentId == frame.ComponentId)
                return i;
        }

        return -1;
    }

    private struct Entry
    {
        public MavlinkComponent Value;
        public BootTime BootTime;
        public BootTime Clock;
        public int Open;
    }
}
