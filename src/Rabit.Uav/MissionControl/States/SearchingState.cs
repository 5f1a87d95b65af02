using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Lane after lane; between two of them new targets are looked at; at the end what was missed is flown over again.</summary>
internal sealed class SearchingState() : MissionState(MissionPhase.Searching)
{
    // The last pictures of a lane are still being looked through.
    private static readonly TimeSpan Settling = TimeSpan.FromSeconds(1.5);

    private readonly PathFollower _pilot = new();
    private TimeSpan? _laneEnd;
    private bool _isOnItsWay;

    public override void Enter(MissionFlight flight, MissionEvent by) => _isOnItsWay = false;

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        if (flight.Desk.Failures >= MaxFailures)
            return ReturnToLaunch(flight.Desk.LastFailure);
        if (_laneEnd is { } end && flight.ActiveTime - end < Settling && flight.Route!.Current is null)
            return MissionStep.Stay;
        if (!_isOnItsWay && flight.Looks.Next(flight) is { } track)
            return new MissionStep(MissionEvent.TargetFound, $"track {MissionText.Of(track.Id)}");
        if (flight.Route!.Current is { } lane)
            return Fly(flight, lane);
        return Finish(flight);
    }

    private MissionStep Fly(MissionFlight flight, LaneSegment lane)
    {
        SearchRoute route = flight.Route!;
        if (!_isOnItsWay)
            _pilot.Begin(flight, lane, flight.Mission.HeightMetres);
        _isOnItsWay = true;
        flight.Text = $"searching: lane {MissionText.Of(route.Flown + 1)} of {MissionText.Of(route.Count)}, {MissionText.Percent(route.Coverage.Fraction)} seen";
        bool isFlown = _pilot.Tick(flight, out bool isLate);
        if (isLate)
            return ReturnToLaunch($"lane {MissionText.Of(route.Flown + 1)} takes too long");
        if (!isFlown)
            return MissionStep.Stay;
        _isOnItsWay = false;
        _laneEnd = flight.ActiveTime;
        route.FinishLeg();
        flight.Log($"lane {MissionText.Of(route.Flown)} of {MissionText.Of(route.Count)} flown, {MissionText.Percent(route.Coverage.Fraction)} seen");
        return MissionStep.Stay;
    }

    private static MissionStep Finish(MissionFlight flight)
    {
        SearchRoute route = flight.Route!;
        string seen = MissionText.Percent(route.Coverage.Fraction) + " seen";
        if (route.Coverage.Fraction >= flight.Options.CoverageGoal)
            return new MissionStep(MissionEvent.Searched, seen);
        if (route.GapPasses >= flight.Options.GapPasses)
            return new MissionStep(MissionEvent.Searched, seen + ", what is missing was flown over again");
        int legs = route.AddGapLegs(flight.Position);
        if (legs == 0)
            return new MissionStep(MissionEvent.Searched, seen + ", what is missing is too small to fly over");
        flight.Log($"{seen}: {MissionText.Of(legs)} more legs over what was missed");
        return MissionStep.Stay;
    }
}
