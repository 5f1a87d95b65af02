using System;
using System.Runtime.CompilerServices;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>A parameter as it is on the wire. A plain value; <c>default</c> is none.</summary>
/// <param name="Name">At most 16 characters, zero behind them.</param>
/// <param name="Type">What the vehicle keeps it as.</param>
/// <param name="Bits">The four bytes of the value field.</param>
/// <param name="Index">
/// Its place in the vehicle's list, which may shift on ArduPilot; 65535 where the vehicle gave none.
/// </param>
public readonly record struct MavlinkParameter(Text16 Name, MavParamType Type, uint Bits, int Index)
{
    /// <summary>The index that means none.</summary>
    public const int NoIndex = ushort.MaxValue;

    /// <summary>The value.</summary>
    /// <param name="encoding">How the vehicle packs integers.</param>
    /// <returns>The number; a 64-bit type, which does not fit on the wire, counts as a float.</returns>
    public double ToDouble(MavlinkParameterEncoding encoding) => Decode(Bits, Type, encoding);

    /// <summary>Unpacks a value field.</summary>
    /// <param name="bits">Its four bytes.</param>
    /// <param name="type">The type of the parameter.</param>
    /// <param name="encoding">How the vehicle packs integers.</param>
    /// <returns>The number.</returns>
    public static double Decode(uint bits, MavParamType type, MavlinkParameterEncoding encoding) =>
        encoding == MavlinkParameterEncoding.CCast ? ToFloat(bits) : type switch
        {
            // A double from here on: the arms would else agree on float.
            MavParamType.Uint8 => (double)(byte)bits,
            MavParamType.Int8 => unchecked((sbyte)bits),
            MavParamType.Uint16 => (ushort)bits,
            MavParamType.Int16 => unchecked((short)bits),
            MavParamType.Uint32 => bits,
            MavParamType.Int32 => unchecked((int)bits),
            _ => ToFloat(bits),
        };

    /// <summary>Packs a value field.</summary>
    /// <param name="value">The number; for an integer type it is rounded.</param>
    /// <param name="type">The type of the parameter.</param>
    /// <param name="encoding">How the vehicle packs integers.</param>
    /// <returns>Its four bytes.</returns>
    /// <exception cref="ArgumentOutOfRangeException">
    /// The type cannot hold the number, or the float on the wire cannot hold the integer exactly.
    /// </exception>
    public static uint Encode(double value, MavParamType type, MavlinkParameterEncoding encoding)
    {
        (double min, double max) = RangeOf(type);
        if (min == max)
            return FromFloat((float)value);
        double whole = Math.Round(value);
        if (!(whole >= min && whole <= max))
            throw new ArgumentOutOfRangeException(nameof(value), value, $"{type} holds {min} to {max}.");
        if (encoding == MavlinkParameterEncoding.Bytewise)
            return unchecked((uint)(long)whole);
        if ((float)whole != whole)
            throw new ArgumentOutOfRangeException(
                nameof(value), value,
                "The C-cast encoding sends a float, which holds integers exactly up to 16 777 216.");
        return FromFloat((float)whole);
    }

    /// <summary>The encoding by the capabilities in AUTOPILOT_VERSION.</summary>
    /// <param name="capabilities">Its capabilities.</param>
    /// <param name="encoding">The encoding.</param>
    /// <returns>Whether the capabilities include one.</returns>
    public static bool TryGetEncoding(MavProtocolCapability capabilities, out MavlinkParameterEncoding encoding)
    {
        encoding = (capabilities & MavProtocolCapability.ParamEncodeBytewise) != 0
            ? MavlinkParameterEncoding.Bytewise
            : MavlinkParameterEncoding.CCast;
        return (capabilities & (MavProtocolCapability.ParamEncodeBytewise | MavProtocolCapability.ParamEncodeCCast))
            != 0;
    }

    /// <summary>
    /// The encoding by the kind of autopilot, where its capabilities include none: ArduPilot casts, all others keep the
    /// bits.
    /// </summary>
    /// <param name="autopilot">Of its HEARTBEAT.</param>
    /// <returns>The encoding.</returns>
    public static MavlinkParameterEncoding EncodingOf(MavAutopilot autopilot) =>
        autopilot == MavAutopilot.Ardupilotmega ? MavlinkParameterEncoding.CCast : MavlinkParameterEncoding.Bytewise;

    /// <summary>Whether a type can hold a number, rounded where it is an integer type.</summary>
    internal static bool Fits(double value, MavParamType type)
    {
        (double min, double max) = RangeOf(type);
        double whole = Math.Round(value);
        return min == max
            ? !double.IsNaN(value) && Math.Abs(value) <= float.MaxValue
            : whole >= min && whole <= max;
    }

    /// <summary>
    /// Packs a value field; the float of the C-cast encoding holds large integers as nearly as it can.
    /// </summary>
    internal static uint EncodeNearest(double value, MavParamType type, MavlinkParameterEncoding encoding)
    {
        (double min, double max) = RangeOf(type);
        return encoding == MavlinkParameterEncoding.CCast || min == max
            ? FromFloat((float)value)
            : unchecked((uint)(long)Math.Round(value));
    }

    internal static float ToFloat(uint bits) => Unsafe.As<uint, float>(ref bits);

    internal static uint FromFloat(float value) => Unsafe.As<float, uint>(ref value);

    internal static MavlinkParameter From(in ParamValue message) =>
        new(Clean(message.ParamId), message.ParamType, FromFloat(message.Value), message.ParamIndex);

    // What is behind the first zero is no part of the name.
    internal static Text16 Clean(Text16 name)
    {
        for (int i = name.Length; i < name.Capacity; i++)
            name[i] = 0;
        return name;
    }

    private static (double Min, double Max) RangeOf(MavParamType type) => type switch
    {
        MavParamType.Uint8 => (byte.MinValue, byte.MaxValue),
        MavParamType.Int8 => (sbyte.MinValue, sbyte.MaxValue),
        MavParamType.Uint16 => (ushort.MinValue, ushort.MaxValue),
        MavParamType.Int16 => (short.MinValue, short.MaxValue),
        MavParamType.Uint32 => (uint.MinValue, uint.MaxValue),
        MavParamType.Int32 => (int.MinValue, int.MaxValue),
        _ => (0, 0),
    };
}
