using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Revisits one confirmed target: flies over it across the lanes, so that the camera observes it from another
/// direction, until there are a few more reports of it.
/// </summary>
internal sealed class RevisitingState() : MissionState(MissionPhase.Revisiting)
{
    private const int MinReports = 4;

    private static readonly TimeSpan MinHold = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan MaxHold = TimeSpan.FromSeconds(10);

    private int _track;
    private int _reportsBefore;
    private LaneSegment _pass;
    private bool _isAtStart;
    private TimeSpan? _overhead;
    private TimeSpan _limit;
    private double _height;
    private TimeSpan _begun;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        _height = flight.Mission.Revisit.HeightMetres ?? flight.Mission.HeightMetres;
        _overhead = null;
        _begun = flight.ActiveTime;
        _isAtStart = !(flight.Mission.Revisit.RadiusMetres > 0);
        TargetTrack track = flight.Revisits.Next(flight)!;
        _track = track.Id;
        _pass = PassOver(flight, Revisits.PositionOf(track, flight));
        _limit = PathFollower.TimeLimit(flight, flight.Position.DistanceTo(_pass.Start) + _pass.Length) + MaxHold;
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        if (flight.Commands.Failures >= MaxFailures)
            return ReturnToLaunch(flight.Commands.LastFailure);
        if (Revisits.Find(flight, _track) is not { State: TrackState.Confirmed } track)
            return Finish(flight, wasObserved: _overhead is not null, "no longer confirmed");
        if (inPhase > _limit)
            return Finish(flight, wasObserved: false, "not reached in time");
        flight.Text = $"revisiting track {MissionNumbers.Of(_track)}, {Revisits.Name(track)}";
        return Fly(flight, track);
    }

    // From the side of the target on which the vehicle is.
    private static LaneSegment PassOver(MissionFlight flight, PlanePoint target)
    {
        PlanePoint across = PlanePoint.Towards(flight.Plan!.HeadingRadians + (Math.PI / 2));
        double side = across.Dot(target - flight.Position) >= 0 ? 1 : -1;
        double radius = Math.Max(1, flight.Mission.Revisit.RadiusMetres);
        return new LaneSegment(target - (radius * side * across), target);
    }

    private MissionStep Fly(MissionFlight flight, TargetTrack track)
    {
        if (!_isAtStart)
        {
            flight.SetGoalPosition(_pass.Start, _height, _pass.HeadingRadians);
            _isAtStart = PathFollower.HasArrived(flight, _pass.Start, _height);
            return MissionStep.Stay;
        }

        flight.SetGoalPosition(_pass.End, _height, _pass.HeadingRadians);
        if (_overhead is null)
        {
            if (!PathFollower.HasArrived(flight, _pass.End, _height))
                return MissionStep.Stay;
            _overhead = flight.ActiveTime;
            _reportsBefore = track.Reports;
        }

        TimeSpan held = flight.ActiveTime - _overhead.Value;
        int reports = track.Reports - _reportsBefore;
        bool isEnough = held >= MinHold && reports >= MinReports;
        return isEnough || held >= MaxHold
            ? Finish(flight, wasObserved: reports > 0, Accuracy(track, reports))
            : MissionStep.Stay;
    }

    private static string Accuracy(TargetTrack track, int reports)
        => $"{MissionNumbers.Of(reports)} more reports, 95 % within "
            + $"{MissionNumbers.Of(track.Covariance.HalfMajorAxis95Metres)} m";

    private MissionStep Finish(MissionFlight flight, bool wasObserved, string text)
    {
        flight.Revisits.Finish(_track, wasObserved, flight.ActiveTime - _begun);
        return new MissionStep(MissionEvent.Revisited, $"track {MissionNumbers.Of(_track)}: {text}");
    }
}
