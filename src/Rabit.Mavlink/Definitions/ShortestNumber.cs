using System;
using System.Numerics;
using System.Text;

namespace Rabit.Mavlink.Definitions;

/// <summary>
/// Floating point numbers with the fewest digits that are read back as the same number, and of these the closest
/// (Burger and Dybvig, "Printing Floating-Point Numbers Quickly and Accurately", 1996). Exactly what .NET writes with
/// "R", for runtimes whose own formats differ in the last digit: .NET Framework and Mono.
/// </summary>
internal static class ShortestNumber
{
    private const int DoubleFractionBits = 52;
    private const int DoubleExponentBias = 1075;   // of the mantissa as a whole number
    private const int SingleFractionBits = 23;
    private const int SingleExponentBias = 150;

    // More digits before the point than these, or more than three zeros behind it, are written with an exponent.
    private const int DoubleDigitsBeforePoint = 17;
    private const int SingleDigitsBeforePoint = 9;
    private const int ZerosBehindPoint = 3;

    private static readonly double Log10Of2 = Math.Log10(2);

    public static void Append(StringBuilder text, double value)
    {
        if (AppendSpecial(text, value))
            return;
        long bits = BitConverter.DoubleToInt64Bits(value);
        Append(
            text, bits & ((1L << DoubleFractionBits) - 1), (int)(bits >> DoubleFractionBits) & 0x7FF,
            DoubleFractionBits, DoubleExponentBias, DoubleDigitsBeforePoint);
    }

    public static void Append(StringBuilder text, float value)
    {
        if (AppendSpecial(text, value))
            return;
        uint bits = MavlinkParameter.FromFloat(value);
        Append(
            text, bits & ((1L << SingleFractionBits) - 1), (int)(bits >> SingleFractionBits) & 0xFF, SingleFractionBits,
            SingleExponentBias, SingleDigitsBeforePoint);
    }

    // Also the sign, which these runtimes leave out of zero.
    private static bool AppendSpecial(StringBuilder text, double value)
    {
        if (double.IsNaN(value))
        {
            text.Append("NaN");
            return true;
        }

        if (value < 0 || (value == 0 && 1 / value < 0))
            text.Append('-');
        if (double.IsInfinity(value))
            text.Append("Infinity");
        else if (value == 0)
            text.Append('0');
        return value == 0 || double.IsInfinity(value);
    }

    private static void Append(
        StringBuilder text, long fraction, int exponent, int fractionBits, int bias, int digitsBeforePoint)
    {
        long mantissa = exponent == 0 ? fraction : fraction | (1L << fractionBits);
        var digits = new char[digitsBeforePoint + 1];
        int count = FindDigits(
            mantissa, Math.Max(exponent, 1) - bias, isBelowCloser: fraction == 0 && exponent > 1, digits,
            out int point);
        Write(text, digits, count, point, digitsBeforePoint);
    }

    /// <param name="mantissa">Times two to the exponent is the number.</param>
    /// <param name="exponent">Of two.</param>
    /// <param name="isBelowCloser">Whether the next number below is half as far away as the next above.</param>
    /// <param name="digits">The digits.</param>
    /// <param name="point">Before which of them the decimal point is.</param>
    /// <returns>How many digits.</returns>
    private static int FindDigits(long mantissa, int exponent, bool isBelowCloser, char[] digits, out int point)
    {
        // The number is value / scale; what is less than a margin away is read back as the same number.
        int shift = isBelowCloser ? 2 : 1;
        BigInteger value = new BigInteger(mantissa) << (Math.Max(exponent, 0) + shift);
        BigInteger scale = BigInteger.One << (Math.Max(-exponent, 0) + shift);
        BigInteger below = BigInteger.One << Math.Max(exponent, 0);
        BigInteger above = isBelowCloser ? below << 1 : below;
        bool isEven = (mantissa & 1) == 0;

        point = (int)Math.Ceiling((exponent + Math.Log(mantissa, 2)) * Log10Of2 - 1e-10);
        var power = BigInteger.Pow(10, Math.Abs(point));
        if (point >= 0)
            scale *= power;
        else
            (value, below, above) = (value * power, below * power, above * power);
        if (IsAtLeast(value + above, scale, isEven))
            point++;
        else
            (value, below, above) = (value * 10, below * 10, above * 10);

        for (int count = 0; ; (value, below, above) = (value * 10, below * 10, above * 10))
        {
            var digit = (int)BigInteger.DivRem(value, scale, out value);
            bool mayEnd = IsAtLeast(below, value, isEven);
            bool mayRoundUp = IsAtLeast(value + above, scale, isEven);
            if (mayEnd || mayRoundUp)
            {
                int half = (value << 1).CompareTo(scale);
                bool isUp = mayEnd && mayRoundUp ? half > 0 || (half == 0 && (digit & 1) != 0) : mayRoundUp;
                digits[count++] = (char)('0' + digit + (isUp ? 1 : 0));
                return count;
            }

            digits[count++] = (char)('0' + digit);
        }
    }

    // A number half-way between two is read back as the one whose mantissa is even.
    private static bool IsAtLeast(in BigInteger larger, in BigInteger smaller, bool orEqual)
    {
        int comparison = larger.CompareTo(smaller);
        return comparison > 0 || (comparison == 0 && orEqual);
    }

    private static void Write(StringBuilder text, char[] digits, int count, int point, int digitsBeforePoint)
    {
        if (point > Math.Max(count, digitsBeforePoint) || point < -ZerosBehindPoint)
        {
            text.Append(digits[0]);
            if (count > 1)
                text.Append('.').Append(digits, 1, count - 1);
            int exponent = point - 1;
            text.Append('E').Append(exponent < 0 ? '-' : '+');
            if (Math.Abs(exponent) < 10)
                text.Append('0');
            NumberFormat.Append(text, (long)Math.Abs(exponent));
        }
        else if (point <= 0)
        {
            text.Append("0.").Append('0', -point).Append(digits, 0, count);
        }
        else if (point >= count)
        {
            text.Append(digits, 0, count).Append('0', point - count);
        }
        else
        {
            text.Append(digits, 0, point).Append('.').Append(digits, point, count - point);
        }
    }
}
