using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Follows a segment as a fixed wing can, by two legs of one command each: a circle that touches the line of the
/// segment before its start, and when the vehicle comes round into the line a place far enough behind its end.
/// </summary>
/// <remarks>
/// Nothing corrects it on the way: the autopilot flies straight to the place. A circle is left in the direction of the
/// segment, whatever the wind and the way in which it was joined.
/// </remarks>
internal sealed class FixedWingFollower : ILaneFollower
{
    // The circle touches the line this far before the start, so that the turn out of it is over there.
    private const double LeadInRadii = 1;

    // An autopilot turns into the circle about a place a radius before it.
    private const double BehindInRadii = 1.5;

    // It is left within this of the direction, and of the line: circles are flown wider than commanded.
    private const double MaxAngleRadians = 15 * Math.PI / 180;
    private const double MaxOffsetInRadii = 0.4;

    // Without progress towards the circle for as long as a turn on it takes, and a reserve.
    private const double ReserveSeconds = 10;
    private const double ProgressMetres = 5;
    private const double OnCircleInRadii = 1.6;
    private const double MaxTurnsOnCircle = 3;
    private const double MaxSecondsOnLane = 10;

    private LaneSegment _segment;
    private PlanePoint _along;
    private PlanePoint _centre;
    private double _height;
    private double _radius;
    private double _turnSeconds;
    private double _best;
    private TimeSpan _progressTime;
    private TimeSpan? _onCircleSince;
    private bool _isOnLane;

    /// <inheritdoc/>
    public double FlownMetres { get; private set; }

    /// <inheritdoc/>
    public void Begin(MissionFlight flight, LaneSegment segment, double heightMetres)
    {
        (_segment, _height) = (segment, heightMetres);
        _radius = flight.Options.FixedWing!.LoiterRadiusMetres;
        _turnSeconds = 2 * Math.PI * _radius / flight.Mission.SpeedMetresPerSecond;
        _along = (1 / segment.Length) * (segment.End - segment.Start);

        // Clockwise: the centre lies to the right of the way.
        var right = new PlanePoint(-_along.East, _along.North);
        _centre = segment.Start - (LeadInRadii * _radius * _along) + (_radius * right);
        (_isOnLane, _onCircleSince, FlownMetres) = (false, null, 0);
        Note(flight, double.PositiveInfinity);
    }

    /// <inheritdoc/>
    public bool Tick(MissionFlight flight, out bool isLate)
    {
        PlanePoint way = flight.Position - _segment.Start;
        double flown = way.Dot(_along);
        if (!_isOnLane && IsInLine(flight, flown, _along.Cross(way)))
        {
            _isOnLane = true;
            Note(flight, flown);
        }

        isLate = _isOnLane ? IsLateOnLane(flight, flown) : IsLateToLane(flight);
        if (isLate)
            return false;
        if (!_isOnLane)
        {
            flight.SetGoalPosition(_centre, _height, _segment.HeadingRadians);
            return false;
        }

        FlownMetres = Math.Max(FlownMetres, flown);
        if (flown >= _segment.Length)
            return true;
        flight.SetGoalPosition(
            _segment.End + (BehindInRadii * _radius * _along), _height, _segment.HeadingRadians);
        return false;
    }

    // The goal is the circle by then, so that it is not left before it was commanded.
    private bool IsInLine(MissionFlight flight, double flown, double offset)
    {
        var velocity = new PlanePoint(flight.Vehicle.VelocityNed.North, flight.Vehicle.VelocityNed.East);
        return flight.GoalPosition.DistanceTo(_centre) <= 0 && flight.Commands.IsAccepted
            && flown <= 0 && flown >= -2 * LeadInRadii * _radius && Math.Abs(offset) <= MaxOffsetInRadii * _radius
            && velocity.Dot(_along) >= Trig.Cos(MaxAngleRadians) * velocity.Length && velocity.Length > 0;
    }

    private bool IsLateOnLane(MissionFlight flight, double flown)
    {
        if (flown >= _best + ProgressMetres)
            Note(flight, flown);
        return (flight.ActiveTime - _progressTime).ExactSeconds > MaxSecondsOnLane;
    }

    private bool IsLateToLane(MissionFlight flight)
    {
        double distance = flight.Position.DistanceTo(_centre);
        if (_onCircleSince is null && distance <= OnCircleInRadii * _radius)
            _onCircleSince = flight.ActiveTime;
        if (_onCircleSince is { } since)
            return (flight.ActiveTime - since).ExactSeconds > (MaxTurnsOnCircle * _turnSeconds) + ReserveSeconds;
        if (distance <= _best - ProgressMetres)
            Note(flight, distance);
        return (flight.ActiveTime - _progressTime).ExactSeconds > _turnSeconds + ReserveSeconds;
    }

    private void Note(MissionFlight flight, double best) => (_best, _progressTime) = (best, flight.ActiveTime);
}
