using System;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Kalman filter of one target on the ground: position and velocity, north and east, under white acceleration
/// (Bar-Shalom, Li, Kirubarajan: "Estimation with Applications to Tracking and Navigation", 6.2.2). State order N, vN,
/// E, vE; metres and seconds. A plain value without anything on the heap: a copy is a filter of its own.
/// </summary>
internal struct PlanarFilter
{
    // Covariance, upper triangle row by row; 0 is N, 1 is vN, 2 is E, 3 is vE.
    private double _p00, _p01, _p02, _p03, _p11, _p12, _p13, _p22, _p23, _p33;

    public double North { get; private set; }

    public double NorthRate { get; private set; }

    public double East { get; private set; }

    public double EastRate { get; private set; }

    /// <summary>How uncertain the position is.</summary>
    public readonly HorizontalCovariance PositionCovariance => new(_p00, _p02, _p22);

    /// <summary>Starts with a state and the upper triangle of its covariance, ten numbers row by row.</summary>
    public static PlanarFilter From(ReadOnlySpan<double> state, ReadOnlySpan<double> covariance) => new()
    {
        North = state[0],
        NorthRate = state[1],
        East = state[2],
        EastRate = state[3],
        _p00 = covariance[0],
        _p01 = covariance[1],
        _p02 = covariance[2],
        _p03 = covariance[3],
        _p11 = covariance[4],
        _p12 = covariance[5],
        _p13 = covariance[6],
        _p22 = covariance[7],
        _p23 = covariance[8],
        _p33 = covariance[9],
    };

    /// <summary>Starts with a first report and a velocity that is not known.</summary>
    public static PlanarFilter From(double north, double east, HorizontalCovariance covariance, double velocitySigma)
    {
        double variance = velocitySigma * velocitySigma;
        return new PlanarFilter
        {
            North = north,
            East = east,
            _p00 = covariance.NorthNorth,
            _p02 = covariance.NorthEast,
            _p22 = covariance.EastEast,
            _p11 = variance,
            _p33 = variance,
        };
    }

    /// <summary>Copies the covariance out: upper triangle, ten numbers row by row.</summary>
    public readonly void CopyCovarianceTo(Span<double> upperTriangle)
    {
        Span<double> p = stackalloc double[16];
        Expand(p);
        int next = 0;
        for (int row = 0; row < 4; row++)
        {
            for (int column = row; column < 4; column++)
                upperTriangle[next++] = p[(row * 4) + column];
        }
    }

    /// <summary>Goes on by a time, not negative.</summary>
    /// <param name="seconds">How long.</param>
    /// <param name="processNoise">Intensity of the white acceleration, m2/s3.</param>
    public void Predict(double seconds, double processNoise)
    {
        double dt = seconds;
        double dt2 = dt * dt;
        double q3 = processNoise * dt2 * dt / 3;
        double q2 = processNoise * dt2 / 2;
        double q1 = processNoise * dt;
        North += dt * NorthRate;
        East += dt * EastRate;
        _p00 += (2 * dt * _p01) + (dt2 * _p11) + q3;
        _p02 += (dt * (_p12 + _p03)) + (dt2 * _p13);
        _p22 += (2 * dt * _p23) + (dt2 * _p33) + q3;
        _p01 += (dt * _p11) + q2;
        _p03 += dt * _p13;
        _p12 += dt * _p13;
        _p23 += (dt * _p33) + q2;
        _p11 += q1;
        _p33 += q1;
    }

    /// <summary>What a position measured a while before the filter's time is against what the filter expects.</summary>
    /// <param name="north">Measured.</param>
    /// <param name="east">Measured.</param>
    /// <param name="covariance">Of the measurement.</param>
    /// <param name="lagSeconds">How long before the filter's time it was measured; 0 or more.</param>
    public readonly Innovation Expect(double north, double east, HorizontalCovariance covariance, double lagSeconds)
    {
        double lag2 = lagSeconds * lagSeconds;
        var s = new HorizontalCovariance(
            _p00 - (2 * lagSeconds * _p01) + (lag2 * _p11) + covariance.NorthNorth,
            _p02 - (lagSeconds * (_p03 + _p12)) + (lag2 * _p13) + covariance.NorthEast,
            _p22 - (2 * lagSeconds * _p23) + (lag2 * _p33) + covariance.EastEast);
        return new Innovation(
            north - (North - (lagSeconds * NorthRate)),
            east - (East - (lagSeconds * EastRate)),
            s);
    }

