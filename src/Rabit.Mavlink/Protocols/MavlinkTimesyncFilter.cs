using System;
using Rabit.Mavlink.Protocols;

namespace Rabit.Mavlink;

/// <summary>
/// Estimates how far the autopilot's clock is ahead of ours, and how fast it drifts: a weighted line through the last
/// 256 answers, four minutes at one a second, and through the arrival times of its other messages. No I/O, one thread,
/// allocates nothing.
/// </summary>
/// <remarks>
/// An answer whose way took longer than the shortest one by e is wrong by up to e/2 either way: where the two ways are
/// alike, evenly spread, with variance e^2/12. Such answers weigh little, so that queues on the way do not bend the
/// line; those that took much longer are left out. How short the way can be at best is not known either: of n answers
/// whose ways vary by J the quickest took about J sqrt(2/n) longer, which is added to every e. The drift is held near 0
/// by what crystals do, which matters while the answers are few. One-way messages (<see cref="AddOneWay"/>) contain
/// nothing about the offset, but much about the drift, since there are so many of them. The filter states its own
/// errors: <see cref="OffsetErrorSecondsAt"/>, <see cref="DriftError"/>. The MAVLink documentation
/// (docs/mavlink/protocols.md) has what was measured.
/// </remarks>
public sealed class MavlinkTimesyncFilter
{
    /// <summary>From how many answers on the clock counts as known.</summary>
    public const int MinAnswers = 5;

    // Four minutes at 1 Hz; over that a crystal's drift is a straight line.
    private const int Capacity = 256;

    // After that long without an answer the line is not extrapolated any further.
    private static readonly TimeSpan ValidFor = TimeSpan.FromSeconds(60);

    // Slower than this and a link is not fit for it.
    private const double MaxRoundTripSeconds = 1;
    private const double MaxExcessSeconds = 0.05;
    private const double MinErrorSeconds = 0.2e-3;
    private const double TypicalDrift = 30e-6;

    // No delay can make the error of an answer, or of the line, larger than half a round trip; beyond this margin the
    // clock has jumped.
    private const double JumpSeconds = 5e-3;

    // Which messages were fast depends on the drift, and the drift on them.
    private const int Passes = 3;

    private readonly TimesyncArrivals _arrivals = new();
    private readonly double[] _time = new double[Capacity];
    private readonly double[] _offset = new double[Capacity];
    private readonly double[] _roundTrip = new double[Capacity];
    private int _count;
    private int _next;
    private double _origin;
    private double _newest;
    private double _offsetAtNewest;
    private double _drift;
    private double _offsetVariance;
    private double _driftVariance;
    private double _covariance;

    /// <summary>Answers that were rejected because of their round-trip time.</summary>
    public long Rejected { get; private set; }

    /// <summary>How often the autopilot's clock jumped.</summary>
    public long Jumps { get; private set; }

    /// <summary>The shortest round trip of those that are kept, seconds; NaN while there are none.</summary>
    public double ShortestRoundTripSeconds { get; private set; } = double.NaN;

    /// <summary>Drift of the autopilot's clock against ours, seconds per second.</summary>
    public double Drift => _drift;

    /// <summary>
    /// One standard deviation of <see cref="Drift"/>, seconds per second; NaN while there is no answer.
    /// </summary>
    public double DriftError => _count == 0 ? double.NaN : Math.Sqrt(_driftVariance);

    /// <summary>Forgets everything.</summary>
    public void Clear()
    {
        _count = 0;
        _next = 0;
        _drift = 0;
        _arrivals.Clear();
        ShortestRoundTripSeconds = double.NaN;
    }

    /// <summary>Adds an answer of the request and answer exchange.</summary>
    /// <param name="askedAt">When the request was sent, by our clock.</param>
    /// <param name="receivedAt">When the answer was received, by our clock.</param>
    /// <param name="theirSeconds">The autopilot's clock in between, seconds.</param>
    /// <returns>True where it shows that the autopilot's clock has jumped: all earlier answers are discarded.</returns>
    public bool AddRoundTrip(TimeSpan askedAt, TimeSpan receivedAt, double theirSeconds)
    {
        double roundTrip = (receivedAt - askedAt).TotalSeconds;
        if (!(roundTrip >= 0 && roundTrip <= MaxRoundTripSeconds))
        {
            Rejected++;
            return false;
        }

        double middle = (askedAt.TotalSeconds + receivedAt.TotalSeconds) / 2;
        double offset = theirSeconds - middle;
        bool hasJumped = _count > 0
            && Math.Abs(offset - OffsetSecondsAt(middle)) > ((roundTrip + ShortestRoundTripSeconds) / 2) + JumpSeconds;
        if (hasJumped)
        {
            Jumps++;
            Clear();
        }
        else if (_count >= MinAnswers && roundTrip > ShortestRoundTripSeconds + MaxExcessSeconds)
        {
            Rejected++;
            return false;
        }

        Add(middle, offset, roundTrip);
        Fit();
        return hasJumped;
    }

