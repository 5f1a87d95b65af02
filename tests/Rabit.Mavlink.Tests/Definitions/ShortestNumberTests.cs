using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Rabit.Mavlink.Definitions;
using Rabit.Mavlink.Tests.Protocols;
using Xunit;

namespace Rabit.Mavlink.Tests.Definitions;

/// <summary>Floating point numbers as text: as .NET writes them, on every runtime.</summary>
public class ShortestNumberTests
{
    [Theory]
    [InlineData(1e-5, "1E-05")]
    [InlineData(0.0001, "0.0001")]
    [InlineData(-0.00012345, "-0.00012345")]
    [InlineData(1e17, "1E+17")]
    [InlineData(12345678901234567d, "12345678901234568")]
    [InlineData(123456789012345678d, "1.2345678901234568E+17")]
    [InlineData(double.Epsilon, "5E-324")]
    [InlineData(double.MaxValue, "1.7976931348623157E+308")]
    [InlineData(5.684341886080802E-14, "5.684341886080802E-14")]
    [InlineData(9007199254740992d, "9007199254740992")]
    [InlineData(1.5, "1.5")]
    [InlineData(100d, "100")]
    [InlineData(0d, "0")]
    [InlineData(-0d, "-0")]
    [InlineData(double.NaN, "NaN")]
    [InlineData(double.NegativeInfinity, "-Infinity")]
    public void Double_IsAsDotNetWritesIt(double value, string expected) => Assert.Equal(expected, Text(value));

    [Theory]
    [InlineData(0.1f, "0.1")]
    [InlineData(123456789f, "123456790")]
    [InlineData(1e10f, "1E+10")]
    [InlineData(float.Epsilon, "1E-45")]
    [InlineData(float.MaxValue, "3.4028235E+38")]
    [InlineData(-273.15f, "-273.15")]
    [InlineData(float.PositiveInfinity, "Infinity")]
    public void Single_IsAsDotNetWritesIt(float value, string expected) => Assert.Equal(expected, Text(value));

    [Fact]
    public void AnyBits_AreReadBackAndAreWhatDotNetWrites()
    {
        const ulong Seed = 20_261_121;
        var random = new ProtocolRandom(Seed);
        foreach (long bits in DoubleBits(random))
        {
            double value = BitConverter.Int64BitsToDouble(bits);
            string text = Text(value);
            string context = $"seed {Seed}, bits {bits:X16}: {text}";
            Assert.True(text == Formatted(value), context);
            Assert.True(double.IsNaN(value) || IsReadBack(text, value), context);

            float single = MavlinkParameter.ToFloat(unchecked((uint)(bits >> 32)));
            text = Text(single);
            context = $"seed {Seed}, bits {unchecked((uint)(bits >> 32)):X8}: {text}";
            Assert.True(text == Formatted(single), context);
            Assert.True(float.IsNaN(single) || float.Parse(text, CultureInfo.InvariantCulture).Equals(single), context);
        }
    }

    // Mono 6.8 itself reads some texts as the number beside the right one: there the texts are shown to be right by
    // .NET, which writes and reads the same.
    private static bool IsReadBack(string text, double value)
    {
        double read = double.Parse(text, CultureInfo.InvariantCulture);
        bool mayBeTheNeighbour = Type.GetType("Mono.Runtime") is not null;
        return read.Equals(value)
            || (mayBeTheNeighbour
                && Math.Abs(BitConverter.DoubleToInt64Bits(read) - BitConverter.DoubleToInt64Bits(value)) == 1);
    }

    // Any bits at all, small whole numbers and short fractions, powers of two (below which the next number is closer),
    // and what is next to them.
    private static IEnumerable<long> DoubleBits(ProtocolRandom random)
    {
        for (int i = 0; i < 20_000; i++)
            yield return unchecked((long)random.Next());
        for (int i = 0; i < 5_000; i++)
            yield return BitConverter.DoubleToInt64Bits(random.Below(100_000) / Math.Pow(10, random.Below(12)));
        for (long exponent = 0; exponent < 0x7FF; exponent++)
        {
            for (long next = -1; next <= 1; next++)
                yield return Math.Max(0, (exponent << 52) + next);
        }

        for (long exponent = 0; exponent < 0xFF; exponent++)
        {
            for (long next = -1; next <= 1; next++)
                yield return Math.Max(0, (exponent << 23) + next) << 32;
        }
    }

    private static string Text(double value)
    {
        var text = new StringBuilder();
        ShortestNumber.Append(text, value);
        return text.ToString();
    }

    private static string Text(float value)
    {
        var text = new StringBuilder();
        ShortestNumber.Append(text, value);
        return text.ToString();
    }

    // What the library writes: on .NET by the runtime's own means.
    private static string Formatted(double value)
    {
        var text = new StringBuilder();
        NumberFormat.Append(text, value);
        return text.ToString();
    }

    private static string Formatted(float value)
    {
        var text = new StringBuilder();
        NumberFormat.Append(text, value);
        return text.ToString();
    }
}
