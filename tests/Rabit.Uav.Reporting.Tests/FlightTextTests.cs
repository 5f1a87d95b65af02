using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>Figures of a flight as text.</summary>
public sealed class FlightTextTests
{
    [Theory]
    [InlineData(-0.3, "0", "0")]
    [InlineData(-0.04, "0.0", "0.0")]
    [InlineData(-0.04, "0.##", "-0.04")]
    [InlineData(-0.6, "0", "-1")]
    [InlineData(-20, "0.0", "-20.0")]
    [InlineData(double.NaN, "0", "–")]
    [InlineData(double.NegativeInfinity, "0", "–")]
    public void Number_RoundedToZero_HasNoSign(double value, string format, string expected)
        => Assert.Equal(expected, FlightText.Number(value, format));
}