    /// <summary>
    /// Takes a measurement in, Joseph form. One that is late is a measurement of where the target was then: position
    /// less velocity times lag. That is exact but for the process noise of the lag.
    /// </summary>
    /// <inheritdoc cref="Expect"/>
    public void Update(double north, double east, HorizontalCovariance covariance, double lagSeconds)
    {
        Innovation innovation = Expect(north, east, covariance, lagSeconds);
        HorizontalCovariance s = innovation.Covariance;
        double determinant = (s.NorthNorth * s.EastEast) - (s.NorthEast * s.NorthEast);

        Span<double> p = stackalloc double[16];
        Expand(p);
        Span<double> gain = stackalloc double[8];
        for (int row = 0; row < 4; row++)
        {
            double toNorth = p[row * 4] - (lagSeconds * p[(row * 4) + 1]);
            double toEast = p[(row * 4) + 2] - (lagSeconds * p[(row * 4) + 3]);
            gain[row * 2] = ((toNorth * s.EastEast) - (toEast * s.NorthEast)) / determinant;
            gain[(row * 2) + 1] = ((toEast * s.NorthNorth) - (toNorth * s.NorthEast)) / determinant;
        }

        North += (gain[0] * innovation.North) + (gain[1] * innovation.East);
        NorthRate += (gain[2] * innovation.North) + (gain[3] * innovation.East);
        East += (gain[4] * innovation.North) + (gain[5] * innovation.East);
        EastRate += (gain[6] * innovation.North) + (gain[7] * innovation.East);
        TakeGain(p, gain, covariance, lagSeconds);
    }

    // P = A P A' + K R K' with A = I - K H: symmetric and positive definite whatever the rounding.
    private void TakeGain(Span<double> p, Span<double> gain, HorizontalCovariance r, double lag)
    {
        Span<double> a = stackalloc double[16];
        Span<double> ap = stackalloc double[16];
        for (int row = 0; row < 4; row++)
        {
            a[row * 4] = -gain[row * 2];
            a[(row * 4) + 1] = lag * gain[row * 2];
            a[(row * 4) + 2] = -gain[(row * 2) + 1];
            a[(row * 4) + 3] = lag * gain[(row * 2) + 1];
            a[(row * 4) + row] += 1;
        }

        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
                ap[(row * 4) + column] = Dot(a, row, p, column);
        }

        _p00 = Joseph(ap, a, gain, r, 0, 0);
        _p01 = Joseph(ap, a, gain, r, 0, 1);
        _p02 = Joseph(ap, a, gain, r, 0, 2);
        _p03 = Joseph(ap, a, gain, r, 0, 3);
        _p11 = Joseph(ap, a, gain, r, 1, 1);
        _p12 = Joseph(ap, a, gain, r, 1, 2);
        _p13 = Joseph(ap, a, gain, r, 1, 3);
        _p22 = Joseph(ap, a, gain, r, 2, 2);
        _p23 = Joseph(ap, a, gain, r, 2, 3);
        _p33 = Joseph(ap, a, gain, r, 3, 3);
    }

    private static double Joseph(
        Span<double> ap, Span<double> a, Span<double> gain, HorizontalCovariance r, int i, int j)
    {
        double noise = (gain[i * 2] * ((r.NorthNorth * gain[j * 2]) + (r.NorthEast * gain[(j * 2) + 1])))
            + (gain[(i * 2) + 1] * ((r.NorthEast * gain[j * 2]) + (r.EastEast * gain[(j * 2) + 1])));
        return Dot(ap, i, a, j) + noise;
    }

    // Row of one times row of the other: the other is symmetric, or meant transposed.
    private static double Dot(Span<double> left, int row, Span<double> right, int otherRow)
    {
        double sum = 0;
        for (int k = 0; k < 4; k++)
            sum += left[(row * 4) + k] * right[(otherRow * 4) + k];
        return sum;
    }

    private readonly void Expand(Span<double> p)
    {
        (p[0], p[1], p[2], p[3]) = (_p00, _p01, _p02, _p03);
        (p[4], p[5], p[6], p[7]) = (_p01, _p11, _p12, _p13);
        (p[8], p[9], p[10], p[11]) = (_p02, _p12, _p22, _p23);
        (p[12], p[13], p[14], p[15]) = (_p03, _p13, _p23, _p33);
    }
}
