using System.Globalization;
using System.Text;

namespace Rabit.Mavlink.Definitions;

/// <summary>Numbers as text, the same in every culture.</summary>
internal static class NumberFormat
{
    public static void Append(StringBuilder text, long value)
        => text.Append(value.ToString(CultureInfo.InvariantCulture));

    public static void Append(StringBuilder text, ulong value)
        => text.Append(value.ToString(CultureInfo.InvariantCulture));

    // "R" is not always read back as the same number on these runtimes, nor has it the same digits as on .NET.
    public static void Append(StringBuilder text, float value) => ShortestNumber.Append(text, value);

    public static void Append(StringBuilder text, double value) => ShortestNumber.Append(text, value);
}
