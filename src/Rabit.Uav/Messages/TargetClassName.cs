using System;

namespace Rabit.Uav.Messages;

/// <summary>
/// The name of a class of targets, such as "red" or "person": 1 to 16 printable ASCII characters, upper and lower case
/// distinct. The user declares the classes; one that only another vehicle knows keeps its name. A plain value of 16
/// bytes; copies and compares without allocation.
/// </summary>
public readonly struct TargetClassName : IEquatable<TargetClassName>
{
    /// <summary>Characters that a name has at most: as many as travel between vehicles.</summary>
    public const int MaxLength = 16;

    // The characters, the first in the lowest byte of _low; zeros follow the last.
    private readonly ulong _low;
    private readonly ulong _high;

    /// <summary>Makes a name.</summary>
    /// <param name="name">1 to 16 printable ASCII characters, the first and the last no space.</param>
    /// <exception cref="ArgumentException">It is none of that kind; the text says so.</exception>
    public TargetClassName(string name)
    {
        if (name is null)
            throw new ArgumentNullException(nameof(name));
        if (!TryParse(name, out this))
            throw new ArgumentException($"The name of a target class is \"{name}\"; it must be {Rule}.", nameof(name));
    }

    private TargetClassName(ulong low, ulong high) => (_low, _high) = (low, high);

    /// <summary>No class: the default value.</summary>
    public static TargetClassName None => default;

    /// <summary>Whether it is the default value, which names no class.</summary>
    public bool IsNone => _low == 0;

    /// <summary>Number of characters; 0 for <see cref="None"/>.</summary>
    public int Length
    {
        get
        {
            int length = 0;
            while (length < MaxLength && ByteAt(length) != 0)
                length++;
            return length;
        }
    }

    internal static string Rule => "1 to 16 printable ASCII characters, the first and the last no space";

    /// <summary>Whether two names are the same.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator ==(TargetClassName left, TargetClassName right) => left.Equals(right);

    /// <summary>Whether two names differ.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator !=(TargetClassName left, TargetClassName right) => !left.Equals(right);

    /// <summary>Makes a name of a text, if it can be one.</summary>
    /// <param name="text">
    /// 1 to 16 printable ASCII characters, the first and the last no space; anything else is refused.
    /// </param>
    /// <param name="name">The name; <see cref="None"/> if the answer is false.</param>
    public static bool TryParse(string? text, out TargetClassName name)
    {
        Span<byte> ascii = stackalloc byte[MaxLength];
        name = default;
        if (text is null || text.Length > MaxLength)
            return false;
        for (int i = 0; i < text.Length; i++)
        {
            if (text[i] > '~')
                return false;
            ascii[i] = (byte)text[i];
        }

        return TryRead(ascii.Slice(0, text.Length), out name);
    }

    /// <summary>Makes a name of the bytes that came from elsewhere, if they can be one. Allocates nothing.</summary>
    /// <param name="ascii">
    /// 1 to 16 printable ASCII characters, the first and the last no space, without padding.
    /// </param>
    /// <param name="name">The name; <see cref="None"/> if the answer is false.</param>
    public static bool TryRead(ReadOnlySpan<byte> ascii, out TargetClassName name)
    {
        name = default;
        if (ascii.Length is 0 or > MaxLength || ascii[0] == ' ' || ascii[ascii.Length - 1] == ' ')
            return false;
        (ulong low, ulong high) = (0, 0);
        for (int i = 0; i < ascii.Length; i++)
        {
            if (ascii[i] is < (byte)' ' or > (byte)'~')
                return false;
            if (i < sizeof(ulong))
                low |= (ulong)ascii[i] << (8 * i);
            else
                high |= (ulong)ascii[i] << (8 * (i - sizeof(ulong)));
        }

        name = new TargetClassName(low, high);
        return true;
    }

    /// <summary>Writes its characters, without padding, and says how many they are. Allocates nothing.</summary>
    /// <param name="destination">At least <see cref="Length"/> bytes.</param>
    /// <exception cref="ArgumentException">There is no room.</exception>
    public int CopyTo(Span<byte> destination)
    {
        int length = Length;
        if (destination.Length < length)
            throw new ArgumentException(
                $"There are {destination.Length} bytes for {length} characters.", nameof(destination));
        for (int i = 0; i < length; i++)
            destination[i] = ByteAt(i);
        return length;
    }

    /// <inheritdoc/>
    public bool Equals(TargetClassName other) => _low == other._low && _high == other._high;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is TargetClassName other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked((_low.GetHashCode() * 397) ^ _high.GetHashCode());

    /// <summary>The name; empty for <see cref="None"/>. Allocates.</summary>
    public override string ToString()
    {
        var characters = new char[Length];
        for (int i = 0; i < characters.Length; i++)
            characters[i] = (char)ByteAt(i);
        return new string(characters);
    }

    private byte ByteAt(int index)
        => (byte)(index < sizeof(ulong) ? _low >> (8 * index) : _high >> (8 * (index - sizeof(ulong))));
}
