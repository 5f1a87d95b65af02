using System;
using System.Globalization;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>Numbers as definitions write them: <c>12</c>, <c>-1</c>, <c>0x1F</c>, <c>0b101</c>, <c>2**4</c>.</summary>
internal static class NumberText
{
    public static bool TryParse(string text, out decimal value)
    {
        value = 0;
        text = text.Trim();
        int power = text.IndexOf("**", StringComparison.Ordinal);
        if (power >= 0)
            return TryPower(text.Substring(0, power), text.Substring(power + 2), out value);
        if (text.StartsWith("0x", StringComparison.OrdinalIgnoreCase))
        {
            bool isHex = ulong.TryParse(
                text.Substring(2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out ulong bits);
            value = bits;
            return isHex;
        }

        if (text.StartsWith("0b", StringComparison.OrdinalIgnoreCase))
            return TryBinary(text.Substring(2), out value);
        return decimal.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value)
            && Fits(value);
    }

    /// <summary>Whether it is a 64-bit integer, signed or not.</summary>
    public static bool Fits(decimal value) => value is >= long.MinValue and <= ulong.MaxValue;

    private static bool TryBinary(string digits, out decimal value)
    {
        ulong bits = 0;
        value = 0;
        if (digits.Length is 0 or > 64)
            return false;
        foreach (char digit in digits)
        {
            if (digit is not ('0' or '1'))
                return false;
            bits = (bits << 1) | (uint)(digit - '0');
        }

        value = bits;
        return true;
    }

    private static bool TryPower(string baseText, string exponentText, out decimal value)
    {
        value = 1;
        if (!TryParse(baseText, out decimal factor) || !TryParse(exponentText, out decimal exponent)
            || exponent is < 0 or > 64)
            return false;
        for (int i = 0; i < exponent; i++)
        {
            // Asked before, since a decimal throws where it overflows.
            if (factor != 0 && Math.Abs(value) > ulong.MaxValue / Math.Abs(factor))
                return false;
            value *= factor;
        }

        return Fits(value);
    }
}
