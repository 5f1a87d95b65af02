using System.Globalization;
using Rabit.Mavlink.Generator.Reading;
using Xunit;

namespace Rabit.Mavlink.Tests.Generator;

public class NumberTextTests
{
    [Theory]
    [InlineData("0", "0")]
    [InlineData(" 12 ", "12")]
    [InlineData("-1", "-1")]
    [InlineData("0x1F", "31")]
    [InlineData("0b101", "5")]
    [InlineData("2**4", "16")]
    [InlineData("-2**63", "-9223372036854775808")]
    [InlineData("0**64", "0")]
    [InlineData("2**0", "1")]
    [InlineData("2**63", "9223372036854775808")]
    [InlineData("18446744073709551615", "18446744073709551615")]
    [InlineData("-9223372036854775808", "-9223372036854775808")]
    [InlineData("0xFFFFFFFFFFFFFFFF", "18446744073709551615")]
    public void TryParse_AllForms_GiveTheNumber(string text, string expected)
    {
        Assert.True(NumberText.TryParse(text, out decimal value));
        Assert.Equal(decimal.Parse(expected, CultureInfo.InvariantCulture), value);
    }

    [Theory]
    [InlineData("")]
    [InlineData("x")]
    [InlineData("1.5")]
    [InlineData("1,000")]
    [InlineData("0x")]
    [InlineData("0xG")]
    [InlineData("0b")]
    [InlineData("0b2")]
    [InlineData("2**")]
    [InlineData("2**-1")]
    [InlineData("2**64")]
    [InlineData("10**99")]
    [InlineData("18446744073709551615**2")]
    [InlineData("18446744073709551616")]
    [InlineData("0x10000000000000000")]
    public void TryParse_NoNumberOr64BitsExceeded_Refuses(string text)
        => Assert.False(NumberText.TryParse(text, out _));
}
