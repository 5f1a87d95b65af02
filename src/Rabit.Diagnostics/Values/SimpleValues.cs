using System;
using System.Numerics;
using System.Reflection;
using System.Text.Json;

namespace Rabit.Diagnostics.Values;

/// <summary>Values that are one number, text or word of JSON.</summary>
internal static class SimpleValues
{
    /// <returns>False where it has parts; nothing is written then.</returns>
    public static bool TryWrite(Utf8JsonWriter json, object value, int maxTextLength)
    {
        switch (value)
        {
            case bool truth:
                json.WriteBooleanValue(truth);
                return true;
            case Enum:
                json.WriteStringValue(value.ToString());
                return true;
            case string text:
                WriteText(json, text, maxTextLength);
                return true;
            case char character:
                WriteText(json, character.ToString(), maxTextLength);
                return true;
            case Delegate or MemberInfo or Assembly or IntPtr or UIntPtr:
                json.WriteStringValue($"(no value: {TypeText.Of(value.GetType())})");
                return true;
            default:
                return TryWriteNumber(json, value) || TryWriteText(json, value);
        }
    }

    private static bool TryWriteNumber(Utf8JsonWriter json, object value)
    {
        switch (value)
        {
            case sbyte or short or int or long:
                json.WriteNumberValue(((IConvertible)value).ToInt64(null));
                return true;
            case byte or ushort or uint or ulong:
                json.WriteNumberValue(((IConvertible)value).ToUInt64(null));
                return true;
            case float single when float.IsFinite(single):
                json.WriteNumberValue(single);
                return true;
            case double number when double.IsFinite(number):
                json.WriteNumberValue(number);
                return true;
            case decimal number:
                json.WriteNumberValue(number);
                return true;
            default:
                return false;
        }
    }

    // Numbers that JSON does not have, and types of the base library whose text says all.
    private static bool TryWriteText(Utf8JsonWriter json, object value)
    {
        if (value is not (float or double or Half or Int128 or UInt128 or BigInteger or TimeSpan or DateTime
            or DateTimeOffset or DateOnly or TimeOnly or Guid or Version or Uri or Index or Range))
            return false;
        string? format = value is DateTime or DateTimeOffset or DateOnly or TimeOnly ? "o" : null;
        json.WriteStringValue(value is IFormattable formattable
            ? formattable.ToString(format, System.Globalization.CultureInfo.InvariantCulture)
            : value.ToString());
        return true;
    }

    private static void WriteText(Utf8JsonWriter json, string text, int maxLength)
    {
        if (text.Length <= maxLength)
            json.WriteStringValue(text);
        else
            json.WriteStringValue(string.Create(
                System.Globalization.CultureInfo.InvariantCulture,
                $"{text.AsSpan(0, maxLength)}(left out: {text.Length - maxLength} characters)"));
    }
}
