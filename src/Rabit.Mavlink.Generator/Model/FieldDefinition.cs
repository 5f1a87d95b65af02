namespace Rabit.Mavlink.Generator.Model;

/// <summary>
/// One field of a message, as defined. What is not given is null; texts are as the definition writes them.
/// </summary>
/// <param name="Name">Name in the definition.</param>
/// <param name="Type">Type of one element.</param>
/// <param name="ArrayLength">Elements of an array, 0 for a single value.</param>
/// <param name="IsExtension">
/// Whether it came after MAVLink 1 and is therefore outside the checksum byte and the wire order.
/// </param>
public sealed record FieldDefinition(string Name, WireType Type, int ArrayLength, bool IsExtension)
{
    /// <summary>Name of the enum that its values are of.</summary>
    public string? Enum { get; init; }

    /// <summary>Unit, for example <c>degE7</c>.</summary>
    public string? Units { get; init; }

    /// <summary>The value that means "not known", for example <c>UINT16_MAX</c>, or <c>[NaN:]</c> for arrays.</summary>
    public string? Invalid { get; init; }

    /// <summary>What one count stands for, in <see cref="Units"/>, for example <c>1E-2</c>.</summary>
    public string? Multiplier { get; init; }

    /// <summary>Smallest allowed value.</summary>
    public string? MinValue { get; init; }

    /// <summary>Largest allowed value.</summary>
    public string? MaxValue { get; init; }

    /// <summary>Whether it distinguishes several instances of one message.</summary>
    public bool IsInstance { get; init; }

    /// <summary>The definition's own words.</summary>
    public string? Description { get; init; }

    /// <summary>Bytes on the wire.</summary>
    public int WireLength => Type.Size * (ArrayLength == 0 ? 1 : ArrayLength);

    /// <summary>Whether it is an array of characters.</summary>
    public bool IsText => ArrayLength != 0 && Type.IsCharacter;
}
