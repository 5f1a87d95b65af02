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

    // A slower link is not fit for it. Half of it is what the offset may be off by then, which is to be stated.
    private const double MaxRoundTripSeconds = 5;

    // A message that is later than that is not of this clock.
    private const double MaxLateSeconds = 1;
    private const double MaxExcessSeconds = 0.05;
    private const double MinErrorSeconds = 0.2e-3;
    private const double TypicalDrift = 30e-6;

    // No delay can make the error of an answer, or of the line, larger than half a round trip, or than half of what it
    // took longer than the shortest one once that is known. What is further off by this margin contradicts the line.
    private const double EarlyMarginSeconds = 5e-3;
    private const double MarginSeconds = 1e-3;
    private const double MarginSigmas = 4;

    // From so many answers on the shortest round trip is known well enough for that.
    private const int MinAnswersOfShortest = 60;

    // So many answers that agree with both the line and a contradicting one decide nothing; then that one is forgotten.
    private const int SuspectFor = 30;

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
    private double _best;
    private Answer _suspect;
    private int _suspectLeft;

    /// <summary>
    /// Answers that were rejected because of their round-trip time, or because their time is not a number.
    /// </summary>
    public long Rejected { get; private set; }

    /// <summary>
    /// Answers that contradict the others and were put aside: a wrong one, or the first after the autopilot's clock
    /// jumped.
    /// </summary>
    public long Contradictions { get; private set; }

    /// <summary>How often the autopilot's clock jumped: two answers contradict the others and agree.</summary>
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
        _suspectLeft = 0;
        _arrivals.Clear();
        ShortestRoundTripSeconds = double.NaN;
    }

    /// <summary>Adds an answer of the request and answer exchange.</summary>
    /// <param name="askedAt">When the request was sent, by our clock.</param>
    /// <param name="receivedAt">When the answer was received, by our clock.</param>
    /// <param name="theirSeconds">The autopilot's clock in between, seconds.</param>
    /// <returns>
    /// True where it contradicts the earlier answers, so that the next one should be asked for soon: one such answer is
    /// put aside; with a second one that agrees with it the clock has jumped, and all earlier ones are discarded.
    /// </returns>
    public bool AddRoundTrip(TimeSpan askedAt, TimeSpan receivedAt, double theirSeconds)
    {
        double roundTrip = (receivedAt - askedAt).ExactSeconds;
        double middle = (askedAt.ExactSeconds + receivedAt.ExactSeconds) / 2;
        var answer = new Answer(middle, theirSeconds - middle, roundTrip);
        if (!(roundTrip >= 0 && roundTrip <= MaxRoundTripSeconds) || double.IsNaN(answer.Offset)
            || double.IsInfinity(answer.Offset))
        {
            Rejected++;
            return false;
        }

        if (_count > 0 && Contradicts(answer))
        {
            TakeContradiction(answer);
            return true;
        }

        if (_count >= MinAnswers && roundTrip > ShortestRoundTripSeconds + MaxExcessSeconds)
        {
            Rejected++;
            return false;
        }

        // An answer that agrees with the line, and cannot agree with the one that was put aside, decides against that.
        if (_suspectLeft > 0)
            _suspectLeft = AgreesWithSuspect(answer) ? _suspectLeft - 1 : 0;
        Add(answer);
        Fit();
        return false;
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
        double ours = arrival.ExactSeconds;
        double offset = theirSeconds - ours;
        double late = OffsetSecondsAt(ours) - offset;
        if (late >= -MaxLateSeconds && late <= MaxLateSeconds)
            _arrivals.Add(ours - _origin, offset);
    }

    /// <summary>Whether enough answers were received, and recently.</summary>
    /// <param name="now">The time, by our clock.</param>
    /// <returns>Whether the offset is valid.</returns>
    public bool IsKnown(TimeSpan now)
        => _count >= MinAnswers && now.ExactSeconds - (_origin + _newest) <= ValidFor.ExactSeconds;

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

    private void TakeContradiction(in Answer answer)
    {
        if (_suspectLeft == 0 || !AgreesWithSuspect(answer))
        {
            Contradictions++;
            (_suspect, _suspectLeft) = (answer, SuspectFor);
            return;
        }

        Answer first = _suspect;
        Jumps++;
        Clear();
        Add(first);
        Add(answer);
        Fit();
    }

    private bool Contradicts(in Answer answer) => Math.Abs(Residual(answer)) > Reach(answer);

    private bool AgreesWithSuspect(in Answer answer)
        => Math.Abs(Residual(answer) - Residual(_suspect)) <= Reach(answer) + Reach(_suspect);

    private double Residual(in Answer answer) => answer.Offset - OffsetSecondsAt(answer.Time);

    // How far an answer can be from the line by its delays and the error of the line.
    private double Reach(in Answer answer)
    {
        double early = ((answer.RoundTrip + ShortestRoundTripSeconds) / 2) + EarlyMarginSeconds;
        return _count < MinAnswersOfShortest
            ? early
            : Math.Min(
                early,
                (Math.Abs(answer.RoundTrip - _best) / 2) + MarginSeconds
                    + (MarginSigmas * OffsetErrorSecondsAt(answer.Time)));
    }

    private void Add(in Answer answer)
    {
        if (_count == 0)
            _origin = answer.Time;
        _time[_next] = answer.Time - _origin;
        _offset[_next] = answer.Offset;
        _roundTrip[_next] = answer.RoundTrip;
        _newest = answer.Time - _origin;
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
        _best = shortest - ((mean - shortest) * Math.Sqrt(2.0 / _count));
        for (int pass = 0; pass < Passes; pass++)
            FitLine(_best);
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

    /// <summary>One answer: the middle of its round trip by our clock, seconds, and what it says.</summary>
    private readonly struct Answer(double time, double offset, double roundTrip)
    {
        public double Time { get; } = time;

        public double Offset { get; } = offset;

        public double RoundTrip { get; } = roundTrip;
    }
}
