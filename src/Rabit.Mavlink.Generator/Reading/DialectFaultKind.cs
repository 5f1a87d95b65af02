namespace Rabit.Mavlink.Generator.Reading;

/// <summary>What can be wrong with definitions. The number is that of the compiler diagnostic (RABMAV001 and so on) and never changes.</summary>
public enum DialectFaultKind
{
    /// <summary>Not XML, not a MAVLink definition, or a required attribute is missing or no name.</summary>
    Malformed = 1,

    /// <summary>Something that must be a number is none, or is out of range.</summary>
    MalformedNumber = 2,

    /// <summary>An included file was not among the given ones.</summary>
    MissingInclude = 3,

    /// <summary>A file includes itself, directly or through others.</summary>
    IncludeCycle = 4,

    /// <summary>Two messages have one id.</summary>
    DuplicateMessageId = 5,

    /// <summary>Two messages have one name.</summary>
    DuplicateMessageName = 6,

    /// <summary>Two fields of a message have one name.</summary>
    DuplicateField = 7,

    /// <summary>A field is of a type that MAVLink does not have.</summary>
    UnknownType = 8,

    /// <summary>A payload is longer than the 255 bytes that a frame holds.</summary>
    PayloadTooLong = 9,

    /// <summary>An enum entry is defined twice with different values.</summary>
    ConflictingEnumValue = 10,

    /// <summary>A field names an enum that no file defines.</summary>
    UnknownEnum = 11,
}
