using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

// Targets that move, each of which one vehicle follows.
internal sealed partial class MissionGroup
{
    // Who begins to follow can do so for this long, and who relieves another one for longer.
    private const double MinFollowSeconds = 60;
    private const double MinReliefSeconds = 180;

    // A target is offered to others while there is time for one of them to come.
    private static readonly TimeSpan HandOverTime = TimeSpan.FromSeconds(120);

    // A report of our own so far from where the target is expected is one of it.
    private const double OwnReportMetres = 20;

    private const double MinUsableShare = 0.5;

    private static readonly TimeSpan MaxOwnReportAge = TimeSpan.FromSeconds(2);

    // Others divide again when we are back; until then no lane is begun.
    private static readonly TimeSpan MaxShareWait = TimeSpan.FromSeconds(5);

    // Tasks of which it was logged.
    private readonly HashSet<(byte Finder, ushort Session, ushort Number)> _notForUs = [];

    private FollowBook? _following;
    private FollowLinks? _links;
    private TimeSpan? _ownReport;
    private TimeSpan? _followEnded;

    /// <summary>What we follow; null for nothing.</summary>
    public FollowedTask? CurrentFollow { get; private set; }

    public void Receive(MissionFlight flight, in Envelope<FollowTask> envelope)
    {
        if (SystemId == 0)
            return;
        TimeSpan sent = envelope.SentTime < flight.Now ? envelope.SentTime : flight.Now;
        _following?.Receive(
            envelope.SourceSystemId, envelope.Content, sent, SystemId, e => SecondsTo(flight, e), flight.Now);
    }

    public void Receive(in Envelope<FollowBid> envelope)
        => _following?.Receive(envelope.SourceSystemId, envelope.Content, SystemId);

    /// <summary>How targets of a class move.</summary>
    public TargetMotion MotionOf(TargetClassName name)
        => _links?.MotionOf(name) ?? TargetMotion.Walking;

    /// <summary>The tracks that show the target of a task.</summary>
    public IEnumerable<TargetTrack> TracksOf(FollowEntry entry, MissionFlight flight)
        => _links?.TracksOf(entry, flight) ?? [];

    /// <summary>Whether our own pictures show what we follow.</summary>
    public bool SeesFollowed(MissionFlight flight) => flight.Now - _ownReport <= MaxOwnReportAge;

    /// <summary>Begins with the next target that we are to follow.</summary>
    /// <returns>Which, as text; null where there is none.</returns>
    public string? NextFollow(MissionFlight flight)
    {
        if (CurrentFollow is not null || NextEntry is not { } next)
            return null;
        CurrentFollow = new FollowedTask(next, this);
        _ownReport = null;
        flight.Revisits.BeginFollowing(flight, PlaceOf(next, flight));
        return $"to follow {FollowBook.Name(next.Task)}, {next.Task.Class}";
    }

    /// <summary>Says how we follow, and asks others to come where our energy ends.</summary>
    public void ReportFollowed(MissionFlight flight, FollowedTask followed, TargetFollower follower)
    {
        FollowEntry entry = followed.Entry;
        EnergyStatus energy = flight.Energy.Status;
        if (entry.Task.State == FollowState.Awarded && entry.Task.Follower == SystemId
            && energy.IsKnown && energy.TimeToReturn < HandOverTime && HasOthers(flight))
        {
            flight.Log($"{FollowBook.Name(entry.Task)}: we can follow it for "
                + $"{MissionNumbers.Seconds(energy.TimeToReturn)} more; another one is to relieve us");
            entry.HandOver(SystemId, flight.Now);
        }

        if (entry.Task.Follower != SystemId)
            return;
        ref FollowTask task = ref entry.Task;
        (task.Progress, task.InView) = (follower.Progress, follower.InView);
    }

    /// <summary>Why we do not follow it any more, as text; null while we do.</summary>
    public string? WhyNotFollowed(MissionFlight flight, FollowedTask followed)
    {
        FollowTask task = followed.Entry.Task;
        if (task.State == FollowState.Closed)
        {
            return task.Result == FollowResult.SameTarget ? "is followed as another one"
                : task.Result == FollowResult.Rejected
                    ? $"was rejected by the operator of vehicle {MissionNumbers.Of(task.Decider)}"
                : $"vehicle {MissionNumbers.Of(task.Decider)} has ended it";
        }

        // While it has no follower we go on, and bid for it; the one that relieves us has to see it first.
        bool isRelieved = task.State == FollowState.Awarded && task.Follower != SystemId
            && (task.Progress == FollowProgress.InView || !SeesFollowed(flight)
                || flight.Now - followed.Entry.Decided > HandOverTime);
        return isRelieved ? $"vehicle {MissionNumbers.Of(task.Follower)} follows it"
            : IsMissedAsSearcher(flight.Now) ? "lanes are left, and no other vehicle searches"
            : null;
    }

    /// <summary>It is over: it was in view for long enough, or is lost.</summary>
    public void EndFollowed(
        MissionFlight flight, FollowedTask followed, TargetFollower follower, FollowResult result)
    {
        if (followed.Entry.Task.Follower != SystemId || followed.Entry.IsOver)
            return;
        followed.Entry.Task.InView = follower.InView;
        if (result == FollowResult.Lost && !SeesEnough(flight) && HasOthers(flight))
            followed.Entry.GiveBack(SystemId, flight.Now);
        else
            followed.Entry.Close(SystemId, result, flight.Now);
    }

