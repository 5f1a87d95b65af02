namespace Rabit.Mavlink.Generator.Reading;

/// <summary>
/// What can be wrong with definitions. The number is that of the compiler diagnostic (RABMAV001 and so on) and never
/// changes.
/// </summary>
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

    /// <summary>
    /// An element or attribute is nearly called like one of the schema, or an element stands in the wrong place.
    /// </summary>
    MisspeltName = 12,

    /// <summary>An element or attribute that the schema does not have; a warning, since a newer schema may.</summary>
    UnknownName = 13,

    /// <summary>Two entries of an enum have one value.</summary>
    DuplicateEnumValue = 14,

    /// <summary>
    /// A command has a number that the package's MAV_CMD gives to another one; a warning, since the dialect does not
    /// include it.
    /// </summary>
    CommandOfPackage = 15,

    /// <summary>The value of an enum entry fits none of the fields that are of its enum.</summary>
    ValueFitsNoField = 16,

    /// <summary>A field cannot carry all entries of its enum; a warning, since it may never have to.</summary>
    FieldTooNarrow = 17,

    /// <summary>A floating-point field names an enum; a warning, since it only stays without the type.</summary>
    EnumOfFloat = 18,

    /// <summary>A message has no field.</summary>
    NoFields = 19,

    /// <summary>A message has more than the 64 fields that MAVLink's own libraries can describe.</summary>
    TooManyFields = 20,

    /// <summary>An entry of a bit mask combines bits that no entry names; a warning.</summary>
    UnnamedBits = 21,
}
