using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>The other vehicles of a group, by their reports. One thread.</summary>
internal sealed class GroupMembers(TimeSpan silentAfter)
{
    /// <summary>More vehicles than this are not known, and their reports are counted.</summary>
    public const int MaxMembers = LaneDivision.MaxShares - 1;

    private readonly SortedDictionary<byte, (GroupReport Report, TimeSpan Time)> _reports = [];

    /// <summary>Reports that were refused.</summary>
    public long Refused { get; private set; }

    /// <summary>All that ever reported, by system id.</summary>
    public IEnumerable<(byte SystemId, GroupReport Report, TimeSpan Time)> All
        => _reports.Select(r => (r.Key, r.Value.Report, r.Value.Time));

    /// <summary>Takes a report.</summary>
    /// <param name="envelope">The report.</param>
    /// <param name="ownSystemId">Ours: another one with it is refused.</param>
    /// <param name="lanesKey">The key of our lanes: others are not of our group.</param>
    /// <param name="now">The time.</param>
    public void Receive(in Envelope<GroupReport> envelope, byte ownSystemId, uint lanesKey, TimeSpan now)
    {
        byte source = envelope.SourceSystemId;
        bool isKnown = _reports.TryGetValue(source, out (GroupReport Report, TimeSpan Time) last);
        TimeSpan time = envelope.SentTime < now ? envelope.SentTime : now;
        bool isOurs = source != 0 && source != ownSystemId && envelope.Content.LanesKey == lanesKey;
        if (!isOurs || (!isKnown && _reports.Count >= MaxMembers))
            Refused++;
        else if (!isKnown || time >= last.Time)
            _reports[source] = (envelope.Content, time);
    }

    /// <summary>Whether a vehicle is received.</summary>
    public bool IsPresent(byte systemId, TimeSpan now)
        => _reports.TryGetValue(systemId, out (GroupReport Report, TimeSpan Time) last)
            && now - last.Time <= silentAfter;

    /// <summary>The last report of a vehicle; null where there is none.</summary>
    public GroupReport? Find(byte systemId)
        => _reports.TryGetValue(systemId, out (GroupReport Report, TimeSpan Time) last) ? last.Report : null;

    /// <summary>Those that are received, in the order of their system ids.</summary>
    public IEnumerable<(byte SystemId, GroupReport Report)> Present(TimeSpan now)
        => _reports.Where(r => now - r.Value.Time <= silentAfter).Select(r => (r.Key, r.Value.Report));

    /// <summary>Forgets all: the lanes are others now.</summary>
    public void Clear() => _reports.Clear();
}