    /// <summary>
    /// Adds any other message that carries the autopilot's time: how its delay changes shows the drift, from the next
    /// answer on. Counts only once there is an answer, and not if it is more than a second late: then it is not of this
    /// clock.
    /// </summary>
    /// <param name="arrival">When it was received, by our clock.</param>
    /// <param name="theirSeconds">The autopilot's time in it, by the same clock as in the answers, seconds.</param>
    public void AddOneWay(TimeSpan arrival, double theirSeconds)
    {
        if (_count == 0)
            return;
        double ours = arrival.TotalSeconds;
        double offset = theirSeconds - ours;
        double late = OffsetSecondsAt(ours) - offset;
        if (late >= -MaxRoundTripSeconds && late <= MaxRoundTripSeconds)
            _arrivals.Add(ours - _origin, offset);
    }

    /// <summary>Whether enough answers were received, and recently.</summary>
    /// <param name="now">The time, by our clock.</param>
    /// <returns>Whether the offset is valid.</returns>
    public bool IsKnown(TimeSpan now)
        => _count >= MinAnswers && now.TotalSeconds - (_origin + _newest) <= ValidFor.TotalSeconds;

    /// <summary>How far the autopilot's clock is ahead of ours. Only once there is an answer.</summary>
    /// <param name="ourSeconds">A time by our clock, seconds.</param>
    /// <returns>Seconds.</returns>
    public double OffsetSecondsAt(double ourSeconds) => _offsetAtNewest + (_drift * (ourSeconds - _origin - _newest));

    /// <summary>One standard deviation of <see cref="OffsetSecondsAt"/>. Only once there is an answer.</summary>
    /// <remarks>
    /// Without what no exchange can show: half of the constant difference between the two directions.
    /// </remarks>
    /// <param name="ourSeconds">A time by our clock, seconds.</param>
    /// <returns>Seconds; it grows with the time since the answers.</returns>
    public double OffsetErrorSecondsAt(double ourSeconds)
    {
        double x = ourSeconds - _origin - _newest;
        return Math.Sqrt(Math.Max(0, _offsetVariance + (2 * x * _covariance) + (x * x * _driftVariance)));
    }

    private void Add(double middle, double offset, double roundTrip)
    {
        if (_count == 0)
            _origin = middle;
        _time[_next] = middle - _origin;
        _offset[_next] = offset;
        _roundTrip[_next] = roundTrip;
        _newest = middle - _origin;
        _next = (_next + 1) % Capacity;
        if (_count < Capacity)
            _count++;
    }

    private void Fit()
    {
        double shortest = double.PositiveInfinity;
        double mean = 0;
        for (int i = 0; i < _count; i++)
        {
            shortest = Math.Min(shortest, _roundTrip[i]);
            mean += _roundTrip[i] / _count;
        }

        ShortestRoundTripSeconds = shortest;
        double best = shortest - ((mean - shortest) * Math.Sqrt(2.0 / _count));
        for (int pass = 0; pass < Passes; pass++)
            FitLine(best);
    }

    // Weighted min squares about the newest answer, with an observation of no drift that is as sure as crystals are
    // good.
    private void FitLine(double best)
    {
        double reference = _offset[(_next + Capacity - 1) % Capacity];
        double w = 0;
        double wx = 0;
        double wxx = 1 / (TypicalDrift * TypicalDrift);
        double wy = 0;
        double wxy = 0;
        for (int i = 0; i < _count; i++)
        {
            double excess = _roundTrip[i] - best;
            double weight = 1 / ((MinErrorSeconds * MinErrorSeconds) + (excess * excess / 12));
            double x = _time[i] - _newest;
            double y = _offset[i] - reference;
            w += weight;
            wx += weight * x;
            wxx += weight * x * x;
            wy += weight * y;
            wxy += weight * x * y;
        }

        _arrivals.AddTo(_newest, reference, _drift, ref wxx, ref wxy);
        double determinant = (w * wxx) - (wx * wx);
        _offsetAtNewest = reference + (((wxx * wy) - (wx * wxy)) / determinant);
        _drift = ((w * wxy) - (wx * wy)) / determinant;

        // How much the ways vary is itself known from few answers only.
        double caution = _count / Math.Max(1.0, _count - 3);
        _offsetVariance = caution * wxx / determinant;
        _driftVariance = caution * w / determinant;
        _covariance = -caution * wx / determinant;
    }
}
