using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Vehicle;

/// <summary>Wind, battery, errors, clock: whether they are as strong as stated.</summary>
public class PartsTests
{
    private const double Step = SimulatedVehicle.StepSeconds;
    private const double Degree = Ground.RadiansPerDegree;

    [Fact]
    public void Wind_OverAnHour_HasItsMeanAndItsGusts()
    {
        var wind = new WindField(new SimulationRandom(1, "wind"), 8, 90 * Degree, Step);
        var north = new List<double>();
        var east = new List<double>();
        for (int step = 0; step < 360_000; step++)
        {
            wind.Step();
            north.Add(wind.Velocity.North);
            east.Add(wind.Velocity.East);
        }

        // It comes from the east, so it goes west.
        Assert.InRange(east.Average(), -8.3, -7.7);
        Assert.InRange(north.Average(), -0.3, 0.3);
        Assert.InRange(Sigma(north), 1.4, 1.8);
        Assert.InRange(Sigma(east), 1.4, 1.8);
        Assert.InRange(Correlation(north, 500), 0.25, 0.48);   // after 5 s: 1/e
    }

    [Fact]
    public void Wind_ToAnotherMean_ComesWithinSeconds()
    {
        var wind = new WindField(new SimulationRandom(1, "wind"), 0, 0, Step);
        wind.MeanSpeed = 10;
        for (int step = 0; step < 1000; step++)
            wind.Step();
        Assert.InRange(wind.Velocity.HorizontalLength(), 6, 15);
    }

    [Fact]
    public void Wind_Gust_RisesAndFallsWithinItsDuration()
    {
        var options = new SimulationOptions
        {
            WindMetresPerSecond = 0,
            WindFrom = Rabit.Geodesy.Angle.FromDegrees(270),
            Faults =
            [
                new ScriptedFault
                {
                    Kind = ScriptedFaultKind.Gust, At = TimeSpan.FromSeconds(2), Value = 12,
                    Duration = TimeSpan.FromSeconds(6),
                },
            ],
        };
        SimulatedVehicle vehicle = new SimulatedWorld(options).CreateVehicle();
        var east = new List<double>();
        for (int step = 1; step <= 1000; step++)
        {
            vehicle.Step(TimeSpan.FromSeconds(step * Step), DateTimeOffset.FromUnixTimeSeconds(0));
            east.Add(vehicle.Air.Velocity.East);
        }

        Assert.Equal((0, 0), (east[198], east[820]));
        Assert.Equal(12, east[499], 2);
        Assert.Equal(6, east[349], 1);
    }

    [Fact]
    public void Battery_HoverPower_EmptiesInHalfAnHour()
    {
        var battery = new Battery(8, 1);
        Assert.Equal(12.6, battery.Volts, 3);
        int seconds = 0;
        for (; !battery.IsEmpty && seconds < 10_000; seconds++)
            battery.Step(188, 1);
        Assert.InRange(seconds, 25 * 60, 32 * 60);
        Assert.Equal(8, battery.ConsumedAmpereHours, 1);
        Assert.InRange(battery.Volts, 9, 10);
    }

    [Fact]
    public void Battery_UnderLoad_SagsByItsResistance()
    {
        var battery = new Battery(8, 1);
        battery.Step(188, 0.01);
        Assert.Equal(12.6 - (battery.Amperes * 0.02), battery.Volts, 3);
        Assert.Equal(188, battery.Volts * battery.Amperes, 1);
    }

    [Fact]
    public void Errors_OverManySeeds_AreAsStated()
    {
        NavigationErrors[] all = Enumerable.Range(1, 400).Select(seed => new NavigationErrors(seed, Step)).ToArray();
        double[] north = all.Select(e => e.SteadyPosition.North).ToArray();
        Assert.InRange(Sigma(north), 0.75, 1.0);   // normal with 1 m, cut at 2 m: 0.88
        Assert.InRange(north.Average(), -0.15, 0.15);
        Assert.InRange(north.Max(), 1.5, 2);
        Assert.InRange(Sigma(all.Select(e => e.EstimatedPosition.East - e.SteadyPosition.East)), 0.26, 0.34);
        Assert.InRange(Sigma(all.Select(e => e.EstimatedAttitude.Roll.Radians)) / Degree, 0.6, 0.78);
    }

