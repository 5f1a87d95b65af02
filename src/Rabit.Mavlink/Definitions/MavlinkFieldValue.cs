using System;
using System.Runtime.CompilerServices;
using System.Text;
using Rabit.Mavlink.Definitions;

namespace Rabit.Mavlink;

/// <summary>
/// One element of a field as it is in a frame: a number of the field's type, bit for bit. A plain value; nothing is
/// boxed.
/// </summary>
public readonly struct MavlinkFieldValue : IEquatable<MavlinkFieldValue>
{
    // Integers sign-extended, floating point as its bits.
    private readonly ulong _bits;

    internal MavlinkFieldValue(MavlinkFieldType type, ulong bits)
    {
        Type = type;
        _bits = bits;
    }

    /// <summary>What it is on the wire.</summary>
    public MavlinkFieldType Type { get; }

    /// <summary>Whether it is <see cref="MavlinkFieldType.Single"/> or <see cref="MavlinkFieldType.Double"/>.</summary>
    public bool IsFloatingPoint => Type is MavlinkFieldType.Single or MavlinkFieldType.Double;

    /// <summary>Whether all bits and the type are equal.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    /// <returns>Whether they are.</returns>
    public static bool operator ==(MavlinkFieldValue left, MavlinkFieldValue right) => left.Equals(right);

    /// <summary>Whether any bit or the type differs.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    /// <returns>Whether they do.</returns>
    public static bool operator !=(MavlinkFieldValue left, MavlinkFieldValue right) => !left.Equals(right);

    /// <summary>
    /// The integer. An <c>uint64_t</c> keeps its bits, so one above <see cref="long.MaxValue"/> is negative here.
    /// </summary>
    /// <returns>The integer.</returns>
    /// <exception cref="InvalidOperationException">It is floating point.</exception>
    public long ToInt64() => IsFloatingPoint ? throw NotAnInteger() : unchecked((long)_bits);

    /// <summary>The integer; a negative one keeps its bits.</summary>
    /// <returns>The integer.</returns>
    /// <exception cref="InvalidOperationException">It is floating point.</exception>
    public ulong ToUInt64() => IsFloatingPoint ? throw NotAnInteger() : _bits;

    /// <summary>The number, whatever its type. Above 2^53 an integer is rounded.</summary>
    /// <returns>The number.</returns>
    public double ToDouble() => Type switch
    {
        MavlinkFieldType.Single => Single,
        MavlinkFieldType.Double => Double,
        MavlinkFieldType.UInt64 => _bits,
        _ => unchecked((long)_bits),
    };

    /// <summary>
    /// Writes the number: shortest text that is read back as the same one, with a point, whatever the culture.
    /// </summary>
    /// <param name="text">Where to write.</param>
    public void AppendTo(StringBuilder text)
    {
        if (text is null)
            throw new ArgumentNullException(nameof(text));
        if (Type == MavlinkFieldType.Single)
            NumberFormat.Append(text, Single);
        else if (Type == MavlinkFieldType.Double)
            NumberFormat.Append(text, Double);
        else if (Type == MavlinkFieldType.UInt64)
            NumberFormat.Append(text, _bits);
        else
            NumberFormat.Append(text, unchecked((long)_bits));
    }

    /// <inheritdoc/>
    public bool Equals(MavlinkFieldValue other) => Type == other.Type && _bits == other._bits;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is MavlinkFieldValue other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked(_bits.GetHashCode() + (int)Type);

    /// <summary>The number as text, as <see cref="AppendTo"/> writes it.</summary>
    /// <returns>A new string.</returns>
    public override string ToString()
    {
        var text = new StringBuilder();
        AppendTo(text);
        return text.ToString();
    }

    private float Single
    {
        get
        {
            uint bits = unchecked((uint)_bits);
            return Unsafe.As<uint, float>(ref bits);
        }
    }

    private double Double
    {
        get
        {
            ulong bits = _bits;
            return Unsafe.As<ulong, double>(ref bits);
        }
    }

    private InvalidOperationException NotAnInteger() => new($"A {Type} is no integer; use ToDouble.");
}
