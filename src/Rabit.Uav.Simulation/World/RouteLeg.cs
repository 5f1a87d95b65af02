using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A straight way or an arc, from one speed to another: faster as far as the acceleration allows, then as fast as it
/// may, then slower. Ends with a pause. Immutable.
/// </summary>
internal sealed class RouteLeg
{
    private readonly NedPosition _start;
    private readonly double _heading;
    private readonly double _turnPerMetre;
    private readonly double _length;
    private readonly double _startSpeed;
    private readonly double _topSpeed;
    private readonly double _acceleration;
    private readonly double _speedUp;
    private readonly double _steady;
    private readonly double _slowDown;

    /// <param name="start">Where it begins.</param>
    /// <param name="heading">The course at its beginning, radians clockwise from north.</param>
    /// <param name="turnPerMetre">0 for a straight way; one over the radius for an arc, positive to the right.</param>
    /// <param name="length">Metres, above 0.</param>
    /// <param name="speeds">At its start, at most, and at its end, m/s; the end must be within reach.</param>
    /// <param name="acceleration">Along the way, m/s2.</param>
    /// <param name="pause">How long the target stands at its end, seconds.</param>
    public RouteLeg(
        NedPosition start, double heading, double turnPerMetre, double length,
        (double Start, double Top, double End) speeds, double acceleration, double pause)
    {
        (_start, _heading, _turnPerMetre, _length) = (start, heading, turnPerMetre, length);
        (_startSpeed, _acceleration) = (speeds.Start, acceleration);

        // Speeding up and slowing down take the whole of a short way.
        double start2 = speeds.Start * speeds.Start;
        double end2 = speeds.End * speeds.End;
        _topSpeed = Math.Min(speeds.Top, Math.Sqrt((acceleration * length) + ((start2 + end2) / 2)));
        double top2 = _topSpeed * _topSpeed;
        double left = length - (((2 * top2) - start2 - end2) / (2 * acceleration));
        _speedUp = (_topSpeed - speeds.Start) / acceleration;
        _slowDown = (_topSpeed - speeds.End) / acceleration;
        _steady = Math.Max(0, left) / _topSpeed;
        Seconds = _speedUp + _steady + _slowDown + pause;
        HasPause = pause > 0;
    }

    /// <summary>How long it takes, with the pause.</summary>
    public double Seconds { get; }

    private bool HasPause { get; }

    public NedPosition PositionAt(double seconds)
    {
        double way = WayAt(seconds);
        if (_turnPerMetre == 0)
            return _start + new NedVector(way * Trig.Cos(_heading), way * Trig.Sin(_heading), 0);
        double turned = _heading + (way * _turnPerMetre);
        return _start + new NedVector(
            (Trig.Sin(turned) - Trig.Sin(_heading)) / _turnPerMetre,
            (Trig.Cos(_heading) - Trig.Cos(turned)) / _turnPerMetre, 0);
    }

    public NedVector VelocityAt(double seconds)
    {
        double speed = SpeedAt(seconds);
        double heading = _heading + (WayAt(seconds) * _turnPerMetre);
        return new NedVector(speed * Trig.Cos(heading), speed * Trig.Sin(heading), 0);
    }

    private double WayAt(double seconds)
    {
        double up = Math.Min(seconds, _speedUp);
        double steady = Math.Min(Math.Max(0, seconds - _speedUp), _steady);
        double down = Math.Min(Math.Max(0, seconds - _speedUp - _steady), _slowDown);
        double way = (up * (_startSpeed + (_acceleration * up / 2))) + (steady * _topSpeed)
            + (down * (_topSpeed - (_acceleration * down / 2)));
        return Math.Min(way, _length);
    }

    private double SpeedAt(double seconds)
    {
        if (seconds < _speedUp)
            return _startSpeed + (_acceleration * seconds);
        double down = seconds - _speedUp - _steady;
        return down <= 0 ? _topSpeed
            : down < _slowDown || !HasPause ? Math.Max(0, _topSpeed - (_acceleration * down)) : 0;
    }
}
