using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Flies a leg: to its start, and along it by points that lie ahead of the vehicle on the leg, so that it comes back to the line where
/// the wind has put it off. A new point is commanded when the last one comes near, not all the time.
/// </summary>
internal sealed class PathFollower
{
    /// <summary>So near is there.</summary>
    public const double ArrivalMetres = 2;

    // Slower than this a vehicle has stopped to turn.
    private const double SlowMetresPerSecond = 1.5;

    // How far ahead the point is, at least: in flying time, and further than a vehicle needs to brake.
    private const double AheadSeconds = 3;
    private const double MinLookaheadMetres = 15;
    private const double BrakingMetresPerSecondSquared = 1.5;

    // Three times what it should take, and time to turn and to accelerate.
    private const double TimeFactor = 3;
    private const double TimeReserveSeconds = 60;

    private LaneSegment _leg;
    private double _height;
    private double _aheadMetres;
    private double _targetMetres;
    private TimeSpan _until;
    private bool _isOnLeg;

    /// <summary>Whether the start of the leg has been reached.</summary>
    public bool IsOnLeg => _isOnLeg;

    /// <summary>Begins a leg.</summary>
    public void Begin(MissionFlight flight, LaneSegment leg, double heightMetres)
    {
        double speed = flight.Mission.SpeedMetresPerSecond;
        _leg = leg;
        _height = heightMetres;
        double brakingMetres = speed * speed / (2 * BrakingMetresPerSecondSquared);
        _aheadMetres = Math.Max(Math.Max(MinLookaheadMetres, AheadSeconds * speed), brakingMetres);
        _targetMetres = 0;
        _isOnLeg = false;
        _until = flight.ActiveTime + TimeLimit(flight, flight.Position.DistanceTo(leg.Start) + leg.Length);
    }

    /// <summary>How long a way may take.</summary>
    public static TimeSpan TimeLimit(MissionFlight flight, double metres)
        => TimeSpan.FromSeconds(TimeReserveSeconds + (TimeFactor * metres / flight.Mission.SpeedMetresPerSecond));

    /// <summary>Whether the vehicle is at a point and has stopped.</summary>
    public static bool HasArrived(MissionFlight flight, PlanePoint at, double heightMetres)
        => flight.Position.DistanceTo(at) <= ArrivalMetres && flight.GroundSpeed <= SlowMetresPerSecond
            && Math.Abs(flight.HeightMetres - heightMetres) <= ArrivalMetres;

    /// <summary>Goes on.</summary>
    /// <param name="flight">Everything there is to know.</param>
    /// <param name="isLate">Whether it takes far longer than it should.</param>
    /// <returns>Whether the leg is flown.</returns>
    public bool Tick(MissionFlight flight, out bool isLate)
    {
        isLate = flight.ActiveTime > _until;
        if (!_isOnLeg)
        {
            flight.WantGoTo(_leg.Start, _height, _leg.HeadingRadians);
            _isOnLeg = HasArrived(flight, _leg.Start, _height);
            if (!_isOnLeg)
                return false;
        }

        PlanePoint along = (1 / _leg.Length) * (_leg.End - _leg.Start);
        double flown = (flight.Position - _leg.Start).Dot(along);
        if (flown >= _leg.Length - ArrivalMetres)
            return true;
        while (_targetMetres < _leg.Length && _targetMetres < flown + _aheadMetres)
            _targetMetres = Math.Min(_leg.Length, _targetMetres + (_aheadMetres / 2));
        flight.WantGoTo(_leg.Start + (_targetMetres * along), _height, _leg.HeadingRadians);
        return false;
    }
}
