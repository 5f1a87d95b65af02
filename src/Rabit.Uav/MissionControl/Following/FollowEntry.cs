using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>One target that is followed, as one vehicle knows it. One thread.</summary>
internal sealed class FollowEntry(FollowTask task)
{
    private FollowTask _task = task;

    /// <summary>The task as it is known.</summary>
    public ref FollowTask Task => ref _task;

    public (byte Finder, ushort Session, ushort Number) Key => (_task.Finder, _task.Session, _task.Number);

    public bool IsOver => _task.State == FollowState.Closed;

    /// <summary>When the vehicle that has to say something of it was last received; also when that is ours.</summary>
    public TimeSpan LastReceived { get; set; }

    /// <summary>When what we know of it was sent.</summary>
    public TimeSpan SentTime { get; set; }

    /// <summary>Whether the follower says itself what it does.</summary>
    public bool HasFollowerSpoken { get; set; }

    /// <summary>The seconds of those who answered; infinite for those who cannot.</summary>
    public Dictionary<byte, double> Bids { get; } = [];

    public TimeSpan? BidsSince { get; set; }

    /// <summary>Until when no vehicle was free for it, since lanes came first; null for never.</summary>
    public TimeSpan? WaitedUntil { get; set; }

    /// <summary>When the last decision was taken, or received.</summary>
    public TimeSpan Decided { get; set; }

    public TimeSpan SendAt { get; set; }

    public TimeSpan SentAt { get; set; }

    /// <summary>How often it is to be sent soon, since a vehicle said something older.</summary>
    public int Asked { get; set; }

    /// <summary>Since when it is where another task is, too.</summary>
    public TimeSpan? SameSince { get; set; }

    /// <summary>
    /// Who repeats it: who takes bids, who follows once it has said so, and who closed it.
    /// </summary>
    public bool IsSaidBy(byte systemId) => _task.State == FollowState.Awarded
        ? _task.Follower == systemId || (_task.Decider == systemId && !HasFollowerSpoken)
        : _task.Decider == systemId;

    /// <summary>
    /// Above zero where a state is newer than what is known, below where it is older. That the operator has rejected it
    /// is newer than all else, and that it was followed for as long as the mission says newer than the rest.
    /// </summary>
    public int Compare(in FollowTask other)
        => Rank(other.Result) + Rank(_task.Result) > 0 ? Rank(other.Result).CompareTo(Rank(_task.Result))
            : other.Decision != _task.Decision ? other.Decision.CompareTo(_task.Decision)
            : _task.Decider.CompareTo(other.Decider);

    /// <summary>Takes a decision.</summary>
    /// <param name="own">Our system id.</param>
    /// <param name="state">What is decided.</param>
    /// <param name="follower">Who follows; 0 for none.</param>
    /// <param name="now">The time.</param>
    public void Decide(byte own, FollowState state, byte follower, TimeSpan now)
    {
        if (_task.Decision == ushort.MaxValue)
            return; // no vehicle gets there by itself
        if (follower != _task.Follower)
            _task.Progress = FollowProgress.OnTheWay;
        _task.Decision++;
        (_task.Decider, _task.State, _task.Follower) = (own, state, follower);
        BeginDecision(now, hasFollowerSpoken: follower == own);
        LastReceived = SentTime = now;
    }

    /// <summary>We do not follow it any more: bids are taken for another one.</summary>
    public void GiveBack(byte own, TimeSpan now) => Decide(own, FollowState.Open, follower: 0, now);

    /// <summary>We follow it until we are relieved.</summary>
    public void HandOver(byte own, TimeSpan now) => Decide(own, FollowState.Open, own, now);

    /// <summary>It is over.</summary>
    public void Close(byte own, FollowResult result, TimeSpan now)
    {
        Decide(own, FollowState.Closed, _task.Follower, now);
        if (IsOver)
            _task.Result = result;
    }

    /// <summary>Takes over a newer decision of another vehicle, or what it says of the same.</summary>
    public void Take(in FollowTask task, bool isOfFollower, TimeSpan sentTime, TimeSpan now)
    {
        bool isNew = Compare(task) != 0;
        _task = task;
        (LastReceived, SentTime) = (now, sentTime);
        if (isNew)
            BeginDecision(now, isOfFollower);
        else
            HasFollowerSpoken |= isOfFollower;
    }

    private static int Rank(FollowResult result)
        => result == FollowResult.Rejected ? 2 : result == FollowResult.Followed ? 1 : 0;

    private void BeginDecision(TimeSpan now, bool hasFollowerSpoken)
    {
        Bids.Clear();
        (BidsSince, Decided, SendAt, HasFollowerSpoken) = (null, now, now, hasFollowerSpoken);
    }
}
