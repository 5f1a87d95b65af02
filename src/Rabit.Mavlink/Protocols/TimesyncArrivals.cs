using System;

namespace Rabit.Mavlink.Protocols;

/// <summary>
/// The drift as one-way messages show it that carry the other clock's time: the fastest of every two seconds, for the
/// last four minutes. The delay of even the fastest is not observable, only how it changes. No I/O, one thread,
/// allocates nothing.
/// </summary>
internal sealed class TimesyncArrivals
{
    private const int Capacity = 128;
    private const double BucketSeconds = 2;

    // Chosen over seeds of delays of gamma, exponential and even distribution: the min error of the drift that is also
    // stated rightly.
    private const double MinErrorSeconds = 0.4e-3;
    private const double ErrorOfExcess = 0.5;

    private readonly double[] _time = new double[Capacity];
    private readonly double[] _offset = new double[Capacity];
    private int _count;
    private int _newest = -1;
    private double _bucketEnd;

    public void Clear()
    {
        _count = 0;
        _newest = -1;
    }

    /// <summary>
    /// Adds one: when it arrived, and the other clock's time in it less that; the greatest is the fastest.
    /// </summary>
    public void Add(double arrival, double offset)
    {
        if (_count == 0 || arrival >= _bucketEnd)
        {
            _newest = (_newest + 1) % Capacity;
            _count = Math.Min(_count + 1, Capacity);
            _bucketEnd = arrival + BucketSeconds;
        }
        else if (offset <= _offset[_newest])
        {
            return;
        }

        _time[_newest] = arrival;
        _offset[_newest] = offset;
    }

    /// <summary>Adds to the normal equations of a drift; the unknown delay is eliminated.</summary>
    /// <param name="at">Where the line is measured from.</param>
    /// <param name="reference">Taken from every offset, so that no digits are lost.</param>
    /// <param name="drift">As it is known so far: it shows which were fast.</param>
    /// <param name="wxx">Sum of weight and time squared.</param>
    /// <param name="wxy">Sum of weight, time and offset.</param>
    public void AddTo(double at, double reference, double drift, ref double wxx, ref double wxy)
    {
        if (_count < 2)
            return;
        (double fastest, double mean) = (double.NegativeInfinity, 0);
        for (int i = 0; i < _count; i++)
        {
            double level = _offset[i] - reference - (drift * (_time[i] - at));
            fastest = Math.Max(fastest, level);
            mean += level / _count;
        }

        double best = fastest + ((fastest - mean) * Math.Sqrt(2.0 / _count));
        (double w, double sx, double sy, double sxx, double sxy) = (0, 0, 0, 0, 0);
        for (int i = 0; i < _count; i++)
        {
            double x = _time[i] - at;
            double y = _offset[i] - reference;
            double excess = ErrorOfExcess * (best - y + (drift * x));
            double weight = 1 / ((MinErrorSeconds * MinErrorSeconds) + (excess * excess));
            w += weight;
            sx += weight * x;
            sy += weight * y;
            sxx += weight * x * x;
            sxy += weight * x * y;
        }

        wxx += sxx - (sx * sx / w);
        wxy += sxy - (sx * sy / w);
    }
}
