using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>
/// The companion's stream of set-points: 20 Hz, along legs that begin and end with 1.5 m/s2, as in the recorded
/// flights, with the velocity as feed-forward.
/// </summary>
internal sealed class Px4Path(Px4Flyer flyer)
{
    private const double Acceleration = 1.5;
    private const double Period = 0.05;
    private const double Height = 12;

    private bool _isOn;
    private double _next;
    private NedPosition _start;
    private double _legStart = double.NegativeInfinity;
    private double _bearing;
    private double _length;
    private double _speed;

    public bool IsOn => _isOn;

    /// <summary>Begins where the vehicle reports that it is.</summary>
    public void Start()
    {
        _isOn = true;
        _next = flyer.Time;
        _length = 0;
        _start = Reported();
    }

    public void Stop() => _isOn = false;

    /// <summary>A leg from where the vehicle reports that it is.</summary>
    public void Fly(double bearingDegrees, double length, double speed)
    {
        _start = Reported();
        _bearing = bearingDegrees * Math.PI / 180;
        (_length, _speed, _legStart) = (length, speed, flyer.Time);
    }

    public void Step()
    {
        if (!_isOn || flyer.Time < _next)
            return;
        _next += Period;
        (double north, double east, double speed) = Now();
        GeodeticPosition place = LocalNedFrame.IgnoringGeoid(flyer.Home)
            .ToGeodetic(new NedPosition(north, east, -Height));
        flyer.Send(0, new SetPositionTargetGlobalInt
        {
            TargetSystem = 1,
            TargetComponent = 1,
            CoordinateFrame = MavFrame.GlobalRelativeAltInt,
            TypeMask = (PositionTargetTypemask)0x9C0,
            LatInt = (int)Math.Round(place.Latitude.Degrees * 1e7),
            LonInt = (int)Math.Round(place.Longitude.Degrees * 1e7),
            Alt = (float)Height,
            Vx = (float)(speed * Math.Cos(_bearing)),
            Vy = (float)(speed * Math.Sin(_bearing)),
            Yaw = (float)_bearing,
        }, 1, 191);
    }

    private NedPosition Reported()
    {
        GlobalPositionInt here = flyer.All<GlobalPositionInt>().Last().Message;
        GeodeticPosition place = GeodeticPosition.FromDegrees(here.Lat * 1e-7, here.Lon * 1e-7, here.Alt * 1e-3);
        return LocalNedFrame.IgnoringGeoid(flyer.Home).ToNed(place);
    }

    /// <summary>Where the set-point is now, and how fast it moves.</summary>
    private (double North, double East, double Speed) Now()
    {
        (double along, double speed) = _length > 0 ? Along(flyer.Time - _legStart) : (0, 0);
        return (_start.North + (along * Math.Cos(_bearing)), _start.East + (along * Math.Sin(_bearing)), speed);
    }

    private (double Along, double Speed) Along(double time)
    {
        double ramp = _speed / Acceleration;
        double cruise = Math.Max(0, (_length / _speed) - ramp);
        if (time < ramp)
            return (0.5 * Acceleration * time * time, Acceleration * time);
        if (time < ramp + cruise)
            return ((0.5 * _speed * ramp) + (_speed * (time - ramp)), _speed);
        double left = (2 * ramp) + cruise - time;
        return left > 0 ? (_length - (0.5 * Acceleration * left * left), Acceleration * left) : (_length, 0);
    }
}
