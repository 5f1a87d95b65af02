using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Two wheel ruts that wind through the ground from north to south, and come back to where they began after one
/// period of it. A plain value.
/// </summary>
internal readonly struct FarmTrack
{
    private const double HalfGauge = 1.0;
    private const double HalfRut = 0.45;

    private readonly double _period;
    private readonly double _middle;
    private readonly double _swing;
    private readonly double _phase;

    public FarmTrack(double period, ref SeededSequence random)
    {
        _period = period;
        _middle = period * random.NextUnit();
        _swing = period * (0.04 + (0.06 * random.NextUnit()));
        _phase = 2 * Math.PI * random.NextUnit();
    }

    /// <summary>How far east the middle of the track is; metres within one period.</summary>
    public double LineAt(double north)
    {
        double turn = 2 * Math.PI * north / _period;
        return _middle + (_swing * Trig.Sin(turn + _phase)) + (0.3 * _swing * Trig.Sin((3 * turn) + (2 * _phase)));
    }

    /// <summary>How bare the ground is, 0 to 1; metres within one period.</summary>
    /// <param name="line">The middle of the track there.</param>
    /// <param name="east">The place.</param>
    public double BareAt(double line, double east)
    {
        double off = east - line;
        off -= _period * Math.Floor((off / _period) + 0.5);
        double fromRut = Math.Abs(Math.Abs(off) - HalfGauge);
        return Math.Max(0, Math.Min(1, (2 * HalfRut) - fromRut));
    }
}
