using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.SensorFusion.Metrics;
using Xunit;

namespace Rabit.Uav.Tests.SensorFusion.Metrics;

/// <summary>Against Stone Soup and the definitions (tests/data/autonomy/metrics.json).</summary>
public class TrackingMetricsTests
{
    private const double Tolerance = 1e-9;

    private static readonly (string Name, double Order, double Cutoff)[] Variants =
        [("p1_c20", 1, 20), ("p1_c50", 1, 50), ("p2_c20", 2, 20), ("p2_c50", 2, 50)];

    [Fact]
    public void Ospa_ReferenceSets_AgreesToOnePartInABillion()
    {
        int compared = 0;
        ForEachTime((set, i, truth, tracks) =>
        {
            foreach ((string name, double order, double cutoff) in Variants)
            {
                double ospa = new TrackingMetrics(cutoff, order).Ospa(truth.Places, tracks.Places);
                JsonElement expected = set.GetProperty("ospa").GetProperty(name).GetProperty("per_time")[i];
                Assert.Equal(expected.GetDouble(), ospa, Tolerance);
                compared++;
            }
        });
        Assert.InRange(compared, 5000, 20_000);
    }

    [Fact]
    public void Gospa_ReferenceSets_AgreesInAllParts()
    {
        int compared = 0;
        ForEachTime((set, i, truth, tracks) =>
        {
            foreach ((string name, double order, double cutoff) in Variants)
            {
                GospaScore gospa = new TrackingMetrics(cutoff, order).Gospa(truth.Places, tracks.Places);
                JsonElement expected = set.GetProperty("gospa").GetProperty(name);
                AssertNear(expected.GetProperty("distance")[i].GetDouble(), gospa.Distance);
                AssertNear(expected.GetProperty("localisation")[i].GetDouble(), gospa.Localisation);
                AssertNear(expected.GetProperty("missed")[i].GetDouble(), gospa.Missed);
                AssertNear(expected.GetProperty("false")[i].GetDouble(), gospa.False);
                compared++;
            }
        });
        Assert.InRange(compared, 5000, 20_000);
    }

    [Fact]
    public void ClearMot_ReferenceSets_AgreesInAllCounts()
    {
        ClearMotMetrics? metrics = null;
        int last = -1;
        var finished = new List<(JsonElement Expected, ClearMotMetrics Metrics)>();
        ForEachTime((set, i, truth, tracks) =>
        {
            if (set.GetProperty("id").GetInt32() != last)
            {
                last = set.GetProperty("id").GetInt32();
                JsonElement expected = set.GetProperty("clear_mot");
                metrics = new ClearMotMetrics(expected.GetProperty("threshold").GetDouble());
                finished.Add((expected.Clone(), metrics));
            }

            metrics!.Add(truth.Ids, truth.Places, tracks.Ids, tracks.Places);
        });
        Assert.Equal(90, finished.Count);
        foreach ((JsonElement expected, ClearMotMetrics actual) in finished)
        {
            Assert.Equal(expected.GetProperty("truth_states").GetInt64(), actual.TruthStates);
            Assert.Equal(expected.GetProperty("matches").GetInt64(), actual.Matches);
            Assert.Equal(expected.GetProperty("misses").GetInt64(), actual.Misses);
            Assert.Equal(expected.GetProperty("false_positives").GetInt64(), actual.FalsePositives);
            Assert.Equal(expected.GetProperty("id_switches").GetInt64(), actual.IdSwitches);
            Assert.Equal(expected.GetProperty("mota").GetDouble(), actual.Mota, Tolerance);
            if (expected.TryGetProperty("motp", out JsonElement motp))
                Assert.Equal(motp.GetDouble(), actual.Motp, Tolerance);
            else
                Assert.True(double.IsNaN(actual.Motp));
        }
    }

