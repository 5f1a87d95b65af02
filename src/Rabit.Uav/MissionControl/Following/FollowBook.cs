using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Who of a group follows which target. Each task has a state that grows by decisions, of which the newer one holds
/// everywhere, and of two equally new ones that of the lower system id: so all that meet agree, whatever was lost or
/// came twice. The vehicle that announced a target takes bids and awards it; from then on the follower says how it goes
/// on, and takes the bids for its relief. Where it falls silent, the vehicle with the lowest system id takes bids.
/// Time-free but for the time it is given; one thread.
/// </summary>
internal sealed class FollowBook(ushort session, IFollowSender sender, Action<string> log)
{
    /// <summary>More tasks are not known, and counted.</summary>
    public const int MaxTasks = 64;

    /// <summary>A target that no vehicle has seen for longer is given up, if it was not before.</summary>
    public static readonly TimeSpan MaxUnseen = TimeSpan.FromSeconds(90);

    // After a partition it is known everywhere within 3 s who follows, also where 40 % is lost. Of many tasks each is
    // repeated less often, so that the radio is not filled.
    private static readonly TimeSpan Repeat = TimeSpan.OfSeconds(0.5);
    private static readonly TimeSpan RepeatOfEach = TimeSpan.OfSeconds(0.25);

    // To one that knows something older; several times, since that one does not answer.
    private const int AskedTimes = 3;

    private static readonly TimeSpan AskedRepeat = TimeSpan.OfSeconds(0.2);

    private static readonly TimeSpan BidTime = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan MaxSilence = TimeSpan.FromSeconds(6);
    private const int MissedRepeats = 6;
    private const int ClosedRepeats = 8;

    private readonly SortedDictionary<(byte Finder, ushort Session, ushort Number), FollowEntry> _entries = [];
    private ushort _announced;
    private TimeSpan _repeat = Repeat;
    private TimeSpan _maxSilence = MaxSilence;

    /// <summary>States and bids that were refused: older ones, or of more tasks than are kept.</summary>
    public long Refused { get; private set; }

    /// <summary>All tasks, in the order of their keys.</summary>
    public IEnumerable<FollowEntry> Entries => _entries.Values;

    /// <summary>Whether one is not over.</summary>
    public bool IsPending => _entries.Values.Any(e => !e.IsOver);

    /// <summary>The task with a key; null where there is none.</summary>
    public FollowEntry? Find((byte Finder, ushort Session, ushort Number) key)
        => _entries.TryGetValue(key, out FollowEntry? entry) ? entry : null;

    /// <summary>Announces a target that we see.</summary>
    public FollowEntry? Announce(FollowTask target, byte own, TimeSpan now)
    {
        if (!HasRoom())
            return null;
        (target.Finder, target.Session, target.Number) = (own, session, ++_announced);
        (target.Decision, target.Follower) = (0, 0);
        var entry = new FollowEntry(target);
        entry.Decide(own, FollowState.Open, follower: 0, now);
        _entries.Add(entry.Key, entry);
        return entry;
    }

    /// <summary>Takes the state of a task.</summary>
    /// <param name="source">Who sent it.</param>
    /// <param name="task">The state.</param>
    /// <param name="sentTime">When.</param>
    /// <param name="own">Our system id.</param>
    /// <param name="secondsTo">After what time we would be there; null where we cannot.</param>
    /// <param name="now">The time.</param>
    public void Receive(
        byte source, in FollowTask task, TimeSpan sentTime, byte own, Func<FollowEntry, double?> secondsTo,
        TimeSpan now)
    {
        FollowEntry? entry = Find((task.Finder, task.Session, task.Number));
        bool isPossible = source != own && source != 0
            && (task.Decider == source || (task.State == FollowState.Awarded && task.Follower == source));
        if (!isPossible || (entry is null && !HasRoom()))
        {
            Refused++;
            return;
        }

        if (entry is null)
            _entries[(task.Finder, task.Session, task.Number)] = entry = new FollowEntry(task with { Decision = 0 });
        int newer = entry.Compare(task);
        bool isOfFollower = task.State == FollowState.Awarded && task.Follower == source;
        if (newer < 0)
        {
            Refused++;
            entry.Asked = AskedTimes;
            return;
        }

        // Of one decision the follower's word is worth more than that of who decided.
        bool isSaid = isOfFollower || !entry.HasFollowerSpoken;
        bool isLate = isOfFollower == entry.HasFollowerSpoken && sentTime < entry.SentTime;
        if (newer > 0 || (isSaid && !isLate))
            entry.Take(task, isOfFollower, sentTime, now);
        if (entry.Task.State == FollowState.Open && entry.Task.Decider == source)
            Bid(entry, secondsTo(entry));
    }

