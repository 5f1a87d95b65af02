using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Revisits one confirmed target: flies over it across the lanes and back, so that the camera observes it from other
/// directions, until there are a few more reports of it. One that moves is followed.
/// </summary>
internal sealed class RevisitingState() : MissionState(MissionPhase.Revisiting)
{
    private const int MinReports = 4;

    private static readonly TimeSpan MinHold = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan MaxHold = TimeSpan.FromSeconds(10);

    private readonly TransitPath _transit = new();
    private OperatorRequest? _order; // null for a revisit of our own
    private ValidationLook? _look; // null but for a target of another vehicle, which we validate
    private int _track; // 0 for a place
    private double _speed;
    private int _reportsBefore;
    private TargetFollower? _follower; // null for a target that stands
    private TrackedTarget? _tracked; // what it follows, where we follow it alone
    private FollowedTask? _task; // what it follows, in a group
    private RevisitPass _pass = null!; // planned when the phase is entered
    private bool _isAtStart;
    private bool _isThrough;
    private TimeSpan? _overhead;
    private TimeSpan _limit;
    private double _height;
    private TimeSpan _begun;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        _height = flight.Mission.Revisit.HeightMetres ?? flight.Mission.HeightMetres;
        _overhead = null;
        _begun = flight.ActiveTime;
        _order = by == MissionEvent.OperatorRevisit ? flight.Ordered : null;
        _task = _order is null ? flight.Group?.CurrentFollow : null;
        _look = _order is null && _task is null ? flight.Group?.CurrentLook : null;
        TargetTrack? track = _look is not null || _task is not null ? null
            : _order is null ? flight.Revisits.Chosen(flight) : Revisits.Find(flight, _order.TrackId);
        (_track, _reportsBefore) = (track?.Id ?? 0, track?.Reports ?? 0);
        PlanePoint target = _look is { } look ? look.Place
            : _task is { } task ? task.Begin(flight).Place
            : track is null ? OperatorFaults.PlaceOf(flight.Plan!, _order!.Place)
            : Revisits.PositionOf(track, flight);
        BeginPass(flight, target, track);
        flight.IsFollowing = _follower is not null;
    }

    /// <summary>A target of the group is for another one then.</summary>
    public override void Leave(MissionFlight flight)
    {
        flight.IsFollowing = false;
        if (_task is not null)
            flight.Group!.LeaveFollowed(flight);
        _task = null;
    }

    private void BeginPass(MissionFlight flight, PlanePoint target, TargetTrack? track)
    {
        // What is followed may have left the fence since it was chosen: the vehicle waits for it where it is.
        _pass = RevisitPass.Plan(flight, target) ?? RevisitPass.Stay(flight);
        _isAtStart = _isThrough = !_pass.IsThrough;
        _transit.Begin(flight, _pass.IsThrough ? _pass.Start : _pass.Overhead);
        _speed = flight.Mission.SpeedMetresPerSecond;
        _limit = PathFollower.TimeLimit(flight, _pass.LengthFrom(flight.Position)) + MaxHold;
        bool isFollowed = track is { Motion: not TargetMotion.Standing }
            && flight.Mission.Revisit.FollowTime > TimeSpan.Zero && !flight.IsFixedWing;
        _tracked = isFollowed ? new TrackedTarget(track!) : null;
        IFollowedTarget? followed = _task is not null ? _task : _tracked;
        _follower = followed is not null ? new TargetFollower(flight, followed, _pass.HeadingRadians) : null;
    }

    /// <summary>A target that it follows is for another vehicle; one that it validates stays unknown.</summary>
    public override MissionStep LeaveLeg(MissionFlight flight, string why)
    {
        if (_task is not { } task)
            return Finish(flight, wasObserved: false, why);
        flight.Revisits.FinishFollowing(_follower!.InView > task.InViewBefore, flight.ActiveTime - _begun);
        return new MissionStep(MissionEvent.Revisited, $"{task.Name}: {why}");
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        if (flight.Commands.Failures >= MaxFailures)
            return ReturnToLaunch(flight.Commands.LastFailure);
        if (_follower is { } follower)
            return Follow(flight, follower, inPhase);
        _limit += PathFollower.MoreTime(flight, ref _speed);
        TargetTrack? track = Revisits.Find(flight, _track);
        bool isWanted = _look is not null ? ReferenceEquals(flight.Group!.CurrentLook, _look)
            : track?.State == TrackState.Confirmed
            || (_order is not null && (_track == 0 || track is { State: not TrackState.Rejected }));
        if (!isWanted)
            return Finish(flight, wasObserved: _overhead is not null, "no longer confirmed");
        if (inPhase > _limit)
            return Finish(flight, wasObserved: false, "not reached in time");

        // A validation answers one question; what the pass would add to the accuracy is not worth its time to a group.
        if (_look?.IsEnough == true)
            return Finish(flight, wasObserved: true, "seen");
        flight.Text = _look is not null ? $"validating {MissionGroup.Name(_look.Task)}"
            : track is null ? "revisiting a place"
            : $"revisiting track {MissionNumbers.Of(_track)}, {Revisits.Name(track)}";
        return Fly(flight, track);
    }

    private MissionStep Fly(MissionFlight flight, TargetTrack? track)
    {
        if (!_isAtStart)
        {
            _isAtStart = FlyTo(flight, _pass.Start);
            _reportsBefore = track?.Reports ?? 0;
            return MissionStep.Stay;
        }

        if (!_isThrough)
        {
            _isThrough = FlyTo(flight, _pass.Beyond);
            return MissionStep.Stay;
        }

        if (!FlyTo(flight, _pass.Overhead) && _overhead is null)
            return MissionStep.Stay;
        _overhead ??= flight.ActiveTime;
        TimeSpan held = flight.ActiveTime - _overhead.Value;
        int reports = (track?.Reports ?? 0) - _reportsBefore;
        bool isEnough = held >= MinHold && (_look?.IsEnough ?? (reports >= MinReports));
        return isEnough || held >= MaxHold
            ? Finish(flight, wasObserved: reports > 0, track is null ? "flown over" : Accuracy(track, reports))
            : MissionStep.Stay;
    }

    private MissionStep Follow(MissionFlight flight, TargetFollower follower, TimeSpan inPhase)
    {
        // A search that finds it again counts once.
        bool isLate = inPhase > _limit + flight.Mission.Revisit.FollowTime + (_task?.MaxSearch ?? _tracked!.MaxSearch);
        bool isOver = follower.Tick(flight) || isLate;
        bool isEnough = follower.InView >= flight.Mission.Revisit.FollowTime;
        string inView = (follower.IsRejected ? "rejected by the operator, " : isEnough ? "followed, " : "lost, ")
            + $"{MissionNumbers.Of((int)follower.InView.ExactSeconds)} s in view";
        if (_task is { } task)
            return FollowForGroup(flight, follower, task, isOver, isEnough, inView);
        _track = _tracked!.TrackId;
        flight.Text = $"{Doing(follower)} {_tracked.Name}";
        return isOver ? Finish(flight, wasObserved: follower.InView > TimeSpan.Zero, inView) : MissionStep.Stay;
    }

    private MissionStep FollowForGroup(
        MissionFlight flight, TargetFollower follower, FollowedTask task, bool isOver, bool isEnough, string inView)
    {
        flight.Text = $"{Doing(follower)} {task.Name}";
        if (isOver)
            flight.Group!.EndFollowed(
                flight, task, follower,
                follower.IsRejected ? FollowResult.Rejected : isEnough ? FollowResult.Followed : FollowResult.Lost);
        else
            flight.Group!.ReportFollowed(flight, task, follower);
        string? relieved = isOver ? inView : flight.Group!.WhyNotFollowed(flight, task);
        if (relieved is null)
            return MissionStep.Stay;
        flight.Revisits.FinishFollowing(follower.InView > task.InViewBefore, flight.ActiveTime - _begun);
        return new MissionStep(MissionEvent.Revisited, $"{task.Name}: {relieved}");
    }

    private static string Doing(TargetFollower follower)
        => follower.Progress == FollowProgress.Searching ? "searching for" : "following";

    private bool FlyTo(MissionFlight flight, PlanePoint place)
    {
        if (_transit.To.DistanceTo(place) > 0)
            _transit.Begin(flight, place);
        flight.SetGoalPosition(_transit.Next(flight), _height, _pass.HeadingRadians);
        return PathFollower.HasArrived(flight, place, _height);
    }

    private static string Accuracy(TargetTrack track, int reports)
        => $"{MissionNumbers.Of(reports)} more reports, 95 % within "
            + $"{MissionNumbers.Of(track.Covariance.HalfMajorAxis95Metres)} m";

    private MissionStep Finish(MissionFlight flight, bool wasObserved, string text)
    {
        if (_look is { } look)
        {
            string seen = flight.Group!.FinishValidation(flight, look, look.Result);
            return new MissionStep(MissionEvent.Revisited, seen);
        }

        if (_track == 0)
            return new MissionStep(MissionEvent.Revisited, "place: " + text);
        flight.Revisits.Finish(_track, wasObserved, flight.ActiveTime - _begun);
        return new MissionStep(MissionEvent.Revisited, $"track {MissionNumbers.Of(_track)}: {text}");
    }
}
