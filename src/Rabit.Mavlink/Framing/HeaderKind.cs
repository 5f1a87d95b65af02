namespace Rabit.Mavlink.Framing;

/// <summary>What the header alone shows of a possible frame.</summary>
internal enum HeaderKind
{
    /// <summary>No frame begins here.</summary>
    NotAFrame,

    /// <summary>A start byte; the rest of the header has not arrived.</summary>
    Incomplete,

    /// <summary>The id is known: the checksum can be checked, with its CRC_EXTRA.</summary>
    KnownMessage,

    /// <summary>The id is unknown, so that the checksum cannot be checked.</summary>
    UnknownMessage,
}
