using System;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// Where a target is, how it moves, and in which mode of its <see cref="MotionModel"/> it is: with two modes the
/// interacting multiple models of Blom and Bar-Shalom (IEEE Trans. Automatic Control 33(8), 1988). Fixed room; for one
/// thread.
/// </summary>
internal sealed class MotionFilter
{
    private const int N = 4;

    private readonly ConsiderFilter[] _modes = [new(), new()];
    private readonly ConsiderFilter[] _mixed = [new(), new()];
    private readonly double[] _weights = [1, 0];
    private readonly double[] _sums = [0, 0];
    private MotionModel _model = null!;

    /// <summary>How many modes it has.</summary>
    public int Modes => _model.Modes;

    /// <summary>Whether it has a state.</summary>
    public bool IsStarted { get; private set; }

    /// <summary>The time of the state.</summary>
    public TimeSpan Time { get; private set; }

    public double North => Mean(0);

    public double NorthRate => Mean(1);

    public double East => Mean(2);

    public double EastRate => Mean(3);

    /// <summary>How likely the target is in the second mode, in which it turns, brakes or starts.</summary>
    public double LivelyProbability => _weights[1];

    public void Clear(MotionModel model)
    {
        _model = model;
        IsStarted = false;
    }

    /// <summary>Goes on with another model of as many modes.</summary>
    public void ChangeModel(MotionModel model) => _model = model;

    public void CopyFrom(MotionFilter other)
    {
        _model = other._model;
        IsStarted = other.IsStarted;
        Time = other.Time;
        for (int mode = 0; mode < _model.Modes; mode++)
        {
            _modes[mode].CopyFrom(other._modes[mode]);
            _weights[mode] = other._weights[mode];
        }
    }

    /// <summary>Starts with a state that is known from elsewhere.</summary>
    /// <param name="time">The time of the state.</param>
    /// <param name="state">N, vN, E, vE.</param>
    /// <param name="upperTriangle">Of its covariance, row by row.</param>
    public void Start(TimeSpan time, ReadOnlySpan<double> state, ReadOnlySpan<double> upperTriangle)
    {
        for (int mode = 0; mode < _model.Modes; mode++)
            _modes[mode].Start(state, upperTriangle);
        Start(time);
    }

    /// <summary>States how the error depends on the registration error of a source: four rows of two.</summary>
    public void Correlate(int slot, ReadOnlySpan<double> correlation)
    {
        for (int mode = 0; mode < _model.Modes; mode++)
            _modes[mode].Correlate(slot, correlation);
    }

    /// <summary>How the error of all modes together depends on the registration error of a source.</summary>
    /// <param name="slot">That of the source.</param>
    /// <param name="correlation">Four rows of two.</param>
    public void CopyCorrelationTo(int slot, Span<double> correlation)
    {
        correlation.Clear();
        for (int mode = 0; mode < _model.Modes; mode++)
        {
            ReadOnlySpan<double> c = _modes[mode].Correlation(slot);
            for (int i = 0; i < c.Length; i++)
                correlation[i] += (_model.Modes == 1 ? 1 : _weights[mode]) * c[i];
        }
    }

    /// <summary>Goes to the time of a measurement and takes it in; starts with it, if it is the first.</summary>
    /// <returns>How likely it was there, per square metre; 1 for the first.</returns>
    public double Take(in TrackMeasurement measurement, RegistrationSlots slots)
    {
        int slot = slots.Of(measurement);
        TrackMeasurement measured = slot >= 0 ? measurement with { Registration = slots[slot] } : measurement;
        if (!IsStarted)
        {
            for (int mode = 0; mode < _model.Modes; mode++)
                _modes[mode].Start(measured, slot, _model.StartVelocitySigma);
            Start(measured.Time);
            return 1;
        }

        PredictTo(measured.Time);
        if (_model.Modes == 1)
            return _modes[0].Update(measured, slot, slots.Count).Likelihood;

        double first = _weights[0] * _modes[0].Update(measured, slot, slots.Count).Likelihood;
        double second = _weights[1] * _modes[1].Update(measured, slot, slots.Count).Likelihood;
        double sum = first + second;

        // Far outside both, where neither likelihood is a number above 0, they say nothing on the mode.
        if (sum > 1e-300)
            (_weights[0], _weights[1]) = (first / sum, second / sum);
        return sum;
    }

