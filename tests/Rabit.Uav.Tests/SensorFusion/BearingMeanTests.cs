using System;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion;
using Xunit;

namespace Rabit.Uav.Tests.SensorFusion;

/// <summary>The mean of bearings that are known up to a symmetry, and a track's.</summary>
public sealed class BearingMeanTests
{
    [Theory]
    [InlineData(BearingSymmetry.None, new[] { 350.0, 10 }, 0)]
    [InlineData(BearingSymmetry.HalfTurn, new[] { 170.0, 10 }, 0)]
    [InlineData(BearingSymmetry.HalfTurn, new[] { 178.0, 359, 0 }, 179)]
    [InlineData(BearingSymmetry.QuarterTurn, new[] { 88.0, 184, 270 }, 0.667)]
    public void Value_AcrossTheEndOfThePeriod_IsTheAxialMean(
        BearingSymmetry symmetry, double[] degrees, double expected)
    {
        TargetBearing mean = MeanOf([.. degrees.Select(d => Bearing(d, 5, symmetry))])!.Value;
        Assert.Equal(0, mean.DistanceTo(Angle.FromDegrees(expected)).Degrees, 0.1);
        Assert.Equal(symmetry, mean.Symmetry);
    }

    [Fact]
    public void Value_MoreCertainOnes_CountMore()
    {
        TargetBearing mean = MeanOf(Bearing(20, 1), Bearing(40, 3))!.Value;
        Assert.Equal(22, mean.Angle.Degrees, 0.2);
    }

    [Theory]
    [InlineData(3, 3)]
    [InlineData(3, 9)]   // they differ more than they state
    [InlineData(9, 3)]   // less: then what they state counts
    public void Value_ManyReports_IsAsCertainAsItSays(double stated, double real)
    {
        const int seed = 17;
        var random = new Random(seed);
        const int runs = 300;
        (double squares, double variances) = (0, 0);
        for (int run = 0; run < runs; run++)
        {
            TargetBearing mean = MeanOf([.. Enumerable.Range(0, 12)
                .Select(_ => Bearing(179 + (real * Gauss(random)), stated))])!.Value;
            double error = mean.DistanceTo(Angle.FromDegrees(179)).Degrees;
            squares += error * error;
            variances += mean.Sigma.Degrees * mean.Sigma.Degrees;
        }

        double ratio = squares / variances;
        Assert.True(
            stated > real ? ratio is > 0.05 and < 0.2 : ratio is > 0.7 and < 1.4, $"seed {seed}: {ratio}");
    }

    [Fact]
    public void Value_AnyDirections_IsNone()
    {
        Assert.Null(MeanOf(Bearing(0, 3), Bearing(90, 3)));
        Assert.Null(MeanOf(Bearing(0, 3), Bearing(60, 3), Bearing(120, 3), Bearing(5, 3)));
        Assert.Null(MeanOf(Bearing(10, 40)));
        Assert.Null(default(BearingMean).Value);
    }

    [Fact]
    public void Value_NoNumberOrNoError_DoesNotCount()
    {
        var mean = default(BearingMean);
        mean.Add(null);
        mean.Add(Bearing(double.NaN, 1));
        mean.Add(Bearing(10, 0));
        mean.Add(Bearing(10, double.NaN));
        Assert.Null(mean.Value);
        mean.Add(Bearing(30, 1));
        Assert.Equal(30, mean.Value!.Value.Angle.Degrees, 1e-9);
    }

    [Fact]
    public void Value_TwoSymmetries_IsOfTheMoreFrequentOne()
    {
        TargetBearing square = Bearing(30, 2, BearingSymmetry.QuarterTurn);
        TargetBearing isLong = Bearing(120, 2);
        Assert.Equal(BearingSymmetry.HalfTurn, MeanOf(square, isLong, isLong)!.Value.Symmetry);
        Assert.Equal(BearingSymmetry.QuarterTurn, MeanOf(square, isLong)!.Value.Symmetry);
    }

    [Fact]
    public void Add_AnotherTracks_IsAsIfAllWereOne()
    {
        BearingMean a = default;
        BearingMean b = default;
        a.Add(Bearing(10, 2));
        b.Add(Bearing(16, 3));
        b.Add(Bearing(12, 1));
        a.Add(b);
        TargetBearing all = MeanOf(Bearing(10, 2), Bearing(16, 3), Bearing(12, 1))!.Value;
        Assert.Equal(all.Angle.Degrees, a.Value!.Value.Angle.Degrees, 1e-9);
        Assert.Equal(all.Sigma.Degrees, a.Value!.Value.Sigma.Degrees, 1e-9);
    }

    [Fact]
    public void Track_ReportsWithBearings_HasTheirMeanAndTheirSystematicPart()
    {
        using var rig = new FusionRig();
        foreach (double degrees in new[] { 178, 2, 0, 180 })
            rig.Observe(0, 0, Report(degrees));
        TargetBearing bearing = rig.Only.Bearing!.Value;
        Assert.Equal(0, bearing.DistanceTo(Angle.Zero).Degrees, 0.01);
        Assert.Equal(1.5, bearing.Sigma.Degrees, 0.01);
        Assert.Equal(1, bearing.SystematicSigma.Degrees, 1e-9);
        Assert.Equal(Math.Sqrt(3.25), bearing.TotalSigma.Degrees, 0.01);

        rig.Observe(0, 0, FusionRig.Report(0, 0));
        Assert.Equal(bearing, rig.Only.Bearing);
    }

    private static TargetReport Report(double degrees)
        => FusionRig.Report(0, 0) with
        {
            Bearing = Bearing(degrees, 3) with { SystematicSigma = Angle.FromDegrees(1) },
        };

    private static TargetBearing? MeanOf(params TargetBearing[] bearings)
    {
        var mean = default(BearingMean);
        foreach (TargetBearing bearing in bearings)
            mean.Add(bearing);
        return mean.Value;
    }

    private static TargetBearing Bearing(
        double degrees, double sigmaDegrees, BearingSymmetry symmetry = BearingSymmetry.HalfTurn)
        => new(Angle.FromDegrees(degrees), Angle.FromDegrees(sigmaDegrees), symmetry);

    private static double Gauss(Random random)
        => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
