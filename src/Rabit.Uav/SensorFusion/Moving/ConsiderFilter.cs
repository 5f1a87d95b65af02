using System;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>
/// Kalman filter of one target on the ground, N, vN, E, vE, under white acceleration, that does not estimate the
/// registration errors of its sources but considers them: it keeps how its error depends on each, so that a thousand
/// reports of one vehicle never make it surer than that vehicle's frame is (Schmidt 1966; Bar-Shalom, Li, Kirubarajan,
/// "Estimation with Applications to Tracking and Navigation"). Without them it is the plain filter, Joseph form. Fixed
/// room; for one thread.
/// </summary>
internal sealed class ConsiderFilter
{
    private const int N = 4;

    private readonly double[] _p = new double[N * N];

    // Of each slot, the covariance of the state's error with its registration error: four rows of two. What is behind
    // those in use is 0, whatever stands there.
    private readonly double[] _c = new double[RegistrationSlots.Capacity * N * 2];
    private int _used;

    public double[] State { get; } = new double[N];

    /// <summary>All sixteen numbers, row by row.</summary>
    public double[] Covariance => _p;

    public HorizontalCovariance PositionCovariance => new(_p[0], _p[2], _p[10]);

    public void CopyFrom(ConsiderFilter other)
    {
        Array.Copy(other.State, State, N);
        Array.Copy(other._p, _p, N * N);
        Array.Copy(other._c, _c, other._used);
        _used = other._used;
    }

    /// <summary>Starts with a state and the upper triangle of its covariance, without registration errors.</summary>
    public void Start(ReadOnlySpan<double> state, ReadOnlySpan<double> upperTriangle)
    {
        state.CopyTo(State);
        int next = 0;
        for (int row = 0; row < N; row++)
        {
            for (int column = row; column < N; column++)
                _p[(row * N) + column] = _p[(column * N) + row] = upperTriangle[next++];
        }

        _used = 0;
    }

    /// <summary>Starts with a first measurement and a velocity that is not known.</summary>
    public void Start(in TrackMeasurement first, int slot, double velocitySigma)
    {
        (State[0], State[1], State[2], State[3]) = (first.North, 0, first.East, 0);
        HorizontalCovariance r = first.Covariance + first.Registration;
        Array.Clear(_p, 0, _p.Length);
        (_p[0], _p[2], _p[8], _p[10]) = (r.NorthNorth, r.NorthEast, r.NorthEast, r.EastEast);
        _p[5] = _p[15] = velocitySigma * velocitySigma;
        _used = 0;
        if (slot < 0)
            return;
        Use(slot + 1);

        // The place is off by what the source is off.
        HorizontalCovariance b = first.Registration;
        int at = slot * N * 2;
        (_c[at], _c[at + 1], _c[at + 4], _c[at + 5]) = (-b.NorthNorth, -b.NorthEast, -b.NorthEast, -b.EastEast);
    }

    /// <summary>States how the error depends on the registration error of a source: four rows of two.</summary>
    public void Correlate(int slot, ReadOnlySpan<double> correlation)
    {
        Use(slot + 1);
        correlation.CopyTo(_c.AsSpan(slot * N * 2, N * 2));
    }

    /// <summary>How the error depends on the registration error of a source: four rows of two; empty for not.</summary>
    public ReadOnlySpan<double> Correlation(int slot) => IsUsed(slot) ? _c.AsSpan(slot * N * 2, N * 2) : default;

    /// <summary>Becomes the one that has the mean and the covariance of two, of which one is true.</summary>
    public void Mix(ConsiderFilter a, double weightOfA, ConsiderFilter b, double weightOfB)
    {
        for (int row = 0; row < N; row++)
            State[row] = (weightOfA * a.State[row]) + (weightOfB * b.State[row]);
        for (int row = 0; row < N; row++)
        {
            for (int column = 0; column < N; column++)
            {
                double spreadOfA = (a.State[row] - State[row]) * (a.State[column] - State[column]);
                double spreadOfB = (b.State[row] - State[row]) * (b.State[column] - State[column]);
                int at = (row * N) + column;
                _p[at] = (weightOfA * (a._p[at] + spreadOfA)) + (weightOfB * (b._p[at] + spreadOfB));
            }
        }

        a.Use(b._used / (N * 2));
        b.Use(a._used / (N * 2));
        _used = a._used;
        for (int i = 0; i < _used; i++)
            _c[i] = (weightOfA * a._c[i]) + (weightOfB * b._c[i]);
    }

    /// <summary>Goes on by a time, or back by a negative one; it is less certain then, too.</summary>
    public void Predict(double seconds, double processNoise)
    {
        double dt = seconds;
        double q1 = processNoise * Math.Abs(dt);
        double q2 = q1 * dt / 2;
        double q3 = q1 * dt * dt / 3;
        State[0] += dt * State[1];
        State[2] += dt * State[3];
        for (int column = 0; column < N; column++)
        {
            _p[column] += dt * _p[N + column];
            _p[(2 * N) + column] += dt * _p[(3 * N) + column];
        }

        for (int row = 0; row < N; row++)
        {
            _p[row * N] += dt * _p[(row * N) + 1];
            _p[(row * N) + 2] += dt * _p[(row * N) + 3];
        }

        _p[0] += q3;
        _p[10] += q3;
        (_p[1], _p[4], _p[5]) = (_p[1] + q2, _p[4] + q2, _p[5] + q1);
        (_p[11], _p[14], _p[15]) = (_p[11] + q2, _p[14] + q2, _p[15] + q1);
        for (int at = 0; at < _used; at += N * 2)
        {
            _c[at] += dt * _c[at + 2];
            _c[at + 1] += dt * _c[at + 3];
            _c[at + 4] += dt * _c[at + 6];
            _c[at + 5] += dt * _c[at + 7];
        }
    }