    /// <summary>Goes on to a time; back to an earlier one only to compare, not to take measurements in.</summary>
    public void PredictTo(TimeSpan time)
    {
        double seconds = (time - Time).ExactSeconds;
        if (_model.Modes == 2 && seconds > 0)
            Mix(seconds);
        for (int mode = 0; mode < _model.Modes; mode++)
            _modes[mode].Predict(seconds, _model.ProcessNoise(mode));
        Time = time;
    }

    /// <summary>What it expects in one of its modes, and how likely that mode is.</summary>
    /// <param name="mode">From 0.</param>
    /// <param name="slot">That of the source of the measurements to come; -1 for none.</param>
    /// <param name="registration">The covariance of the registration error of that source.</param>
    public ExpectedPlace Expect(int mode, int slot, HorizontalCovariance registration)
        => new(
            _weights[mode],
            _modes[mode].State[0],
            _modes[mode].State[2],
            _modes[mode].ExpectedCovariance(slot) + registration);

    /// <summary>That of the place, of all modes together.</summary>
    public HorizontalCovariance PositionCovariance
    {
        get
        {
            HorizontalCovariance sum = default;
            for (int mode = 0; mode < _model.Modes; mode++)
            {
                double north = _modes[mode].State[0] - North;
                double east = _modes[mode].State[2] - East;
                HorizontalCovariance c = _modes[mode].PositionCovariance;
                sum += new HorizontalCovariance(
                    _weights[mode] * (c.NorthNorth + (north * north)), _weights[mode] * (c.NorthEast + (north * east)),
                    _weights[mode] * (c.EastEast + (east * east)));
            }

            return sum;
        }
    }

    /// <summary>The covariance of all modes together: sixteen numbers, row by row.</summary>
    public void CopyCovarianceTo(Span<double> covariance)
    {
        covariance.Clear();
        for (int mode = 0; mode < _model.Modes; mode++)
        {
            double weight = _weights[mode];
            double[] x = _modes[mode].State;
            double[] p = _modes[mode].Covariance;
            for (int row = 0; row < N; row++)
            {
                for (int column = 0; column < N; column++)
                {
                    double spread = _model.Modes == 1 ? 0 : (x[row] - Mean(row)) * (x[column] - Mean(column));
                    covariance[(row * N) + column] += weight * (p[(row * N) + column] + spread);
                }
            }
        }
    }

    private void Start(TimeSpan time)
    {
        (IsStarted, Time) = (true, time);
        double lively = _model.Modes == 1
            ? 0
            : _model.LeaveQuietPerSecond / (_model.LeaveQuietPerSecond + _model.LeaveLivelyPerSecond);
        (_weights[0], _weights[1]) = (1 - lively, lively);
    }

    private double Mean(int row)
        => _model.Modes == 1
            ? _modes[0].State[row]
            : (_weights[0] * _modes[0].State[row]) + (_weights[1] * _modes[1].State[row]);

    private void Mix(double seconds)
    {
        for (int to = 0; to < 2; to++)
        {
            double first = _weights[0] * _model.Transition(0, to, seconds);
            double second = _weights[1] * _model.Transition(1, to, seconds);
            double sum = first + second;
            _mixed[to].Mix(_modes[0], first / sum, _modes[1], second / sum);
            _sums[to] = sum;
        }

        for (int mode = 0; mode < 2; mode++)
        {
            (_modes[mode], _mixed[mode]) = (_mixed[mode], _modes[mode]);
            _weights[mode] = _sums[mode];
        }
    }
}
