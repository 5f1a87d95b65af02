namespace Rabit.Mavlink;

/// <summary>
/// The two wire formats (MAVLink guide, "Packet serialization"). The value is the number in the format's name.
/// </summary>
public enum MavlinkVersion
{
    /// <summary>No frame: the version of <c>default(MavlinkFrame)</c>.</summary>
    None = 0,

    /// <summary>
    /// MAVLink 1: starts with 0xFE, ids up to 255, no extension fields, no signature, payload never truncated.
    /// </summary>
    V1 = 1,

    /// <summary>MAVLink 2: starts with 0xFD, 24-bit ids, extension fields, trailing zeros cut, may be signed.</summary>
    V2 = 2,
}
