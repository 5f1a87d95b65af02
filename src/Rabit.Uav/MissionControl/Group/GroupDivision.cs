using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Who flies which lanes. The author is the vehicle with the lowest system id among those that search and are received,
/// and every vehicle works that out for itself: where the radio separates the group, each part has an author of its
/// own, and where they meet again the lower one's division holds. The author divides again when vehicles come, go or
/// are done, or when the energy of one is too little for its lanes, and repeats its division, so that a lost one is
/// repaired. One thread.
/// </summary>
internal sealed class GroupDivision
{
    // Others that are there already are received by then.
    private static readonly TimeSpan FirstAfter = TimeSpan.OfSeconds(2.5);

    private static readonly TimeSpan RepeatPeriod = TimeSpan.FromSeconds(2);

    // Not oftener, where only the balance asks for it.
    private static readonly TimeSpan BalancePeriod = TimeSpan.FromSeconds(10);

    // Nor oftener, where it is the energy: what a vehicle has left of its lanes is known when its lane is flown.
    private static readonly TimeSpan EnergyPeriod = TimeSpan.FromSeconds(30);

    // A vehicle without lanes gets some where another one has more than this to fly.
    private const double MinBalanceSeconds = 45;

    private TimeSpan? _begun;
    private TimeSpan _made;
    private TimeSpan? _askedForEnergy;
    private TimeSpan _sent;

    /// <summary>Its author; 0 where there is none yet.</summary>
    public byte Author { get; private set; }

    public ushort Number { get; private set; }

    public ImmutableArray<LaneShare> Shares { get; private set; } = [];

    /// <summary>How often it has changed.</summary>
    public int Changes { get; private set; }

    /// <summary>Divisions of others that were refused.</summary>
    public long Refused { get; private set; }

    /// <summary>The share of a vehicle; none of the lanes where it has none.</summary>
    public LaneShare ShareOf(byte systemId) => Shares.FirstOrDefault(s => s.SystemId == systemId);

    /// <summary>Forgets all: the lanes are others now.</summary>
    public void Clear() => (Author, Shares, _begun) = (0, [], null);

    /// <summary>Who divides, as we see it; 0 for none.</summary>
    /// <param name="own">Our own report.</param>
    /// <param name="ownSystemId">Our system id.</param>
    /// <param name="present">The others that are received.</param>
    public static byte AuthorOf(
        in GroupReport own, byte ownSystemId, IEnumerable<(byte SystemId, GroupReport Report)> present)
    {
        byte author = own.State == GroupMemberState.Available ? ownSystemId : (byte)0;
        foreach ((byte id, GroupReport report) in present)
        {
            if (report.State == GroupMemberState.Available && (author == 0 || id < author))
                author = id;
        }

        return author;
    }

    /// <summary>Takes the division of another vehicle.</summary>
    /// <param name="source">Its system id.</param>
    /// <param name="division">Of our lanes.</param>
    /// <param name="ownSystemId">Ours.</param>
    /// <param name="author">The author as we see it.</param>
    /// <param name="lanes">How many lanes there are.</param>
    public void Receive(byte source, in LaneDivision division, byte ownSystemId, byte author, int lanes)
    {
        bool isOfAuthor = source == author && source != ownSystemId;
        bool isPossible = division.Shares.All(s => s.First + s.Count <= lanes);
        if (!isOfAuthor || !isPossible)
            Refused++;
        else if (source != Author || IsNewer(division.Number, Number))
            Set(source, division.Number, division.Shares);
    }

