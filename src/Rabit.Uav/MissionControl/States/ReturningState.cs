using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Return to launch (RTL), by the autopilot's own mode; the progress is monitored.</summary>
internal sealed class ReturningState() : MissionState(MissionPhase.Returning)
{
    private const double OverHomeMetres = 6;
    private const double SinkingMetresPerSecond = 0.2;
    private const double ProgressMetres = 3;

    // Longer than autopilots loiter over home before they land.
    private const double MaxSecondsWithoutProgress = 40;
    private const double TimeReserveSeconds = 180;

    // It brakes first, and PX4 goes back to where its return began, at 0.4 m/s: until then any way is progress.
    private const double StartSeconds = 120;
    private const double MinDescentRate = 0.3;

    // RTL circles over home; what passes it is farther away again by then.
    private const double OverHomeInRadii = 2.5;
    private static readonly TimeSpan OverHomeTime = TimeSpan.FromSeconds(10);

    private TimeSpan? _overHomeSince;
    private TimeSpan _limit;
    private TimeSpan _progressTime;
    private double _lastDistance;
    private double _lastHeight;
    private PlanePoint _lastPosition;
    private bool _wasSentAgain;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
        double distance = flight.DistanceFromHomeMetres;
        _limit = PathFollower.TimeLimit(flight, double.IsNaN(distance) ? FlightPlan.MaxAreaDistanceMetres : distance)
            + Seconds(TimeReserveSeconds + (flight.HeightMetres / MinDescentRate));
        (_progressTime, _lastDistance, _lastHeight) = (flight.ActiveTime, distance, flight.HeightMetres);
        _lastPosition = flight.Position;
        _wasSentAgain = false;
        _overHomeSince = null;
    }

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        flight.SetGoal(VehicleCommandKind.Return, "return");
        double distance = flight.DistanceFromHomeMetres;
        flight.Text = $"returning: {flight.DistanceText}"
            + (flight.Aborted is null ? string.Empty : "; " + flight.Aborted);
        if (flight.Vehicle.LandedState is MavLandedState.Landing or MavLandedState.OnGround || !flight.Vehicle.IsArmed)
            return new MissionStep(MissionEvent.Descending, flight.DistanceText);
        if (flight.IsFixedWing)
            return CircleOverHome(flight, distance);
        if (distance < OverHomeMetres && flight.Vehicle.VelocityNed.Down > SinkingMetresPerSecond)
            return new MissionStep(MissionEvent.Descending, flight.DistanceText);
        if (flight.Commands.Failures >= MaxFailures)
            return new MissionStep(MissionEvent.LandNow, "return " + flight.Commands.LastFailure);
        if (inPhase > _limit)
            return new MissionStep(MissionEvent.LandNow, $"not home within {MissionNumbers.Seconds(_limit)}");
        return CheckProgress(flight, distance, isStart: inPhase < Seconds(StartSeconds));
    }

    // It is never landed where it is: a fixed wing that does not return is its pilot's.
    private MissionStep CircleOverHome(MissionFlight flight, double distance)
    {
        double radius = (flight.Options.FixedWing ?? new FixedWingOptions()).LoiterRadiusMetres;
        bool isOverHome = distance <= OverHomeInRadii * radius && flight.Commands.IsAccepted;
        _overHomeSince = isOverHome ? _overHomeSince ?? flight.ActiveTime : null;
        return flight.ActiveTime - _overHomeSince >= OverHomeTime
            ? new MissionStep(MissionEvent.OverHome, "it circles over home until its pilot lands it")
            : MissionStep.Stay;
    }

    private MissionStep CheckProgress(MissionFlight flight, double distance, bool isStart)
    {
        // Where home is not known any way counts.
        bool isNearer = double.IsNaN(distance) || isStart
            ? flight.Position.DistanceTo(_lastPosition) > ProgressMetres
            : distance < _lastDistance - ProgressMetres;
        bool hasProgress = isNearer
            || Math.Abs(flight.HeightMetres - _lastHeight) > ProgressMetres;
        if (hasProgress)
        {
            (_progressTime, _lastDistance, _lastHeight) = (flight.ActiveTime, distance, flight.HeightMetres);
            _lastPosition = flight.Position;
        }

        if (flight.ActiveTime - _progressTime < Seconds(MaxSecondsWithoutProgress))
            return MissionStep.Stay;
        if (_wasSentAgain)
            return new MissionStep(MissionEvent.LandNow, "no progress towards home");
        flight.Log("no progress towards home");
        flight.Commands.Resend();
        _wasSentAgain = true;
        _progressTime = flight.ActiveTime;
        return MissionStep.Stay;
    }
}