    /// <summary>We go on with something else; the target is for another vehicle, where it is not done.</summary>
    public void LeaveFollowed(MissionFlight flight)
    {
        if (CurrentFollow is { Entry: var entry } && !entry.IsOver && entry.Task.Follower == SystemId)
            entry.GiveBack(SystemId, flight.Now);
        (CurrentFollow, _followEnded, _searcherMissed) = (null, flight.Now, null);
    }

    /// <summary>Whether our lanes are not known yet after we followed a target: others have taken them over.</summary>
    public bool IsAwaitingShare(MissionFlight flight)
        => flight.Now - _followEnded < MaxShareWait && _members.Present(flight.Now).Any()
            && _division.ShareOf(SystemId).SystemId == 0;

    // With pictures that cannot be used a target is not seen where it is: one that sees more may follow it.
    private static bool SeesEnough(MissionFlight flight) => !(flight.Imaging.UsableShare <= MinUsableShare);

    // What was awarded to us first, and is not over; also what we follow.
    private FollowEntry? NextEntry
    {
        get
        {
            FollowEntry? next = null;
            foreach (FollowEntry entry in _following?.Entries ?? [])
            {
                bool isOurs = entry.Task.State == FollowState.Awarded && entry.Task.Follower == SystemId;
                if (isOurs && (next is null || entry.Decided < next.Decided))
                    next = entry;
            }

            return next;
        }
    }

    private void TakeOwnReports(MissionFlight flight, in CameraObservation observation)
    {
        if (CurrentFollow is not { Entry.Task: var task })
            return;
        PlanePoint expected = FollowMark.Of(task, flight.Plan!.Frame).PlaceAt(observation.Time, maxSeconds: 3);
        double lost = Math.Max(0, (observation.Time - task.Time).ExactSeconds - 3);
        double radius = Math.Min(
            GrowingSearch.MaxRadiusMetres, OwnReportMetres + (TargetSpeeds.Of(MotionOf(task.Class)) * lost));
        foreach (TargetReport report in observation.Reports)
        {
            bool isSuch = report.Class == task.Class && report.MarkerId == task.MarkerId;
            PlanePoint at = ValidationLook.PlaceOf(flight.Plan.Frame, report.Position);
            if (isSuch && at.DistanceTo(expected) <= radius)
                _ownReport = observation.Time;
        }
    }

    private void UpdateFollowing(MissionFlight flight, (byte SystemId, GroupReport Report)[] present)
    {
        if (_following is not { } book)
            return;
        bool isAble = _own.State is GroupMemberState.Available or GroupMemberState.Following;
        _links ??= new FollowLinks(book);
        if (flight.Mission.Revisit.IsEnabled && flight.Mission.Revisit.FollowTime > TimeSpan.Zero)
            _links.Update(flight, SystemId, mayAnnounce: isAble);
        foreach (FollowEntry entry in book.Entries)
        {
            // What we cannot follow, since we leave or follow another one, is for others.
            bool isOurs = entry.Task.State == FollowState.Awarded && entry.Task.Follower == SystemId;
            bool isPossible = _own.State == GroupMemberState.Available && CurrentFollow is null && entry == NextEntry;
            if (isOurs && entry != CurrentFollow?.Entry && !isPossible)
                entry.GiveBack(SystemId, flight.Now);
        }

        List<byte> able = present.Where(m => m.Report.State == GroupMemberState.Available).Select(m => m.SystemId)
            .ToList();
        book.Update(
            SystemId, isAble, able, e => SecondsTo(flight, e), isSearchFirst: IsSearchFirst(flight.Now), flight.Now);
    }

    private static PlanePoint PlaceOf(FollowEntry entry, MissionFlight flight)
        => FollowMark.Of(entry.Task, flight.Plan!.Frame).PlaceAt(flight.Now, maxSeconds: 3);

    // Null where we cannot: not in the air, busy with another one, needed to search, with too little energy or budget,
    // or with a camera that does not show what we fly over.
    private double? SecondsTo(MissionFlight flight, FollowEntry entry)
    {
        if (CurrentFollow is { } current)
        {
            bool isKept = current.Entry == entry && SeesFollowed(flight) && !entry.IsOver && entry.Task.Follower == 0;
            return isKept ? 0 : null;
        }

        if (NextEntry is { } next && next != entry)
            return null;
        if (_own.State != GroupMemberState.Available || !flight.IsFlying || flight.IsFixedWing || flight.Plan is null
            || MustSearch(flight.Now) || !SeesEnough(flight))
            return null;
        PlanePoint place = PlaceOf(entry, flight);
        bool isBusy = _validation?.Look is not null;
        double seconds = (flight.Position.DistanceTo(place) / TargetFollower.Speed(flight))
            + (isBusy ? PassSeconds : 0);
        double then = entry.Task.Follower == 0 ? MinFollowSeconds : MinReliefSeconds;
        EnergyStatus energy = flight.Energy.Status;
        bool isEnough = !energy.IsKnown || energy.TimeToReturn.ExactSeconds > seconds + then + ReserveSeconds;
        return isEnough && IsForUs(flight, entry, place) && RevisitPass.Plan(flight, place) is not null
            ? seconds
            : null;
    }

    private bool IsForUs(MissionFlight flight, FollowEntry entry, PlanePoint place)
    {
        string? why = TargetFollower.CanSee(flight)
            ? flight.Revisits.WhyNotFollowed(flight, place)
            : "needs a camera that looks down, or a gimbal, to be followed";
        if (why is not null && _notForUs.Add(entry.Key))
            flight.Log($"{FollowBook.Name(entry.Task)} {why}: not for us");
        return why is null;
    }
}
