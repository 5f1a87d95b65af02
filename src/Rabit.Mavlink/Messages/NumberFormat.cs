using System.Globalization;
using System.Text;

namespace Rabit.Mavlink;

/// <summary>Numbers as text, the same in every culture; on .NET without a string in between.</summary>
internal static class NumberFormat
{
#if NET
    private const int Longest = 32;   // "-1.7976931348623157E+308" is the longest of all

    public static void Append(StringBuilder text, long value)
    {
        System.Span<char> characters = stackalloc char[Longest];
        value.TryFormat(characters, out int length, default, CultureInfo.InvariantCulture);
        text.Append(characters.Slice(0, length));
    }

    public static void Append(StringBuilder text, ulong value)
    {
        System.Span<char> characters = stackalloc char[Longest];
        value.TryFormat(characters, out int length, default, CultureInfo.InvariantCulture);
        text.Append(characters.Slice(0, length));
    }

    public static void Append(StringBuilder text, float value)
    {
        System.Span<char> characters = stackalloc char[Longest];
        value.TryFormat(characters, out int length, "R", CultureInfo.InvariantCulture);
        text.Append(characters.Slice(0, length));
    }

    public static void Append(StringBuilder text, double value)
    {
        System.Span<char> characters = stackalloc char[Longest];
        value.TryFormat(characters, out int length, "R", CultureInfo.InvariantCulture);
        text.Append(characters.Slice(0, length));
    }
#else
    private static readonly string[] SingleFormats = ["G7", "G8", "G9"];
    private static readonly string[] DoubleFormats = ["G15", "G16", "G17"];

    public static void Append(StringBuilder text, long value) => text.Append(value.ToString(CultureInfo.InvariantCulture));

    public static void Append(StringBuilder text, ulong value) => text.Append(value.ToString(CultureInfo.InvariantCulture));

    // "R" is not always read back as the same number on these runtimes.
    public static void Append(StringBuilder text, float value)
    {
        string shortest = "";
        foreach (string format in SingleFormats)
        {
            shortest = ((double)value).ToString(format, CultureInfo.InvariantCulture);   // Mono rounds the last digit of a float wrongly
            if (float.TryParse(shortest, NumberStyles.Float, CultureInfo.InvariantCulture, out float read) && read.Equals(value))
                break;
        }

        text.Append(value == 0 && 1 / value < 0 ? "-0" : shortest);   // they print the zero without its sign
    }

    public static void Append(StringBuilder text, double value)
    {
        string shortest = "";
        foreach (string format in DoubleFormats)
        {
            shortest = value.ToString(format, CultureInfo.InvariantCulture);
            if (double.TryParse(shortest, NumberStyles.Float, CultureInfo.InvariantCulture, out double read) && read.Equals(value))
                break;
        }

        text.Append(value == 0 && 1 / value < 0 ? "-0" : shortest);
    }
#endif
}
