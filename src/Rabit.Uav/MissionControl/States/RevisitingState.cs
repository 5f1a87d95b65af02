using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Over one new target, coming across the lanes so that the camera sees it another way round, until it was seen a few times more.</summary>
internal sealed class RevisitingState() : MissionState(MissionPhase.Looking)
{
    private const int ReportsWanted = 4;

    private static readonly TimeSpan MinHold = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan MaxHold = TimeSpan.FromSeconds(10);

    private int _track;
    private int _reportsBefore;
    private LaneSegment _pass;
    private bool _isAtStart;
    private TimeSpan? _overhead;
    private TimeSpan _limit;
    private double _height;

    public override void Enter(MissionFlight flight, MissionEvent by)
    {
        _height = flight.Mission.Revisit.HeightMetres ?? flight.Mission.HeightMetres;
        _overhead = null;
        _isAtStart = !(flight.Mission.Revisit.RadiusMetres > 0);
        TargetTrack track = flight.Looks.Next(flight)!;
        _track = track.Id;
        _pass = PassOver(flight, Revisits.PlaceOf(track, flight));
        _limit = PathFollower.TimeLimit(flight, flight.Position.DistanceTo(_pass.Start) + _pass.Length) + MaxHold;
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        if (flight.Desk.Failures >= MaxFailures)
            return ReturnToLaunch(flight.Desk.LastFailure);
        if (Revisits.Find(flight, _track) is not { State: TrackState.Confirmed } track)
            return Finish(flight, wasSeen: _overhead is not null, "it is no longer believed");
        if (inPhase > _limit)
            return Finish(flight, wasSeen: false, "it takes too long to get there");
        flight.Text = $"second look at track {MissionText.Of(_track)}, {Revisits.Name(track)}";
        return Fly(flight, track);
    }

    // From the side on which the vehicle is.
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
            flight.WantGoTo(_pass.Start, _height, _pass.HeadingRadians);
            _isAtStart = PathFollower.HasArrived(flight, _pass.Start, _height);
            return MissionStep.Stay;
        }

        flight.WantGoTo(_pass.End, _height, _pass.HeadingRadians);
        if (_overhead is null)
        {
            if (!PathFollower.HasArrived(flight, _pass.End, _height))
                return MissionStep.Stay;
            _overhead = flight.ActiveTime;
            _reportsBefore = track.Reports;
        }

        TimeSpan held = flight.ActiveTime - _overhead.Value;
        int reports = track.Reports - _reportsBefore;
        bool isEnough = held >= MinHold && reports >= ReportsWanted;
        return isEnough || held >= MaxHold
            ? Finish(flight, wasSeen: reports > 0, $"{MissionText.Of(reports)} reports more, 95 % within {MissionText.Of(track.Covariance.HalfMajorAxis95Metres)} m")
            : MissionStep.Stay;
    }

    private MissionStep Finish(MissionFlight flight, bool wasSeen, string text)
    {
        flight.Looks.Finish(_track, wasSeen);
        return new MissionStep(MissionEvent.Looked, $"track {MissionText.Of(_track)}: {text}");
    }
}