    /// <summary>Divides, where that is ours to do and due.</summary>
    /// <param name="own">Our own report.</param>
    /// <param name="ownSystemId">Our system id.</param>
    /// <param name="present">The others that are received.</param>
    /// <param name="metresLeft">What a vehicle had left of its lanes, by its last report.</param>
    /// <param name="divide">
    /// Divides all lanes among vehicles, and says whether the energy of each is enough for its own.
    /// </param>
    /// <param name="mayBalance">
    /// Whether it is known what was flown; without a camera it is not, and lanes would be flown again.
    /// </param>
    /// <param name="now">The time.</param>
    /// <returns>Whether the division is to be sent.</returns>
    public bool Update(
        in GroupReport own, byte ownSystemId, IReadOnlyList<(byte SystemId, GroupReport Report)> present,
        Func<byte, double> metresLeft,
        Func<IReadOnlyList<(byte SystemId, GroupReport Report)>,
            (ImmutableArray<LaneShare> Shares, bool IsEnough)> divide,
        bool mayBalance, TimeSpan now)
    {
        _begun ??= now;
        if (ownSystemId != AuthorOf(own, ownSystemId, present) || now - _begun.Value < FirstAfter)
            return false;
        (byte SystemId, GroupReport Report)[] available = present.Append((ownSystemId, own))
            .Where(m => m.Item2.State == GroupMemberState.Available).OrderBy(m => m.Item1).ToArray();
        bool isNeeded = Shares.Length == 0 || available.Any(m => ShareOf(m.SystemId).SystemId == 0)
            || Shares.Any(s => available.All(m => m.SystemId != s.SystemId) && metresLeft(s.SystemId) > 0);

        // After a restart the others still follow a number of ours from before it.
        bool isTaken = Author == ownSystemId
            && !present.Any(m => m.Report.DivisionAuthor == ownSystemId && IsNewer(m.Report.DivisionNumber, Number));
        if (isNeeded || (mayBalance && IsUnbalanced(available, now)))
            Set(ownSystemId, divide(available).Shares, isTaken, present, now);
        else if (mayBalance && FindByEnergy(available, divide, now) is { } better)
            Set(ownSystemId, better, isTaken, present, now);
        else if (!isTaken)
            Set(ownSystemId, Shares, isTaken, present, now);
        if (Author != ownSystemId || now - _sent < RepeatPeriod || present.Count == 0)
            return false;
        _sent = now;
        return true;
    }

    private void Set(
        byte ownSystemId, ImmutableArray<LaneShare> shares, bool isTaken,
        IReadOnlyList<(byte SystemId, GroupReport Report)> present, TimeSpan now)
    {
        _made = now;
        if (isTaken && shares.SequenceEqual(Shares))
            return;

        ushort? number = Author == ownSystemId ? Number : null;
        foreach ((byte _, GroupReport report) in present)
        {
            bool isOurs = report.DivisionAuthor == ownSystemId;
            if (isOurs && (number is null || IsNewer(report.DivisionNumber, number.Value)))
                number = report.DivisionNumber;
        }

        Set(ownSystemId, unchecked((ushort)((number ?? Number) + 1)), shares);
        _sent = now - RepeatPeriod;
    }

    private bool IsUnbalanced((byte SystemId, GroupReport Report)[] available, TimeSpan now)
    {
        if (now - _made < BalancePeriod)
            return false;
        bool isIdle = available.Any(m => m.Report.MetresLeft <= 0 && m.Report.DivisionNumber == Number);
        return isIdle && available.Any(m => SecondsLeft(m.Report) > MinBalanceSeconds);
    }

    // Also a division that would not be better is not asked for again at once.
    private ImmutableArray<LaneShare>? FindByEnergy(
        (byte SystemId, GroupReport Report)[] available,
        Func<IReadOnlyList<(byte SystemId, GroupReport Report)>,
            (ImmutableArray<LaneShare> Shares, bool IsEnough)> divide,
        TimeSpan now)
    {
        bool isSoon = now - _made < EnergyPeriod || now - _askedForEnergy < EnergyPeriod;
        if (isSoon || !available.Any(m => SpareSeconds(m.Report) < 0)
            || !available.Any(m => SpareSeconds(m.Report) > MinBalanceSeconds))
            return null;
        _askedForEnergy = now;
        (ImmutableArray<LaneShare> shares, bool isEnough) = divide(available);
        return isEnough ? shares : null;
    }

    private static double SecondsLeft(in GroupReport report) => report.MetresLeft / report.SpeedMetresPerSecond;

    // Of its energy, when its lanes are flown; below zero it would leave some of them to the others, when it returns.
    private static double SpareSeconds(in GroupReport report)
        => report.SearchTime.ExactSeconds - SecondsLeft(report);

    private void Set(byte author, ushort number, ImmutableArray<LaneShare> shares)
    {
        if (!shares.SequenceEqual(Shares))
            Changes++;
        (Author, Number, Shares) = (author, number, shares);
    }

    // Modulo 2^16.
    private static bool IsNewer(ushort number, ushort than) => unchecked((short)(number - than)) > 0;
}
