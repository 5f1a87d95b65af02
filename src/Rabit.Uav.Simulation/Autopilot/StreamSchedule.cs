using System;
using System.Collections.Generic;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Which messages are sent by themselves, and how often: none, until requested. Nothing goes out faster than one
/// message of a kind in a step.
/// </summary>
internal sealed class StreamSchedule
{
    // ArduPilot's loop runs at 400 Hz and no stream may ask for more than 0.8 of that (see DENIED in the results of
    // 511).
    private const double MaxHertz = 320;
    private const int MaxMilliseconds = 60_000;

    private static readonly int[] ExtendedStatus =
        [SysStatus.MavlinkId, GpsRawInt.MavlinkId, MissionCurrent.MavlinkId, FenceStatus.MavlinkId];
    private static readonly int[] Channels = [RcChannels.MavlinkId];
    private static readonly int[] Position = [GlobalPositionInt.MavlinkId, LocalPositionNed.MavlinkId];
    private static readonly int[] Extra1 = [Attitude.MavlinkId];
    private static readonly int[] Extra2 = [VfrHud.MavlinkId];
    private static readonly int[] Extra3 =
    [
        SystemTime.MavlinkId, BatteryStatus.MavlinkId, ExtendedSysState.MavlinkId, Wind.MavlinkId,
        EkfStatusReport.MavlinkId,
    ];

    private readonly List<Entry> _entries = [];

    /// <summary>SET_MESSAGE_INTERVAL: -1 switches off, 0 is the default, which is off here.</summary>
    public MavResult Set(int messageId, double intervalMicroseconds, TimeSpan now)
    {
        if (!TelemetrySender.IsKnown(messageId) || double.IsNaN(intervalMicroseconds) || intervalMicroseconds < -1)
            return MavResult.Denied;
        if (intervalMicroseconds <= 0)
        {
            Remove(messageId);
            return MavResult.Accepted;
        }

        if (intervalMicroseconds < 1e6 / MaxHertz)
            return MavResult.Denied;

        // It counts in whole milliseconds.
        int milliseconds = (int)Math.Min(intervalMicroseconds / 1000, MaxMilliseconds);
        Put(messageId, TimeSpan.OfMilliseconds(milliseconds), now);
        return MavResult.Accepted;
    }

    /// <summary>REQUEST_DATA_STREAM, the older way: groups of messages.</summary>
    public void SetGroup(MavDataStream group, int hertz, TimeSpan now)
    {
        foreach (int messageId in Group(group))
        {
            if (hertz > 0)
                Put(messageId, TimeSpan.OfMilliseconds(1000 / hertz), now);
            else
                Remove(messageId);
        }
    }

    /// <summary>Microseconds; 0 where it is not sent.</summary>
    public int IntervalOf(int messageId)
    {
        Entry? entry = _entries.Find(e => e.MessageId == messageId);
        return entry is null ? 0 : (int)(entry.Interval.Ticks / 10);
    }

    /// <summary>Sends what is due.</summary>
    public void Send(TimeSpan now, Action<int> send)
    {
        foreach (Entry entry in _entries)
        {
            if (entry.Due > now)
                continue;
            send(entry.MessageId);
            entry.Due = entry.Due + entry.Interval > now ? entry.Due + entry.Interval : now + entry.Interval;
        }
    }

    private static int[] Group(MavDataStream group)
    {
        switch (group)
        {
            case MavDataStream.ExtendedStatus: return ExtendedStatus;
            case MavDataStream.RcChannels: return Channels;
            case MavDataStream.Position: return Position;
            case MavDataStream.Extra1: return Extra1;
            case MavDataStream.Extra2: return Extra2;
            case MavDataStream.Extra3: return Extra3;
            case MavDataStream.All:
                return [.. ExtendedStatus, .. Channels, .. Position, .. Extra1, .. Extra2, .. Extra3];
            default: return [];
        }
    }

    private void Put(int messageId, TimeSpan interval, TimeSpan now)
    {
        Entry? entry = _entries.Find(e => e.MessageId == messageId);
        if (entry is null)
            _entries.Add(entry = new Entry(messageId));
        entry.Interval = interval;
        entry.Due = now;
    }

    private void Remove(int messageId) => _entries.RemoveAll(e => e.MessageId == messageId);

    private sealed class Entry(int messageId)
    {
        public int MessageId { get; } = messageId;

        public TimeSpan Interval { get; set; }

        public TimeSpan Due { get; set; }
    }
}
