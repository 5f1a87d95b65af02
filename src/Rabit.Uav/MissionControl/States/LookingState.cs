using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Over one new target, coming across the lanes so that the camera sees it another way round, until it was seen a few times more.</summary>
internal sealed class LookingState() : MissionState(MissionPhase.Looking)
{
    private const int ReportsWanted = 4;

    private static readonly TimeSpan ShortestHold = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan LongestHold = TimeSpan.FromSeconds(10);

    private int _track;
    private int _reportsBefore;
    private LanePiece _pass;
    private bool _isAtStart;
    private TimeSpan? _overhead;
    private TimeSpan _limit;
    private double _height;

    public override void Enter(MissionFlight flight, MissionEvent by)
    {
        _height = flight.Mission.SecondLook.HeightMetres ?? flight.Mission.HeightMetres;
        _overhead = null;
        _isAtStart = !(flight.Mission.SecondLook.RadiusMetres > 0);
        TargetTrack track = flight.Looks.Next(flight)!;
        _track = track.Id;
        _pass = PassOver(flight, SecondLooks.PlaceOf(track, flight));
        _limit = LegPilot.TimeLimit(flight, flight.Position.DistanceTo(_pass.Start) + _pass.Length) + LongestHold;
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        if (flight.Desk.Failures >= MostFailures)
            return GoHome(flight.Desk.LastFailure);
        if (SecondLooks.Find(flight, _track) is not { State: TrackState.Confirmed } track)
            return Finish(flight, wasSeen: _overhead is not null, "it is no longer believed");
        if (inPhase > _limit)
            return Finish(flight, wasSeen: false, "it takes too long to get there");
        flight.Text = $"second look at track {MissionText.Of(_track)}, {SecondLooks.Name(track)}";
        return Fly(flight, track);
    }

    // From the side on which the vehicle is.
    private static LanePiece PassOver(MissionFlight flight, PlanePoint target)
    {
        PlanePoint across = PlanePoint.Towards(flight.Plan!.HeadingRadians + (Math.PI / 2));
        double side = across.Dot(target - flight.Position) >= 0 ? 1 : -1;
        double radius = Math.Max(1, flight.Mission.SecondLook.RadiusMetres);
        return new LanePiece(target - (radius * side * across), target);
    }

    private MissionStep Fly(MissionFlight flight, TargetTrack track)
    {
        if (!_isAtStart)
        {
            flight.WantGoTo(_pass.Start, _height, _pass.HeadingRadians);
            _isAtStart = LegPilot.HasArrived(flight, _pass.Start, _height);
            return MissionStep.Stay;
        }

        flight.WantGoTo(_pass.End, _height, _pass.HeadingRadians);
        if (_overhead is null)
        {
            if (!LegPilot.HasArrived(flight, _pass.End, _height))
                return MissionStep.Stay;
            _overhead = flight.ActiveTime;
            _reportsBefore = track.Reports;
        }

        TimeSpan held = flight.ActiveTime - _overhead.Value;
        int reports = track.Reports - _reportsBefore;
        bool isEnough = held >= ShortestHold && reports >= ReportsWanted;
        return isEnough || held >= LongestHold
            ? Finish(flight, wasSeen: reports > 0, $"{MissionText.Of(reports)} reports more, 95 % within {MissionText.Of(track.Covariance.HalfMajorAxis95Metres)} m")
            : MissionStep.Stay;
    }

    private MissionStep Finish(MissionFlight flight, bool wasSeen, string text)
    {
        flight.Looks.Finish(_track, wasSeen);
        return new MissionStep(MissionEvent.Looked, $"track {MissionText.Of(_track)}: {text}");
    }
}
