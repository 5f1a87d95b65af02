using System;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Power of a multirotor: hover + drag * airspeed^3 + climb * climb rate. The three are learnt in flight by a Kalman
/// filter that begins with the prior. The parasite power of a rotorcraft grows with the cube of the airspeed (J. G.
/// Leishman, "Principles of Helicopter Aerodynamics", section 5.4). No time, no I/O; one thread.
/// </summary>
internal sealed class PowerModel
{
    private const int Count = 3;

    // The prior may be of another propeller or load, and less is known of its drag.
    private const double HoverDeviation = 0.25;
    private const double OtherDeviation = 0.5;

    // A second of flight: gusts, accelerations and what the model leaves out, which last for some seconds.
    private const double NoiseOfHover = 0.3;

    // Per measurement, of the prior's deviation: a load is dropped, an arm ices.
    private const double Drift = 0.005;

    // Of the airspeed, m/s: by it the drag is known less well the faster it flies.
    private const double AirspeedDeviation = 1.5;

    // Nothing flies on less.
    private const double MinPartOfHover = 0.1;

    // Keeps the numbers near one another: airspeed in units of 10 m/s.
    private const double SpeedUnit = 10;

    private readonly double[] _values;
    private readonly double[] _deviations;
    private readonly double[,] _covariance = new double[Count, Count];
    private readonly double[] _terms = new double[Count];
    private readonly double[] _gain = new double[Count];
    private readonly double _noise;
    private readonly double _minHover;

    public PowerModel(EnergyOptions prior)
    {
        double drag = prior.DragWattsPerCubedSpeed * SpeedUnit * SpeedUnit * SpeedUnit;
        _values = [prior.HoverWatts, drag, prior.ClimbWattsPerMetrePerSecond];
        _deviations =
        [
            HoverDeviation * prior.HoverWatts, OtherDeviation * drag,
            OtherDeviation * prior.ClimbWattsPerMetrePerSecond,
        ];
        (_noise, _minHover) = (NoiseOfHover * prior.HoverWatts, MinPartOfHover * prior.HoverWatts);
        for (int i = 0; i < Count; i++)
            _covariance[i, i] = _deviations[i] * _deviations[i];
    }

    /// <summary>Power in hover without wind.</summary>
    public double HoverWatts => _values[0];

    /// <summary>What a climb adds, watts per metre per second.</summary>
    public double ClimbWattsPerMetrePerSecond => _values[2];

    /// <summary>The power to be expected, watts. A descent is not counted as a gain.</summary>
    /// <param name="airspeed">Horizontal, m/s.</param>
    /// <param name="climbRate">m/s, up positive.</param>
    public double Watts(double airspeed, double climbRate = 0)
    {
        SetTerms(airspeed, Math.Max(0, climbRate));
        double watts = 0;
        for (int i = 0; i < Count; i++)
            watts += _terms[i] * _values[i];
        return watts;
    }

    /// <summary>Its standard deviation.</summary>
    public double Deviation(double airspeed)
    {
        SetTerms(airspeed, climbRate: 0);
        double variance = 0;
        for (int i = 0; i < Count; i++)
        {
            for (int j = 0; j < Count; j++)
                variance += _terms[i] * _covariance[i, j] * _terms[j];
        }

        return Math.Sqrt(Math.Max(0, variance));
    }

    /// <summary>Takes a power that was measured in flight.</summary>
    /// <param name="watts">What was measured.</param>
    /// <param name="cubedAirspeed">Mean of the cube of the airspeed in that time, (m/s)^3.</param>
    /// <param name="climbRate">Mean, m/s, up positive.</param>
    /// <param name="seconds">How long: the noise of a longer one is smaller.</param>
    public void Update(double watts, double cubedAirspeed, double climbRate, double seconds)
    {
        // One that is no number would leave none in the model, for good.
        double sum = watts + cubedAirspeed + climbRate + seconds;
        if (double.IsNaN(sum) || double.IsInfinity(sum))
            return;
        SetTerms(0, climbRate);
        _terms[1] = cubedAirspeed / (SpeedUnit * SpeedUnit * SpeedUnit);
        double ofAirspeed = 3 * _values[1] / SpeedUnit * Math.Pow(_terms[1], 2.0 / 3) * AirspeedDeviation;
        double variance = ((_noise * _noise) + (ofAirspeed * ofAirspeed)) / Math.Max(1, seconds);
        double error = watts;
        for (int i = 0; i < Count; i++)
        {
            _covariance[i, i] += Drift * Drift * _deviations[i] * _deviations[i];
            error -= _terms[i] * _values[i];
        }

        for (int i = 0; i < Count; i++)
        {
            _gain[i] = 0;
            for (int j = 0; j < Count; j++)
                _gain[i] += _covariance[i, j] * _terms[j];
            variance += _terms[i] * _gain[i];
        }

        for (int i = 0; i < Count; i++)
            _values[i] = Math.Max(0, _values[i] + (_gain[i] * error / variance));
        _values[0] = Math.Max(_values[0], _minHover);
        for (int i = 0; i < Count; i++)
        {
            for (int j = 0; j < Count; j++)
                _covariance[i, j] -= _gain[i] * _gain[j] / variance;
        }
    }

    private void SetTerms(double airspeed, double climbRate)
    {
        double speed = airspeed / SpeedUnit;
        (_terms[0], _terms[1], _terms[2]) = (1, speed * speed * speed, climbRate);
    }
}
