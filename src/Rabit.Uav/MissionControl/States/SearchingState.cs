using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Flies lane after lane; between two of them, or in passing where that is much less way, new targets are revisited; at
/// the end the gaps in the coverage are flown over.
/// </summary>
internal sealed class SearchingState : MissionState
{
    // The last pictures of a lane are still being processed.
    private static readonly TimeSpan ProcessingTime = TimeSpan.OfSeconds(1.5);

    private readonly PathFollower _path = new();
    private readonly FixedWingFollower _wing = new();
    private ILaneFollower _follower;
    private TimeSpan? _laneEnd;
    private SearchRoute? _route;
    private readonly TransitPath _homeward = new();
    private PlanePoint? _around;
    private double _heading;
    private bool _isOnLane;
    private (PlanePoint At, double Heading)? _waiting;

    public SearchingState()
        : base(MissionPhase.Searching) => _follower = _path;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        (_isOnLane, _around, _waiting) = (false, null, null);
        _follower = flight.IsFixedWing ? _wing : _path;
        if (!flight.IsFixedWing)
            flight.Route!.Reorder(flight.Position);
    }

    /// <summary>A lane that was interrupted is continued where it was left.</summary>
    public override void Leave(MissionFlight flight)
    {
        if (_isOnLane && ReferenceEquals(_route, flight.Route))
            flight.Route!.InterruptLeg(flight.OverlapMetres);
    }

    /// <summary>What is missing of the lane is a gap then, which is flown over at the end.</summary>
    public override MissionStep LeaveLeg(MissionFlight flight, string why)
    {
        if (_isOnLane)
            flight.LeaveLane(why);
        _isOnLane = false;
        return MissionStep.Stay;
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        if (!_isOnLane && flight.Changes.AreDue)
        {
            if (flight.Changes.NeedPlan && _laneEnd is { } last && flight.ActiveTime - last < ProcessingTime)
                return MissionStep.Stay;
            flight.Changes.BeginLeg();
        }

        if (!ReferenceEquals(_route, flight.Route))
            (_route, _isOnLane) = (flight.Route, false);
        if (_isOnLane && flight.Group?.TakeLaneLeft() == true)
        {
            flight.Route!.InterruptLeg(flight.OverlapMetres);
            _isOnLane = false;
        }

        if (!_isOnLane && flight.Group is { } group)
        {
            group.BeginLeg(flight);
            if (group.IsAwaitingShare(flight))
                return Wait(flight, "our lanes are divided");
            if (group.NextValidation(flight) is { } validation)
                return new MissionStep(MissionEvent.TargetFound, validation);
        }

        // At once, on a lane too: it is elsewhere later.
        if (flight.Group?.NextFollow(flight) is { } follow)
            return new MissionStep(MissionEvent.TargetFound, follow);
        if (flight.IsFixedWing && flight.Commands.Failures > 0)
            return new MissionStep(MissionEvent.Hold, "the leg was not accepted: " + flight.Commands.LastFailure);
        if (flight.Commands.Failures >= MaxFailures)
            return ReturnToLaunch(flight.Commands.LastFailure);
        if (_laneEnd is { } end && flight.ActiveTime - end < ProcessingTime && flight.Route!.Current is null)
            return MissionStep.Stay;
        if (flight.Revisits.Next(flight, _isOnLane) is { } track)
            return new MissionStep(MissionEvent.TargetFound, $"track {MissionNumbers.Of(track.Id)}");
        if (flight.Route!.Current is { } lane)
            return Fly(flight, lane);
        MissionStep step = Finish(flight);
        if (step.What == MissionEvent.Searched && flight.Group?.FindWait(flight) is { } wait)
            return WaitAtHome(flight, wait);
        if (step.What == MissionEvent.Searched && IsTrafficOnTheWayHome(flight))
            return WaitAtHome(flight, "to the landing place: another vehicle is not in its layer");
        return step.What == MissionEvent.Searched && IsKeepOutOnTheWayHome(flight) ? MissionStep.Stay : step;
    }

    private MissionStep Wait(MissionFlight flight, string text)
    {
        flight.Text = text;
        _waiting ??= (flight.Position, flight.Vehicle.Attitude.Yaw.Radians);
        flight.SetGoalPosition(_waiting.Value.At, flight.Mission.HeightMetres, _waiting.Value.Heading);
        return MissionStep.Stay;
    }

    // What is still to come is little: the way home is not for the end of it. In its layer it is clear of the others.
    private MissionStep WaitAtHome(MissionFlight flight, string text)
    {
        flight.Text = text;
        if (_waiting is null)
            _homeward.Begin(flight, default);
        _waiting ??= (default, flight.Vehicle.Attitude.Yaw.Radians);
        flight.SetGoalPosition(_homeward.Next(flight), flight.Mission.HeightMetres, _waiting.Value.Heading);
        return MissionStep.Stay;
    }

    // The autopilot's return gives way to none.
    private static bool IsTrafficOnTheWayHome(MissionFlight flight) => flight.Group?.IsAnyOutOfLayer(flight) == true
        && !flight.IsFixedWing && !PathFollower.HasArrived(flight, default, flight.Mission.HeightMetres);

    // The autopilot's return is straight.
    private bool IsKeepOutOnTheWayHome(MissionFlight flight)
    {
        if (_around is { } corner && !PathFollower.HasArrived(flight, corner, flight.Mission.HeightMetres))
        {
            FlyAround(flight, corner);
            return true;
        }

        IReadOnlyList<PlanePoint> path = flight.Plan!.PathBetween(flight.Position, default);
        if (flight.Plan.KeepOuts.Count == 0 || path.Count == 0)
            return false;
        PlanePoint next = path[0];
        (_around, _heading) = (next, (next - flight.Position).HeadingRadians);
        _homeward.Begin(flight, next);
        FlyAround(flight, next);
        return true;
    }

    private void FlyAround(MissionFlight flight, PlanePoint corner)
    {
        flight.Text = "around the keep-outs, to return";
        flight.SetGoalPosition(_homeward.Next(flight), flight.Mission.HeightMetres, _heading);
    }

    private MissionStep Fly(MissionFlight flight, LaneSegment lane)
    {
        SearchRoute route = flight.Route!;
        if (!_isOnLane)
            _follower.Begin(flight, lane, flight.Mission.HeightMetres);
        (_isOnLane, _waiting) = (true, null);
        flight.Text =
            $"searching: lane {MissionNumbers.Of(route.Flown + 1)} of {MissionNumbers.Of(route.Count)}, {Seen(flight)}";
        bool isFlown = _follower.Tick(flight, out bool isLate);
        route.FlownMetresOfLeg = _follower.FlownMetres;
        if (isLate && flight.IsFixedWing)
            return new MissionStep(MissionEvent.Hold, "no progress along the leg");
        if (isLate)
            return ReturnToLaunch($"lane {MissionNumbers.Of(route.Flown + 1)} takes too long");
        if (!isFlown)
            return MissionStep.Stay;
        _isOnLane = false;
        _laneEnd = flight.ActiveTime;
        route.FinishLeg();
        flight.Log($"lane {MissionNumbers.Of(route.Flown)} of {MissionNumbers.Of(route.Count)} flown, {Seen(flight)}");
        return MissionStep.Stay;
    }

    private static string Seen(MissionFlight flight) => MissionNumbers.Percent(flight.SeenFraction) + " seen";

    private static MissionStep Finish(MissionFlight flight)
    {
        SearchRoute route = flight.Route!;
        string seen = Seen(flight);
        if (flight.SeenFraction >= flight.CoverageGoal)
            return new MissionStep(MissionEvent.Searched, seen);
        if (!flight.Options.RequiresCamera && flight.SeenFraction <= 0)
            return new MissionStep(MissionEvent.Searched, "the lanes are flown; there was no camera");
        if (route.GapPasses >= flight.Options.MaxGapPasses)
            return new MissionStep(MissionEvent.Searched, seen + ", the gaps were flown over");
        int legs = route.AddGapLegs(flight.Position, flight.Group is { } group ? group.IsOurs : null);
        if (legs == 0)
            return new MissionStep(MissionEvent.Searched, seen + ", the gaps are too small to fly over");
        flight.Log($"{seen}: {MissionNumbers.Of(legs)} more {(legs == 1 ? "leg" : "legs")} over gaps");
        return MissionStep.Stay;
    }
}
