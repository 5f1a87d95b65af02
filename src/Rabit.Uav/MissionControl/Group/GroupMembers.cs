using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The other vehicles of a group, by their reports, and those that fly another mission: nothing is shared with these,
/// but they are in the same air. One thread.
/// </summary>
internal sealed class GroupMembers(TimeSpan silentAfter)
{
    /// <summary>More vehicles than this are not known, and their reports are counted.</summary>
    public const int MaxMembers = LaneDivision.MaxShares - 1;

    // A vehicle that stands or flies has one landing place; that of another one is 10 m away or more.
    private const double SameLandingMetres = 5;

    // Of two with one system id now one, now the other is not received for a while.
    private static readonly TimeSpan TwiceMemory = TimeSpan.FromSeconds(30);

    private readonly SortedDictionary<byte, GroupTraffic> _traffic = [];
    private readonly SortedDictionary<byte, GroupTraffic> _elsewhere = [];

    // By system id: reports from elsewhere, and whether the first one was received after such a one.
    private readonly SortedDictionary<byte, (double Metres, TimeSpan Time, bool IsSure)> _twice = [];

    /// <summary>Reports that were refused.</summary>
    public long Refused { get; private set; }

    /// <summary>All that ever reported, by system id.</summary>
    public IEnumerable<(byte SystemId, GroupReport Report, TimeSpan Time)> All
        => _traffic.Select(t => (t.Key, t.Value.Report, t.Value.Time));

    /// <summary>Takes a report.</summary>
    /// <param name="envelope">The report.</param>
    /// <param name="ownSystemId">Ours: another one with it is refused.</param>
    /// <param name="lanesKey">The key of our lanes: who flies others is not of our group.</param>
    /// <param name="now">The time.</param>
    public void Receive(in Envelope<GroupReport> envelope, byte ownSystemId, uint lanesKey, TimeSpan now)
    {
        byte source = envelope.SourceSystemId;
        bool isKnown = _traffic.TryGetValue(source, out GroupTraffic? last);
        TimeSpan time = envelope.SentTime < now ? envelope.SentTime : now;
        bool isOther = source != 0 && source != ownSystemId;
        bool isOurs = isOther && envelope.Content.LanesKey == lanesKey;
        if (isOther && !isOurs)
            TakeElsewhere(source, envelope.Content, time);
        if (!isOurs || (!isKnown && _traffic.Count >= MaxMembers))
            Refused++;
        else if (last is not null && IsOfAnother(source, envelope.Content, last, now))
            Refused++;
        else
            (last ?? (_traffic[source] = new GroupTraffic())).Take(envelope.Content, time);
    }

    /// <summary>
    /// How far from the landing place of a vehicle another one lands that reports with the same system id; null where
    /// there is no such one.
    /// </summary>
    public double? FindTwice(byte systemId, TimeSpan now)
        => _twice.TryGetValue(systemId, out (double Metres, TimeSpan Time, bool IsSure) other) && other.IsSure
            && now - other.Time <= TwiceMemory
            ? other.Metres
            : null;

    /// <summary>Whether a vehicle is received.</summary>
    public bool IsPresent(byte systemId, TimeSpan now)
        => _traffic.TryGetValue(systemId, out GroupTraffic? last) && now - last.Time <= silentAfter;

    /// <summary>The last report of a vehicle; null where there is none.</summary>
    public GroupReport? Find(byte systemId)
        => _traffic.TryGetValue(systemId, out GroupTraffic? last) ? last.Report : null;

    /// <summary>Those that are received, in the order of their system ids.</summary>
    public IEnumerable<(byte SystemId, GroupReport Report)> Present(TimeSpan now)
        => Received(_traffic, now).Select(t => (t.SystemId, t.Traffic.Report));

    /// <summary>Those that are received and fly another mission: they are not of our group.</summary>
    public IEnumerable<byte> Elsewhere(TimeSpan now)
        => Received(_elsewhere, now).Select(t => t.SystemId).Where(id => !IsPresent(id, now));

    /// <summary>All that are received, also those of other missions, with how they move.</summary>
    public IEnumerable<(byte SystemId, GroupTraffic Traffic)> PresentTraffic(TimeSpan now)
        => Received(_traffic, now).Concat(Received(_elsewhere, now));

    /// <summary>Forgets all: the lanes are others now.</summary>
    public void Clear()
    {
        _traffic.Clear();
        _elsewhere.Clear();
        _twice.Clear();
    }

    private IEnumerable<(byte SystemId, GroupTraffic Traffic)> Received(
        SortedDictionary<byte, GroupTraffic> traffic, TimeSpan now)
        => traffic.Where(t => now - t.Value.Time <= silentAfter).Select(t => (t.Key, t.Value));

    private void TakeElsewhere(byte source, in GroupReport report, TimeSpan time)
    {
        if (!_elsewhere.TryGetValue(source, out GroupTraffic? last))
        {
            if (_elsewhere.Count >= MaxMembers)
                return;
            _elsewhere[source] = last = new GroupTraffic();
        }

        last.Take(report, time);
    }

    // Of two vehicles with one system id the one that was there first counts while it is received: which of them the
    // lanes and targets of that id are would otherwise change with each report. One that only moves, as a position does
    // that becomes better, is taken for another one no longer than until the old place is silent.
    private bool IsOfAnother(byte source, in GroupReport report, GroupTraffic last, TimeSpan now)
    {
        NedPosition off = LocalNedFrame.IgnoringGeoid(last.Report.LandingPlace).ToNed(report.LandingPlace);
        double metres = new PlanePoint(off.North, off.East).Length;
        bool isFromElsewhere = metres > SameLandingMetres && now - last.Time <= silentAfter;
        _twice.TryGetValue(source, out (double Metres, TimeSpan Time, bool IsSure) other);
        if (isFromElsewhere)
            _twice[source] = (metres, now, other.IsSure && now - other.Time <= TwiceMemory);
        else if (metres > SameLandingMetres)
            _twice.Remove(source);   // the old one is silent
        else if (other.Metres > 0)
            _twice[source] = other with { IsSure = now - last.Time <= silentAfter };
        return isFromElsewhere;
    }
}
