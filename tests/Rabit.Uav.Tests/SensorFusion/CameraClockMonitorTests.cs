using System;
using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Xunit;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>The offset of the camera's clock from passes that the test makes: straight, and level.</summary>
public class CameraClockMonitorTests
{
    private const double Speed = 6;
    private const double Height = 30;
    private const double NoiseMetres = 0.2;

    private static readonly NedVector South = new(-Speed, 0, 0);
    private static readonly NedVector North = new(Speed, 0, 0);
    private static readonly NedVector East = new(0, Speed, 0);

    private readonly CameraClockMonitor _monitor = new();
    private Random _random = new(1);
    private double _now = 100;
    private double _offset;
    private double _pitch;

    [Theory]
    [InlineData(0)]
    [InlineData(0.05)]
    [InlineData(-0.3)]
    [InlineData(0.5)]
    [InlineData(-1.5)]
    public void Passes_TwoDirectionsAndARevisit_ShowTheOffset(double offset)
    {
        double squares = 0;
        const int Trials = 20;
        for (int seed = 1; seed <= Trials; seed++)
        {
            CameraClockEstimate estimate = Fly(offset, seed);
            Assert.True(estimate.IsKnown, $"seed {seed}");
            Assert.InRange(estimate.ErrorSeconds, 0.001, 0.05);
            double error = (estimate.OffsetSeconds - offset) / estimate.ErrorSeconds;
            Assert.InRange(Math.Abs(error), 0, 4);
            squares += error * error / Trials;
        }

        // Chi-square of 20 ends at 1.9; the mount is exactly as stated here, which the stated error does not know.
        Assert.InRange(squares, 0.02, 1.9);
    }

    // The first false alarm of a flight: three targets in one direction, and the last picture of each in a turn.
    [Fact]
    public void Passes_OneDirectionAndATurn_ShowNothing()
    {
        foreach (double at in new[] { 0.0, 40, 80 })
        {
            Pass(at, 0, North, pictures: 5);
            Pass(at, 0, North, pictures: 5);
            Pass(at + 0.7, 0, new NedVector(Speed + 1.5, 0.4, 0), pictures: 1);
        }

        Assert.True(_monitor.Update());
        Assert.False(_monitor.Estimate.IsKnown);
    }

    [Fact]
    public void Passes_TwoAndBackOverOneTarget_AreTooFew()
    {
        _offset = 0.3;
        Pass(0, 0, North);
        Pass(0, 0, South);
        Assert.True(_monitor.Update());
        Assert.False(_monitor.Estimate.IsKnown);
    }

    [Fact]
    public void Passes_DifferentTargetsOfOneClass_AreNotTakenForAnOffset()
    {
        // 6 m apart: as far as one target would seem at half a second in two directions.
        for (int i = 0; i < 4; i++)
        {
            Pass(20 * i, 0, North);
            Pass((20 * i) + 6, 12 + i, South);
        }

        Assert.True(_monitor.Update());
        Assert.False(_monitor.Estimate.IsKnown && Math.Abs(_monitor.Estimate.OffsetSeconds) > 0.05);
    }

    // At one speed and height, north and south, a camera that is mounted nose up shows what a late clock shows.
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Passes_MountOffInPitch_IsNotCertainlyTheClockUnlessASlowPassSaysSo(bool hasSlow)
    {
        _pitch = 5 * Math.PI / 180;
        for (int target = 0; target < 3; target++)
        {
            Pass(40 * target, 0, North);
            Pass(40 * target, 0, South);
            Pass(40 * target, 0, North);
            Pass(40 * target, 0, South);
            if (!hasSlow)
                continue;
            Pass(40 * target, 0, (1 / Speed) * North);
            Pass(40 * target, 0, (-1 / Speed) * North);
        }

        Assert.True(_monitor.Update());
        CameraClockEstimate estimate = _monitor.Estimate;
        Assert.False(estimate.IsKnown && estimate.ExcludesMount, $"{estimate.OffsetSeconds}");
        if (!hasSlow)
            Assert.InRange(estimate.ErrorSeconds, 0.05, 1);
    }

    [Fact]
    public void Passes_SlowOnesToo_ExcludeTheMount()
    {
        _offset = 0.2;
        for (int target = 0; target < 3; target++)
        {
            foreach (NedVector velocity in new[] { North, South, (1 / Speed) * North, (-1 / Speed) * North })
                Pass(40 * target, 0, velocity);
        }

        Assert.True(_monitor.Update());
        Assert.True(_monitor.Estimate.ExcludesMount);
        Assert.InRange(_monitor.Estimate.OffsetSeconds, 0.18, 0.22);
    }

    [Fact]
    public void Clear_AfterPasses_ForgetsTheEstimate()
    {
        Assert.True(Fly(0.1, seed: 1).IsKnown);
        _monitor.Clear();
        Assert.False(_monitor.Estimate.IsKnown);
        Assert.False(_monitor.Update());
    }

    // Two lanes over two targets, and both revisited: a pass across the lanes, and a hover.
    private CameraClockEstimate Fly(double offset, int seed)
    {
        _monitor.Clear();
        (_random, _offset) = (new Random(seed), offset);
        foreach (NedVector velocity in new[] { North, South, East, (1 / Speed) * East })
        {
            Pass(0, 0, velocity);
            Pass(50, 8, velocity);
        }

        _monitor.Update();
        return _monitor.Estimate;
    }

    // A target at a place, seen in some pictures, half a second apart, each at the place that a wrong time and a wrong
    // pitch give it. Another pass begins much later.
    private void Pass(double north, double east, NedVector velocity, int pictures = 4)
    {
        NedVector heading = (1 / Math.Max(0.1, Length(velocity))) * velocity;
        for (int i = 0; i < pictures; i++)
        {
            double n = north + (_offset * velocity.North) + (_pitch * Height * heading.North) + Noise();
            double e = east + (_offset * velocity.East) + (_pitch * Height * heading.East) + Noise();
            _monitor.Add(new LocatedReport(Report(velocity, heading), new NedPosition(n, e, 0), isOwn: true));
            _now += 0.5;
        }

        _now += 20;
    }

    private TargetReport Report(NedVector velocity, NedVector heading)
    {
        ImmutableArray<NedVector>.Builder byOffset = ImmutableArray.CreateBuilder<NedVector>();
        for (int i = 0; i < TargetSensitivity.Offsets; i++)
            byOffset.Add(-TargetSensitivity.OffsetOf(i) * velocity);
        return new TargetReport
        {
            Time = TimeSpan.FromSeconds(_now),
            Class = DefaultTargetClasses.Red,
            Covariance = new HorizontalCovariance(NoiseMetres * NoiseMetres, 0, NoiseMetres * NoiseMetres),
            Sensitivity = new TargetSensitivity
            {
                ByOffset = byOffset.ToImmutable(),
                ByPitch = Height * heading,
                ByRoll = new NedVector(-Height * heading.East, Height * heading.North, 0),
            },
        };
    }

    private double Noise()
        => NoiseMetres * Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble()))
            * Math.Cos(2 * Math.PI * _random.NextDouble());

    private static double Length(NedVector v) => Math.Sqrt((v.North * v.North) + (v.East * v.East));
}