    [Fact]
    public void Errors_OverTenMinutes_WalkSlowlyAndNoiseQuickly()
    {
        var errors = new NavigationErrors(3, Step);
        double start = errors.SteadyPosition.North;
        double largest = 0;
        var noise = new List<double>();
        for (int step = 0; step < 60_000; step++)
        {
            double before = errors.SteadyPosition.North;
            errors.Step();
            largest = Math.Max(largest, Math.Abs(errors.SteadyPosition.North - before));
            noise.Add(errors.EstimatedAttitude.Pitch.Radians);
        }

        Assert.InRange(largest, 0, 0.02);
        Assert.InRange(Math.Abs(errors.SteadyPosition.North - start), 0.001, 2);
        Assert.InRange(Sigma(noise) / Degree, 0.25, 0.35);
    }

    [Fact]
    public void Errors_BarometerDrifts_SlowlyAndAsFarAsStated()
    {
        var ends = new List<double>();
        double largest = 0;
        for (int seed = 1; seed <= 100; seed++)
        {
            var errors = new NavigationErrors(seed, step: 1, barometerDriftMetres: 5);
            Assert.Equal(0, errors.BarometerDown);
            for (int second = 0; second < 1800; second++)
            {
                double before = errors.BarometerDown;
                errors.Step();
                largest = Math.Max(largest, Math.Abs(errors.BarometerDown - before));
            }

            ends.Add(errors.BarometerDown);
        }

        Assert.InRange(Sigma(ends), 4, 6);
        Assert.InRange(largest, 0.5, 2);
    }

    [Fact]
    public void Random_ItsNumbers_AreThoseOfTheNormalDistribution()
    {
        var random = new SimulationRandom(11, "test");
        double[] numbers = Enumerable.Range(0, 100_000).Select(_ => random.Normal()).ToArray();
        Assert.InRange(numbers.Average(), -0.01, 0.01);
        Assert.InRange(Sigma(numbers), 0.99, 1.01);
        Assert.InRange(numbers.Count(n => Math.Abs(n) > 1.96) / 100_000.0, 0.047, 0.053);
    }

    [Fact]
    public void Random_PurposesAndSeeds_AreDifferentStreams()
    {
        ulong[] first = [new SimulationRandom(1, "a").Next(), new SimulationRandom(1, "b").Next(),
            new SimulationRandom(2, "a").Next()];
        Assert.Equal(3, first.Distinct().Count());
        Assert.Equal(first[0], new SimulationRandom(1, "a").Next());
    }

    [Fact]
    public void WorldFrame_AgainstTheProductsOwn_AgreesWithinAMillimetre()
    {
        var random = new SimulationRandom(7, "places");
        foreach (double latitude in (double[])[-75, -35.36, 0, 12, 47, 80])
        {
            var home = GeodeticPosition.FromDegrees(latitude, 179.99, 500);
            var mine = new WorldFrame(home);
            var product = LocalNedFrame.IgnoringGeoid(home);
            for (int point = 0; point < 200; point++)
            {
                var ned = new NedVector(
                    random.Uniform(-2000, 2000), random.Uniform(-2000, 2000), random.Uniform(-500, 100));
                GeodeticPosition place = mine.ToPlace(ned);
                AssertNear(ned, product.ToNed(place) - NedPosition.Origin);
                AssertNear(ned, mine.ToWorld(product.ToGeodetic(NedPosition.Origin + ned)));
                AssertNear(ned, mine.ToWorld(place));
            }
        }
    }

    [Fact]
    public void WorldFrame_OneMinuteOfLatitude_IsAboutANauticalMile()
    {
        var frame = new WorldFrame(GeodeticPosition.FromRadians(45 * Degree, 0, 0));
        Assert.Equal(1852.2, frame.ToWorld(GeodeticPosition.FromRadians((45 + (1 / 60.0)) * Degree, 0, 0)).North, 0);
    }

    private static void AssertNear(NedVector expected, NedVector actual)
    {
        Assert.InRange(actual.North - expected.North, -1e-3, 1e-3);
        Assert.InRange(actual.East - expected.East, -1e-3, 1e-3);
        Assert.InRange(actual.Down - expected.Down, -1e-3, 1e-3);
    }

    private static double Sigma(IEnumerable<double> values)
    {
        double[] all = values.ToArray();
        double mean = all.Average();
        return Math.Sqrt(all.Sum(v => (v - mean) * (v - mean)) / all.Length);
    }

    private static double Correlation(List<double> values, int lag)
    {
        double mean = values.Average();
        double variance = values.Sum(v => (v - mean) * (v - mean)) / values.Count;
        double sum = 0;
        for (int index = lag; index < values.Count; index++)
            sum += (values[index] - mean) * (values[index - lag] - mean);
        return sum / (values.Count - lag) / variance;
    }
}