    /// <summary>Takes a bid.</summary>
    public void Receive(byte source, in FollowBid bid, byte own)
    {
        FollowEntry? entry = Find((bid.Finder, bid.Session, bid.Number));
        bool isWanted = entry is { Task.State: FollowState.Open } && entry.Task.Decider == own
            && bid.Decision == entry.Task.Decision && source != own;
        if (isWanted)
            entry!.Bids[source] = bid.IsOffered ? bid.Seconds : double.PositiveInfinity;
        else
            Refused++;
    }

    /// <summary>In each tick.</summary>
    /// <param name="own">Our system id.</param>
    /// <param name="isAble">Whether we can decide: in the air, with the mission going on.</param>
    /// <param name="present">The system ids of the others that can bid.</param>
    /// <param name="secondsTo">After what time we would be there; null where we cannot.</param>
    /// <param name="isSearchFirst">
    /// Whether targets without a follower have to wait, since the vehicles that are free are needed to search.
    /// </param>
    /// <param name="now">The time.</param>
    public void Update(
        byte own, bool isAble, IReadOnlyCollection<byte> present, Func<FollowEntry, double?> secondsTo,
        bool isSearchFirst, TimeSpan now)
    {
        AdaptRepeat(own);
        foreach (FollowEntry entry in _entries.Values)
        {
            if (!entry.IsOver)
            {
                Wait(entry, isSearchFirst, now);
                Decide(entry, own, isAble, present, secondsTo, now);
            }

            if (entry.IsSaidBy(own))
                Say(entry, now);
            else
                entry.Asked = 0;
        }
    }

    public static string Name(in FollowTask task)
        => $"moving target {MissionNumbers.Of(task.Number)} of vehicle {MissionNumbers.Of(task.Finder)}";

    // How many another vehicle has to repeat is not known; they are no more than all that are not over.
    private void AdaptRepeat(byte own)
    {
        int pending = _entries.Values.Count(e => !e.IsOver);
        int ours = _entries.Values.Count(e => !e.IsOver && e.IsSaidBy(own));
        _repeat = Longer(Repeat, TimeSpan.FromTicks(RepeatOfEach.Ticks * ours));
        _maxSilence = Longer(MaxSilence, TimeSpan.FromTicks(RepeatOfEach.Ticks * pending * MissedRepeats));
    }

    private static TimeSpan Longer(TimeSpan left, TimeSpan right) => left > right ? left : right;

    private void Wait(FollowEntry entry, bool isSearchFirst, TimeSpan now)
    {
        if (!isSearchFirst || entry.Task.State != FollowState.Open || entry.Task.Follower != 0)
            return;
        if (entry.WaitedUntil is null)
            log($"{Name(entry.Task)} waits: lanes are left, and no vehicle beside the one that searches is free");
        entry.WaitedUntil = now;
    }

