using System;
using Xunit;

namespace Rabit.Geodesy.Tests;

public sealed class VectorTests
{
    [Fact]
    public void Arithmetic_OfVectors_IsByComponents()
    {
        var a = new NedVector(1, -2, 3);
        var b = new NedVector(0.5, 4, -1);
        Assert.Equal(new NedVector(1.5, 2, 2), a + b);
        Assert.Equal(new NedVector(0.5, -6, 4), a - b);
        Assert.Equal(new NedVector(-1, 2, -3), -a);
        Assert.Equal(new NedVector(2, -4, 6), 2 * a);
        Assert.True(a * 2 == a / 0.5 && a != b);
        Assert.Equal(-10.5, NedVector.Dot(a, b));
        Assert.Equal(new NedVector(0, 0, 1), NedVector.Cross(new NedVector(1, 0, 0), new NedVector(0, 1, 0)));
        Assert.Equal(0, NedVector.Dot(a, NedVector.Cross(a, b)), 1e-15);
        Assert.Equal(new BodyVector(0, 0, 1), BodyVector.Cross(new BodyVector(1, 0, 0), new BodyVector(0, 1, 0)));
        Assert.Equal(new EcefVector(0, 0, 1), EcefVector.Cross(new EcefVector(1, 0, 0), new EcefVector(0, 1, 0)));
    }

    [Fact]
    public void Length_OfVectors_IsEuclidean()
    {
        var v = new NedVector(3, 4, 12);
        Assert.Equal((13.0, 169.0, 5.0), (v.Length, v.LengthSquared, v.HorizontalLength));
        Assert.Equal(1, v.Normalized().Length, 1e-15);
        Assert.Equal(Math.Atan2(4, 3), v.Azimuth.Radians);
        Assert.False(NedVector.Zero.Normalized().IsFinite);
        Assert.True(v.IsFinite);
        Assert.False(new BodyVector(0, double.PositiveInfinity, 0).IsFinite);
    }

    [Fact]
    public void Positions_AndDisplacements_GoTogether()
    {
        var a = new NedPosition(10, 20, -30);
        NedPosition b = a + new NedVector(3, 4, 12);
        Assert.Equal(new NedVector(3, 4, 12), b - a);
        Assert.Equal(a, b - new NedVector(3, 4, 12));
        Assert.Equal((13.0, 5.0), (a.DistanceTo(b), a.HorizontalDistanceTo(b)));
        Assert.Equal(new NedVector(10, 20, -30), a - NedPosition.Origin);

        var centre = new EcefPosition(4e6, 6e5, 4.8e6);
        EcefPosition away = centre + new EcefVector(1, 2, 2);
        Assert.Equal(3, centre.DistanceTo(away));
        Assert.Equal(centre, away - (away - centre));
    }

    [Fact]
    public void Equality_OfAllValues_IsByValue()
    {
        Assert.Equal(EulerAngles.FromDegrees(1, 2, 3), EulerAngles.FromDegrees(1, 2, 3));
        Assert.NotEqual(EulerAngles.FromDegrees(1, 2, 3), EulerAngles.FromDegrees(1, 2, 4));
        Assert.True(GeodeticPosition.FromDegrees(47, 8, 400) == GeodeticPosition.FromDegrees(47, 8, 400));
        Assert.Equal(
            GeodeticPosition.FromDegrees(47, 8, 400).GetHashCode(),
            GeodeticPosition.FromDegrees(47, 8, 400).GetHashCode());
        Assert.Equal(new NedVector(double.NaN, 0, 0), new NedVector(double.NaN, 0, 0));
        Assert.Equal(
            MgrsPosition.From(new GeographicPoint(Angle.FromDegrees(47), Angle.FromDegrees(8))),
            MgrsPosition.From(new GeographicPoint(Angle.FromDegrees(47), Angle.FromDegrees(8))));
    }

    [Fact]
    public void ToString_OfValues_IsTheSameInEveryCulture()
    {
        Assert.Equal("(1.5, -2, 0.125)", new NedVector(1.5, -2, 0.125).ToString());
        Assert.Equal("(1.5, -2, 0.125) m", new NedPosition(1.5, -2, 0.125).ToString());
        Assert.Equal("roll 5°, pitch -2.5°, yaw 90°", EulerAngles.FromDegrees(5, -2.5, 90).ToString());
        Assert.Equal(
            "47.0000000, 8.0000000, 400.5 m above mean sea level",
            GeodeticPosition.FromDegrees(47, 8, 400.5).ToString());
        Assert.Equal("4.9 m x 2.45 m at 0°", new HorizontalCovariance(4, 0, 1).ToString());
        Assert.Equal("(0.1, 0, -0.02) rad/s", BodyRates.FromRadiansPerSecond(0.1, 0, -0.02).ToString());
    }
}
