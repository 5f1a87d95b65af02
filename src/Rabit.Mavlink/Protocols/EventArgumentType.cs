using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Rabit.Mavlink.Definitions;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Protocols;

/// <summary>The type of an event's argument: a number, perhaps with a text for each value or bit.</summary>
/// <param name="number">The number.</param>
/// <param name="texts">Of values, or of bits; null for a plain number.</param>
/// <param name="isBitfield">Whether they are of bits.</param>
/// <param name="separator">Between the texts of bits.</param>
internal sealed class EventArgumentType(
    EventNumber number, IReadOnlyDictionary<ulong, string>? texts = null, bool isBitfield = false,
    string separator = "|")
{
    public int Size => number switch
    {
        EventNumber.Int8 or EventNumber.UInt8 => 1,
        EventNumber.Int16 or EventNumber.UInt16 => 2,
        EventNumber.Int32 or EventNumber.UInt32 or EventNumber.Single => 4,
        _ => 8,
    };

    /// <summary>Writes the value at a place of the arguments.</summary>
    /// <param name="text">Where to write.</param>
    /// <param name="arguments">Of the event; the value is within them.</param>
    /// <param name="offset">Of the value.</param>
    /// <param name="decimals">Digits behind the point of a floating point number; -1 for as many as needed.</param>
    public void Append(StringBuilder text, in ByteArray40 arguments, int offset, int decimals)
    {
        ulong bits = 0;
        for (int i = Size - 1; i >= 0; i--)
            bits = (bits << 8) | arguments[offset + i];
        if (texts is null)
            AppendNumber(text, bits, decimals);
        else if (isBitfield)
            AppendBits(text, bits);
        else if (texts.TryGetValue(bits, out string? known))
            text.Append(known);
        else
            AppendUnknown(text, bits);
    }

    private void AppendBits(StringBuilder text, ulong bits)
    {
        bool isFirst = true;
        for (ulong rest = bits; rest != 0; rest &= rest - 1)
        {
            ulong bit = rest & (~rest + 1);
            text.Append(isFirst ? string.Empty : separator);
            isFirst = false;
            if (texts!.TryGetValue(bit, out string? known))
                text.Append(known);
            else
                AppendUnknown(text, bit);
        }
    }

    private void AppendUnknown(StringBuilder text, ulong bits)
    {
        text.Append("(unknown: ");
        AppendNumber(text, bits, -1);
        text.Append(')');
    }

    private void AppendNumber(StringBuilder text, ulong bits, int decimals)
    {
        switch (number)
        {
            case EventNumber.Int8: NumberFormat.Append(text, (long)unchecked((sbyte)bits)); break;
            case EventNumber.Int16: NumberFormat.Append(text, (long)unchecked((short)bits)); break;
            case EventNumber.Int32: NumberFormat.Append(text, (long)unchecked((int)bits)); break;
            case EventNumber.Int64: NumberFormat.Append(text, unchecked((long)bits)); break;
            case EventNumber.Single: AppendFloat(text, MavlinkParameter.ToFloat((uint)bits), decimals); break;
            default: NumberFormat.Append(text, bits); break;
        }
    }

    private static void AppendFloat(StringBuilder text, float value, int decimals)
    {
        if (decimals < 0 || float.IsNaN(value) || float.IsInfinity(value))
            NumberFormat.Append(text, value);
        else
            text.Append(((double)value).ToString(
                "F" + decimals.ToString(CultureInfo.InvariantCulture),
                CultureInfo.InvariantCulture));
    }
}