    private void Decide(
        FollowEntry entry, byte own, bool isAble, IReadOnlyCollection<byte> present,
        Func<FollowEntry, double?> secondsTo, TimeSpan now)
    {
        // The one with the lowest system id; the others, where it does not know of the task.
        int before = present.Count(p => p < own);
        bool isSilent = !entry.IsSaidBy(own)
            && now - entry.LastReceived > TimeSpan.FromTicks(_maxSilence.Ticks * (before + 1));
        bool isUnanswered = entry.Task.State == FollowState.Awarded && !entry.HasFollowerSpoken
            && entry.Task.Decider == own && now - entry.Decided > _maxSilence;
        if ((isSilent && isAble) || isUnanswered)
        {
            log($"{Name(entry.Task)}: vehicle {MissionNumbers.Of(entry.Task.Follower)} is not received; another one is "
                + "to follow");
            entry.Decide(own, FollowState.Open, follower: 0, now);
        }

        // Another one took us for lost: we see it, and there is nothing to bid for.
        if (entry.Task.State == FollowState.Open && entry.Task.Follower == 0 && secondsTo(entry) <= 0)
            entry.Decide(own, FollowState.Awarded, own, now);
        if (entry.Task.State != FollowState.Open || entry.Task.Decider != own)
            return;
        TimeSpan since = entry.WaitedUntil > entry.Task.Time ? entry.WaitedUntil.Value : entry.Task.Time;
        if (entry.Task.Follower == 0 && now - since > MaxUnseen)
        {
            entry.Close(own, FollowResult.Lost, now);
            log($"{Name(entry.Task)}: given up, it was not seen for {MissionNumbers.Seconds(MaxUnseen)}");
            return;
        }

        // Who waits for its relief does not relieve itself.
        if (isAble && entry.Task.Follower != own)
            entry.Bids[own] = secondsTo(entry) ?? double.PositiveInfinity;
        entry.BidsSince ??= now;
        if (present.All(entry.Bids.ContainsKey) || now - entry.BidsSince.Value >= BidTime)
            Award(entry, own, present, now);
    }

    private void Award(FollowEntry entry, byte own, IReadOnlyCollection<byte> present, TimeSpan now)
    {
        byte best = 0;
        double least = double.PositiveInfinity;
        foreach (KeyValuePair<byte, double> bid in entry.Bids.OrderBy(b => b.Key))
        {
            bool isFree = (bid.Key == own || present.Contains(bid.Key)) && !IsAwardedAnother(bid.Key, entry);
            if (isFree && bid.Value < least)
                (best, least) = (bid.Key, bid.Value);
        }

        // Who cannot now may be able to later.
        entry.Bids.Clear();
        entry.BidsSince = now;
        if (best == 0)
            return;
        entry.Decide(own, FollowState.Awarded, best, now);
        log($"{Name(entry.Task)}, {entry.Task.Class}: vehicle {MissionNumbers.Of(best)} is to follow it, in "
            + $"{MissionNumbers.Of(least)} s");
    }

    // Its bid is from before that.
    private bool IsAwardedAnother(byte systemId, FollowEntry entry) => _entries.Values.Any(
        e => e != entry && e.Task.State == FollowState.Awarded && e.Task.Follower == systemId);

    private void Say(FollowEntry entry, TimeSpan now)
    {
        entry.LastReceived = now;
        bool isQuiet = entry.IsOver && now - entry.Decided > TimeSpan.FromTicks(_repeat.Ticks * ClosedRepeats);
        bool isDue = entry.Asked > 0 ? now >= entry.SentAt + AskedRepeat : now >= entry.SendAt && !isQuiet;
        if (!isDue)
            return;
        sender.Send(entry.Task);
        (entry.SentAt, entry.SendAt) = (now, now + _repeat);
        entry.Asked = Math.Max(0, entry.Asked - 1);
    }

    private void Bid(FollowEntry entry, double? seconds) => sender.Send(
        new FollowBid
        {
            Finder = entry.Task.Finder,
            Session = entry.Task.Session,
            Number = entry.Task.Number,
            Decision = entry.Task.Decision,
            IsOffered = seconds is not null,
            Seconds = seconds ?? 0,
        },
        entry.Task.Decider);

    // Of those that are over the oldest one makes room.
    private bool HasRoom()
    {
        if (_entries.Count < MaxTasks)
            return true;
        FollowEntry? oldest = _entries.Values.Where(e => e.IsOver).OrderBy(e => e.Decided).FirstOrDefault();
        if (oldest is null)
        {
            Refused++;
            return false;
        }

        _entries.Remove(oldest.Key);
        return true;
    }
}
