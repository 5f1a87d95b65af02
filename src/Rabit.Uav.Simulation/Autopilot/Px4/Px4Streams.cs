using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Which messages are sent over a link by themselves, and how often. A message that could not be sent when it was due
/// goes out as soon as it can. Nothing goes out faster than one message of a kind in a step.
/// </summary>
internal sealed class Px4Streams
{
    // PX4 sends these, the simulation does not: an interval for them is accepted and nothing comes of it.
    private static readonly int[] NotSimulated =
        [4, 8, 29, 31, 36, 49, 69, 83, 105, 132, 241, 331, 340, 360, 380, 12901, 12904];

    // What the onboard link streams without a request, Hz. PX4 sends much faster; this leaves telemetry that nothing
    // asks for at what is of use.
    private static readonly (int MessageId, double Hertz)[] Defaults =
    [
        (SysStatus.MavlinkId, 1), (GpsRawInt.MavlinkId, 1), (Attitude.MavlinkId, 10), (LocalPositionNed.MavlinkId, 5),
        (GlobalPositionInt.MavlinkId, 10), (VfrHud.MavlinkId, 4), (PositionTargetLocalNed.MavlinkId, 2),
        (PositionTargetGlobalInt.MavlinkId, 2), (Altitude.MavlinkId, 1), (BatteryStatus.MavlinkId, 0.5),
        (EstimatorStatus.MavlinkId, 0.5), (HomePosition.MavlinkId, 0.5), (ExtendedSysState.MavlinkId, 1),
        (SystemTime.MavlinkId, 1), (Timesync.MavlinkId, 1),
    ];

    private readonly List<Entry> _entries = [];

    public Px4Streams()
    {
        foreach ((int messageId, double hertz) in Defaults)
            _entries.Add(new Entry(messageId, TimeSpan.OfSeconds(1 / hertz)));
    }

    /// <summary>SET_MESSAGE_INTERVAL: -1 switches off, 0 is the default.</summary>
    public MavResult Set(int messageId, double intervalMicroseconds, TimeSpan now)
    {
        if (Array.IndexOf(NotSimulated, messageId) >= 0)
            return MavResult.Accepted;
        if (messageId == Heartbeat.MavlinkId || !Px4Telemetry.IsKnown(messageId) || double.IsNaN(intervalMicroseconds))
            return MavResult.Failed;
        _entries.RemoveAll(e => e.MessageId == messageId);
        if (intervalMicroseconds < 0)
            return MavResult.Accepted;
        TimeSpan interval = intervalMicroseconds > 0
            ? TimeSpan.OfMilliseconds(Math.Min(intervalMicroseconds / 1000, 60_000))
            : DefaultOf(messageId);
        if (interval > TimeSpan.Zero)
            _entries.Add(new Entry(messageId, interval) { Due = now });
        return MavResult.Accepted;
    }

    /// <summary>Microseconds; -1 where it is not sent.</summary>
    public int IntervalOf(int messageId)
    {
        Entry? entry = _entries.Find(e => e.MessageId == messageId);
        return entry is null ? -1 : (int)(entry.Interval.Ticks / 10);
    }

    /// <summary>Sends what is due.</summary>
    public void Send(TimeSpan now, int link, Px4Telemetry telemetry)
    {
        foreach (Entry entry in _entries)
        {
            if (entry.Due > now || !telemetry.TrySend(entry.MessageId, link))
                continue;
            entry.Due = entry.Due + entry.Interval > now ? entry.Due + entry.Interval : now + entry.Interval;
        }
    }

    private static TimeSpan DefaultOf(int messageId)
    {
        foreach ((int id, double hertz) in Defaults)
        {
            if (id == messageId)
                return TimeSpan.OfSeconds(1 / hertz);
        }

        return TimeSpan.Zero;
    }

    private sealed class Entry(int messageId, TimeSpan interval)
    {
        public int MessageId { get; } = messageId;

        public TimeSpan Interval { get; } = interval;

        public TimeSpan Due { get; set; }
    }
}