    [Fact]
    public void Nees_OfAPosition_IsTheSameAsThatOfAStateOfTwo()
    {
        Assert.Equal(1 + 4, TrackingMetrics.Nees(2, 2, new HorizontalCovariance(4, 0, 1)), Tolerance);
        Assert.Equal(
            TrackingMetrics.Nees(2, -1, new HorizontalCovariance(4, 1, 2)),
            TrackingMetrics.Nees([2, -1], [4, 1, 2]),
            Tolerance);
    }

    [Fact]
    public void Nees_OfFour_IsThatOfTheInverse()
    {
        // Covariance L L' of a lower triangle L: the error L u has the squared length of u.
        Assert.Equal(
            1 + 4 + 9 + 16,
            TrackingMetrics.Nees(
                [2 * 1, (1 * 1) + (1 * 2), (3 * 1) + (1 * 2) + (2 * 3), (1 * 1) + (2 * 2) + (1 * 3) + (4 * 4)],
                [4, 2, 6, 2, 2, 4, 3, 14, 7, 22]),
            Tolerance);
        Assert.Equal(double.PositiveInfinity, TrackingMetrics.Nees([1, 1], [1, 2, 1]));
        Assert.Equal(double.PositiveInfinity, TrackingMetrics.Nees([1, 1], [double.NaN, 0, 1]));
    }

    [Fact]
    public void Constructor_OutOfRange_IsRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new TrackingMetrics(0, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new TrackingMetrics(double.NaN, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new TrackingMetrics(50, 0.5));
        Assert.Throws<ArgumentOutOfRangeException>(() => new ClearMotMetrics(-1));
        Assert.Throws<ArgumentException>(() => TrackingMetrics.Nees([1.0], [1.0, 0, 1]));
        Assert.Throws<ArgumentException>(() => TrackingMetrics.Nees([], []));
        Assert.Throws<ArgumentException>(() => new ClearMotMetrics(1).Add([1], [], [], []));
        Assert.Throws<ArgumentException>(() => new ClearMotMetrics(1).Add([1, 1], new NedPosition[2], [], []));
    }

    [Fact]
    public void Ospa_SecondTime_AllocatesNothing()
    {
        var metrics = new TrackingMetrics(50, 2);
        NedPosition[] truth = [new(0, 0, 0), new(100, 0, 0)];
        NedPosition[] tracks = [new(3, 4, 0), new(5, 5, 0), new(99, 0, 0)];
        double sum = metrics.Ospa(truth, tracks);
        Assert.Equal(0, Allocated.By(() => sum += metrics.Ospa(truth, tracks) + metrics.Gospa(truth, tracks).Distance));
        Assert.True(sum > 0);
    }

    private static void AssertNear(double expected, double actual)
        => Assert.Equal(expected, actual, Tolerance * Math.Max(1, Math.Abs(expected)));

    private static void ForEachTime(Action<JsonElement, int, Objects, Objects> check)
    {
        using JsonDocument data = TestData.Autonomy("metrics.json");
        foreach (JsonElement set in data.RootElement.GetProperty("sets").EnumerateArray())
        {
            int i = 0;
            foreach (int time in set.GetProperty("times").EnumerateArray().Select(t => t.GetInt32()))
                check(set, i++, At(set.GetProperty("truth"), time), At(set.GetProperty("tracks"), time));
        }
    }

    private static Objects At(JsonElement objects, int time)
    {
        var ids = new List<int>();
        var places = new List<NedPosition>();
        for (int i = 0; i < objects.GetArrayLength(); i++)
        {
            JsonElement states = objects[i].GetProperty("states");
            int step = time - objects[i].GetProperty("t0").GetInt32();
            if (step < 0 || step >= states.GetArrayLength())
                continue;
            ids.Add(i);
            places.Add(new NedPosition(states[step][0].GetDouble(), states[step][2].GetDouble(), 0));
        }

        return new Objects(ids.ToArray(), places.ToArray());
    }

    private readonly record struct Objects(int[] Ids, NedPosition[] Places);
}
