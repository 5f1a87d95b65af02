using System;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Geodesy.Tests;

public sealed class PositionTextTests
{
    [Theory]
    [InlineData("47.5, -8.25", 47.5, -8.25)]
    [InlineData("47.5 -8.25", 47.5, -8.25)]
    [InlineData("47.5N 8.25W", 47.5, -8.25)]
    [InlineData("8.25 W, 47.5 N", 47.5, -8.25)]
    [InlineData("S 33.5 E 151.25", -33.5, 151.25)]
    [InlineData("47°30'N 8°15'W", 47.5, -8.25)]
    [InlineData("47°30'36.0\"N, 8°15'00.5\"E", 47.51, 8.25013888888889)]
    [InlineData("-0°30'0\" 180°", -0.5, 180)]
    public void TryParse_AsPeopleWrite_Reads(string text, double latitude, double longitude)
    {
        Assert.True(PositionText.TryParse(text, out GeographicPoint point));
        Assert.Equal(latitude, point.Latitude.Degrees, 1e-12);
        Assert.Equal(longitude, point.Longitude.Degrees, 1e-12);
    }

    [Theory]
    [InlineData("")]
    [InlineData(null)]
    [InlineData("47.5")]
    [InlineData("47.5, 8.25, 3")]
    [InlineData("90.1, 8")]
    [InlineData("47.5, 180.5")]
    [InlineData("47.5N 8.25S")]
    [InlineData("47.5E 8.25W")]
    [InlineData("-47.5S 8.25E")]
    [InlineData("47°60'N 8°15'W")]
    [InlineData("47.5°30'N 8°15'W")]
    [InlineData("47°30.5'10\"N 8°15'W")]
    [InlineData("61TMT6500050000")]
    [InlineData("32IMT6500050000")]
    [InlineData("32TMT650005000")]
    [InlineData("32TAT6500050000")]
    [InlineData("NaN, 8")]
    [InlineData("1e1, 8")]
    public void TryParse_WhatIsNoPosition_IsFalse(string? text) => Assert.False(PositionText.TryParse(text, out _));

    [Fact]
    public void Format_AllStyles_ComeBackWithinTheirStep()
    {
        var numbers = new SeededNumbers(9);
        for (int i = 0; i < 500; i++)
        {
            var point = new GeographicPoint(
                Angle.FromDegrees(numbers.Uniform(-79.9, 83.9)), Angle.FromDegrees(numbers.Uniform(-180, 180)));
            foreach ((PositionStyle style, double metres) in new[]
            {
                (PositionStyle.DecimalDegrees, 0.01),
                (PositionStyle.DegreesMinutesSeconds, 0.03),
                (PositionStyle.Mgrs, 0.8)
            })
            {
                string text = PositionText.Format(point, style);
                Assert.True(PositionText.TryParse(text, out GeographicPoint back), $"seed 9, case {i}: {text}");
                double off = Geodesic.Inverse(point, back).DistanceMetres;
                Assert.True(off < metres, $"seed 9, case {i}: {text} is {off} m off");
            }
        }
    }

    [Fact]
    public void Format_JustBelowAFullMinute_HasNoSixtySeconds()
        => Assert.Equal(
            "48°00'00.000\"N 0°00'00.000\"E",
            PositionText.Format(
                new GeographicPoint(Angle.FromDegrees(47.99999999999), Angle.Zero),
                PositionStyle.DegreesMinutesSeconds));

    [Theory]
    [InlineData(double.NaN, 8)]
    [InlineData(47, double.NaN)]
    [InlineData(double.PositiveInfinity, 8)]
    [InlineData(47, double.NegativeInfinity)]
    [InlineData(91, 8)]
    [InlineData(-90.001, 8)]
    public void Format_NoPlaceOnTheEarth_IsRefused(double latitude, double longitude)
    {
        var point = new GeographicPoint(Angle.FromDegrees(latitude), Angle.FromDegrees(longitude));
        Assert.False(point.IsValid);
        foreach (PositionStyle style
            in new[] { PositionStyle.DecimalDegrees, PositionStyle.DegreesMinutesSeconds, PositionStyle.Mgrs })
            Assert.Throws<ArgumentOutOfRangeException>(() => PositionText.Format(point, style));
        Assert.StartsWith("no place (", point.ToString(), StringComparison.Ordinal);
        Assert.False(PositionText.TryParse(point.ToString(), out _));
    }

    [Fact]
    public void Format_LongitudeBeyondTheDateLine_IsWrapped()
    {
        var point = new GeographicPoint(Angle.FromDegrees(-90), Angle.FromDegrees(190));
        Assert.Equal("-90.0000000, -170.0000000", PositionText.Format(point, PositionStyle.DecimalDegrees));
        Assert.Equal(
            "90°00'00.000\"S 170°00'00.000\"W", PositionText.Format(point, PositionStyle.DegreesMinutesSeconds));
    }
}
