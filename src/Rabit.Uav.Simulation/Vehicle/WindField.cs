using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Wind: a mean and a gust on each horizontal axis, Ornstein-Uhlenbeck with a standard deviation of a fifth of the
/// mean speed and a time constant of 5 s. The same at every height.
/// </summary>
internal sealed class WindField
{
    private const double GustPart = 0.2;
    private const double GustSeconds = 5;

    // A new mean comes as weather does, not as a blow.
    private const double ChangeSeconds = 2;

    private readonly ColouredNoise _north;
    private readonly ColouredNoise _east;
    private readonly double _toNorth;
    private readonly double _toEast;
    private readonly double _step;
    private double _mean;

    /// <param name="random">Its stream.</param>
    /// <param name="meanSpeed">m/s.</param>
    /// <param name="fromRadians">Where it comes from, clockwise from north.</param>
    /// <param name="step">Seconds of a step.</param>
    public WindField(SimulationRandom random, double meanSpeed, double fromRadians, double step)
    {
        MeanSpeed = _mean = meanSpeed;
        _toNorth = -Trig.Cos(fromRadians);
        _toEast = -Trig.Sin(fromRadians);
        _step = step;

        // Of unit strength here; the mean at the time scales what comes in.
        _north = new ColouredNoise(random, 1, GustSeconds, step, startsAtZero: true);
        _east = new ColouredNoise(random, 1, GustSeconds, step, startsAtZero: true);
    }

    /// <summary>What the mean is, or is on its way to, m/s.</summary>
    public double MeanSpeed { get; set; }

    /// <summary>By how much the wind is stronger now than it would be, m/s.</summary>
    public double Gust { get; set; }

    /// <summary>Velocity of the air over ground, m/s.</summary>
    public NedVector Velocity { get; private set; }

    public void Step()
    {
        _mean += (MeanSpeed - _mean) * _step / ChangeSeconds;
        _north.Step(GustPart * _mean);
        _east.Step(GustPart * _mean);
        Velocity = new NedVector(
            (_toNorth * (_mean + Gust)) + _north.Value, (_toEast * (_mean + Gust)) + _east.Value, 0);
    }
}