    /// <summary>
    /// How uncertain the place is against measurements of a source, without what they add themselves.
    /// </summary>
    /// <param name="slot">That of the source; -1 for none.</param>
    public HorizontalCovariance ExpectedCovariance(int slot)
    {
        if (!IsUsed(slot))
            return PositionCovariance;
        int at = slot * N * 2;
        return PositionCovariance + new HorizontalCovariance(2 * _c[at], _c[at + 1] + _c[at + 4], 2 * _c[at + 5]);
    }

    /// <summary>Takes a measurement in.</summary>
    /// <param name="measurement">True at the filter's time.</param>
    /// <param name="slot">That of its source; -1 for one whose registration error counts as random.</param>
    /// <param name="slots">How many slots are taken.</param>
    /// <returns>What it was against what was expected.</returns>
    public Innovation Update(in TrackMeasurement measurement, int slot, int slots)
    {
        Use(slots);
        var innovation = new Innovation(
            measurement.North - State[0],
            measurement.East - State[2],
            ExpectedCovariance(slot) + measurement.Covariance + measurement.Registration);
        Span<double> gain = stackalloc double[N * 2];
        FindGain(innovation.Covariance, slot, gain);
        for (int row = 0; row < N; row++)
            State[row] += (gain[row * 2] * innovation.North) + (gain[(row * 2) + 1] * innovation.East);
        TakeGain(gain, measurement.Covariance + measurement.Registration, slot);
        for (int other = 0; other < slots; other++)
            TakeGain(gain, other, other == slot ? measurement.Registration : default);
        return innovation;
    }

    private bool IsUsed(int slot) => slot >= 0 && slot * N * 2 < _used;

    private void Use(int slots)
    {
        int end = slots * N * 2;
        if (end <= _used)
            return;
        Array.Clear(_c, _used, end - _used);
        _used = end;
    }

    private void FindGain(HorizontalCovariance s, int slot, Span<double> gain)
    {
        double determinant = (s.NorthNorth * s.EastEast) - (s.NorthEast * s.NorthEast);
        for (int row = 0; row < N; row++)
        {
            double toNorth = _p[row * N];
            double toEast = _p[(row * N) + 2];
            if (slot >= 0)
            {
                toNorth += _c[(slot * N * 2) + (row * 2)];
                toEast += _c[(slot * N * 2) + (row * 2) + 1];
            }

            gain[row * 2] = ((toNorth * s.EastEast) - (toEast * s.NorthEast)) / determinant;
            gain[(row * 2) + 1] = ((toEast * s.NorthNorth) - (toNorth * s.NorthEast)) / determinant;
        }
    }

    // P = A P A' + K R K' - A C K' - K C' A' with A = I - K H: symmetric whatever the rounding.
    private void TakeGain(Span<double> gain, HorizontalCovariance r, int slot)
    {
        Span<double> ap = stackalloc double[N * N];
        for (int row = 0; row < N; row++)
        {
            for (int column = 0; column < N; column++)
                ap[(row * N) + column] = Less(gain, row, _p, column, N);
        }

        Span<double> ac = stackalloc double[N * 2];
        if (slot >= 0)
        {
            Span<double> c = _c.AsSpan(slot * N * 2, N * 2);
            for (int row = 0; row < N; row++)
            {
                ac[row * 2] = Less(gain, row, c, 0, 2);
                ac[(row * 2) + 1] = Less(gain, row, c, 1, 2);
            }
        }

        for (int i = 0; i < N; i++)
        {
            for (int j = i; j < N; j++)
            {
                double apa = ap[(i * N) + j] - (ap[i * N] * gain[j * 2]) - (ap[(i * N) + 2] * gain[(j * 2) + 1]);
                double krk = (gain[i * 2] * ((r.NorthNorth * gain[j * 2]) + (r.NorthEast * gain[(j * 2) + 1])))
                    + (gain[(i * 2) + 1] * ((r.NorthEast * gain[j * 2]) + (r.EastEast * gain[(j * 2) + 1])));
                double ack = (ac[i * 2] * gain[j * 2]) + (ac[(i * 2) + 1] * gain[(j * 2) + 1])
                    + (ac[j * 2] * gain[i * 2]) + (ac[(j * 2) + 1] * gain[(i * 2) + 1]);
                _p[(i * N) + j] = _p[(j * N) + i] = apa + krk - ack;
            }
        }
    }

    // C = A C - K B, where the measurement comes of that source; else A C.
    private void TakeGain(Span<double> gain, int slot, HorizontalCovariance b)
    {
        Span<double> c = _c.AsSpan(slot * N * 2, N * 2);
        (double n0, double n1, double e0, double e1) =
            (c[0] + b.NorthNorth, c[1] + b.NorthEast, c[4] + b.NorthEast, c[5] + b.EastEast);
        for (int row = 0; row < N; row++)
        {
            c[row * 2] -= (gain[row * 2] * n0) + (gain[(row * 2) + 1] * e0);
            c[(row * 2) + 1] -= (gain[row * 2] * n1) + (gain[(row * 2) + 1] * e1);
        }
    }

    // An element of A M, where M has so many columns.
    private static double Less(Span<double> gain, int row, Span<double> m, int column, int columns)
        => m[(row * columns) + column] - (gain[row * 2] * m[column])
            - (gain[(row * 2) + 1] * m[(2 * columns) + column]);
}
