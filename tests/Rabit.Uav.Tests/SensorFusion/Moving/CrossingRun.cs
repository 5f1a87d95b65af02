using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Rabit.Uav.SensorFusion.Metrics;

namespace Rabit.Uav.Tests.SensorFusion.Moving;

/// <summary>
/// Two targets of one class that meet once a minute, in pictures of a vehicle above them: two pictures a second, each
/// target reported with 90 %, as one where they are too near for two, and among reports of nothing. They come
/// from and go to places all around, straight on or a little turned, and at their ends turn at once.
/// </summary>
internal sealed class CrossingRun
{
    private const double Period = 60;

    // Who goes almost the same way does not cross it.
    private const double MinAngle = Math.PI / 4;

    private readonly SeededNumbers _random;
    private readonly double _far;
    private readonly double _nearest;
    private readonly double _maxTurn;
    private readonly List<(double Time, double North, double East)>[] _ways = [[], []];

    /// <param name="seed">Of all that is random.</param>
    /// <param name="minutes">How long, and how often they meet.</param>
    /// <param name="farMetres">How far they go away, in half a minute.</param>
    /// <param name="nearestMetres">They meet within this.</param>
    /// <param name="maxTurnRadians">How much each turns where they meet.</param>
    public CrossingRun(int seed, int minutes, double farMetres, double nearestMetres, double maxTurnRadians)
    {
        Seed = seed;
        Seconds = minutes * Period;
        _random = new SeededNumbers(seed);
        (_far, _nearest, _maxTurn) = (farMetres, nearestMetres, maxTurnRadians);
        MakeWays(minutes);
    }

    public int Seed { get; }

    public double Seconds { get; }

    /// <summary>Of one report, metres and axis.</summary>
    public double Sigma { get; init; } = 0.7;

    /// <summary>What is the same in all reports, metres and axis.</summary>
    public double CommonSigma { get; init; } = 0.5;

    /// <summary>How many reports of nothing a picture has.</summary>
    public double Clutter { get; init; } = 0.1;

    /// <summary>Nearer than this two targets are one in a picture.</summary>
    public double ResolutionMetres { get; init; } = 1;

    public ClearMotMetrics Metrics { get; } = new(thresholdMetres: 5);

    /// <summary>How near they were.</summary>
    public double MinMetres { get; private set; } = double.PositiveInfinity;

    /// <summary>Those of Sensor Fusion at the end.</summary>
    public SensorFusionCounters Counters { get; private set; } = new();

    public void Fly(FusionRig rig, TargetClassName name)
    {
        (double biasNorth, double biasEast) = (CommonSigma * _random.Gauss(), CommonSigma * _random.Gauss());
        int[] ids = [1, 2];
        while (rig.Now.TotalSeconds + 0.5 < Seconds)
        {
            double time = rig.Now.TotalSeconds + 0.5;
            (double North, double East)[] truth = [At(0, time), At(1, time)];
            MinMetres = Math.Min(MinMetres, Distance(truth[0], truth[1]));
            TargetReport[] reports = Places(truth).Select(p => FusionRig.Report(
                p.North + biasNorth, p.East + biasEast, name, Sigma, CommonSigma)).ToArray();
            rig.Observe(0, 0, _far + 10, _far + 10, reports);
            if (time < 10)
                continue;
            TargetTrack[] confirmed = rig.Tracks.Where(t => t.State == TrackState.Confirmed).ToArray();
            Metrics.Add(
                ids, truth.Select(t => new NedPosition(t.North, t.East, 0)).ToArray(),
                confirmed.Select(t => t.Id).ToArray(),
                confirmed.Select(t => FusionRig.PlaceOf(t) with { Down = 0 }).ToArray());
        }

        Counters = rig.Counters;
    }

    public (double North, double East) At(int target, double time)
    {
        List<(double Time, double North, double East)> way = _ways[target];
        int next = way.FindIndex(p => p.Time > time);
        (double Time, double North, double East) a = way[next - 1];
        (double Time, double North, double East) b = way[next];
        double part = (time - a.Time) / (b.Time - a.Time);
        return (a.North + (part * (b.North - a.North)), a.East + (part * (b.East - a.East)));
    }

    // What a picture reports: each target, both as one, and nothing.
    private IEnumerable<(double North, double East)> Places((double North, double East)[] truth)
    {
        bool isOne = Distance(truth[0], truth[1]) < ResolutionMetres;
        (double North, double East)[] seen = isOne
            ? [(0.5 * (truth[0].North + truth[1].North), 0.5 * (truth[0].East + truth[1].East))]
            : truth;
        foreach ((double north, double east) in seen)
        {
            if (_random.Uniform(0, 1) < 0.9)
                yield return (north + (Sigma * _random.Gauss()), east + (Sigma * _random.Gauss()));
        }

        double reach = _far + 10;
        if (_random.Uniform(0, 1) < Clutter)
            yield return (_random.Uniform(-reach, reach), _random.Uniform(-reach, reach));
    }

    private void MakeWays(int minutes)
    {
        double[] from = [_random.Uniform(0, 2 * Math.PI), 0];
        from[1] = from[0] + _random.Uniform(MinAngle, (2 * Math.PI) - MinAngle);
        for (int target = 0; target < 2; target++)
            _ways[target].Add((-1, _far * Math.Cos(from[target]), _far * Math.Sin(from[target])));
        for (int minute = 0; minute < minutes; minute++)
        {
            double apart = _random.Uniform(0, _nearest);
            double towards = _random.Uniform(0, 2 * Math.PI);
            double[] to = Onwards(from);
            for (int target = 0; target < 2; target++)
            {
                double half = (target == 0 ? 0.5 : -0.5) * apart;
                double far = _far * _random.Uniform(0.7, 1);
                double time = (Period * minute) + 30;
                _ways[target].Add((time, half * Math.Cos(towards), half * Math.Sin(towards)));
                _ways[target].Add((time + 30, far * Math.Cos(to[target]), far * Math.Sin(to[target])));
            }

            from = to;
        }
    }

    // Straight on, or a little to a side; not to the same place.
    private double[] Onwards(double[] from)
    {
        while (true)
        {
            double[] to = from.Select(f => f + Math.PI + _random.Uniform(-_maxTurn, _maxTurn)).ToArray();
            if (Math.Cos(to[0] - to[1]) < Math.Cos(MinAngle))
                return to;
        }
    }

    private static double Distance((double North, double East) a, (double North, double East) b)
        => Math.Sqrt(((a.North - b.North) * (a.North - b.North)) + ((a.East - b.East) * (a.East - b.East)));
}
