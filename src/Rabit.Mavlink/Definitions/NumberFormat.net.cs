using System.Globalization;
using System.Text;

namespace Rabit.Mavlink.Definitions;

/// <summary>Numbers as text, the same in every culture; on .NET without a string in between.</summary>
internal static class NumberFormat
{
    private const int MaxCharacters = 32;   // "-1.7976931348623157E+308" is the longest of all

    public static void Append(StringBuilder text, long value)
    {
        System.Span<char> characters = stackalloc char[MaxCharacters];
        value.TryFormat(characters, out int length, default, CultureInfo.InvariantCulture);
        text.Append(characters.Slice(0, length));
    }

    public static void Append(StringBuilder text, ulong value)
    {
        System.Span<char> characters = stackalloc char[MaxCharacters];
        value.TryFormat(characters, out int length, default, CultureInfo.InvariantCulture);
        text.Append(characters.Slice(0, length));
    }

    public static void Append(StringBuilder text, float value)
    {
        System.Span<char> characters = stackalloc char[MaxCharacters];
        value.TryFormat(characters, out int length, "R", CultureInfo.InvariantCulture);

        // Of some powers of two, below which the next number is closer than above, .NET 10 writes a digit too few.
        if (float.IsPow2(System.Math.Abs(value))
            && !float.Parse(characters.Slice(0, length), NumberStyles.Float, CultureInfo.InvariantCulture)
                .Equals(value))
            ShortestNumber.Append(text, value);
        else
            text.Append(characters.Slice(0, length));
    }

    public static void Append(StringBuilder text, double value)
    {
        System.Span<char> characters = stackalloc char[MaxCharacters];
        value.TryFormat(characters, out int length, "R", CultureInfo.InvariantCulture);
        if (double.IsPow2(System.Math.Abs(value))
            && !double.Parse(characters.Slice(0, length), NumberStyles.Float, CultureInfo.InvariantCulture)
                .Equals(value))
            ShortestNumber.Append(text, value);
        else
            text.Append(characters.Slice(0, length));
    }
}
