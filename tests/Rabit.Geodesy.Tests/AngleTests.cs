using System;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Geodesy.Tests;

public sealed class AngleTests
{
    [Fact]
    public void Degrees_OfAnAngleFromDegrees_AreExactlyThose()
    {
        var numbers = new SeededNumbers(3);
        for (int i = 0; i < 1000; i++)
        {
            double degrees = numbers.Uniform(-360, 360);
            Assert.Equal(degrees, Angle.FromDegrees(degrees).Degrees);
            double radians = numbers.Uniform(-7, 7);
            Assert.Equal(radians, Angle.FromRadians(radians).Radians);
        }

        Assert.Equal(Math.PI, Angle.FromDegrees(180).Radians);
        Assert.Equal(Math.PI / 2, Angle.FromDegrees(90).Radians);
    }

    [Theory]
    [InlineData(370, 10)]
    [InlineData(-190, 170)]
    [InlineData(180, 180)]
    [InlineData(-180, -180)]
    [InlineData(90, 90)]
    public void Wrapped_AnyAngle_IsTheSameDirectionInRange(double degrees, double expected)
    {
        Assert.Equal(expected, Angle.FromDegrees(degrees).Wrapped().Degrees, 1e-12);
        Assert.Equal(expected, Angle.FromRadians(degrees * Angle.RadiansPerDegree).Wrapped().Degrees, 1e-12);
    }

    [Fact]
    public void Wrapped_StraightBackwards_HasDegreesAndRadiansOfOneSign()
    {
        for (int half = -19; half <= 19; half += 2)
        {
            Angle wrapped = Angle.FromDegrees(180.0 * half).Wrapped();
            Assert.Equal(wrapped.Radians, wrapped.Degrees * Angle.RadiansPerDegree, 1e-12);
        }
    }

    [Fact]
    public void Arithmetic_OfAngles_KeepsBothUnits()
    {
        Angle a = Angle.FromDegrees(30);
        Assert.Equal(75, (a + Angle.FromDegrees(45)).Degrees);
        Assert.Equal(-15, (a - Angle.FromDegrees(45)).Degrees);
        Assert.Equal((60.0, 60.0, 15.0), ((2 * a).Degrees, (a * 2).Degrees, (a / 2).Degrees));
        Assert.Equal(3, Angle.FromDegrees(90) / a, 1e-15);
        Assert.True(a < Angle.FromDegrees(31) && a >= Angle.FromDegrees(30) && a.CompareTo(Angle.Zero) > 0);
        Assert.False(Angle.NaN.IsFinite || Angle.NaN < a || Angle.NaN >= a);
    }
}
