namespace Rabit.Mavlink;

/// <summary>
/// The description of a message that a receiver needs to check and route it. A plain value, immutable.
/// </summary>
public readonly struct MavlinkMessageInfo
{
    /// <summary>Describes one message of a dialect.</summary>
    /// <param name="id">Message id, 0 to 16 777 215.</param>
    /// <param name="name">Name as the definition writes it, for example <c>COMMAND_LONG</c>.</param>
    /// <param name="crcExtra">CRC_EXTRA; see <see cref="IMavlinkMessage.CrcExtra"/>.</param>
    /// <param name="minLength">Payload bytes without extension fields.</param>
    /// <param name="maxLength">Payload bytes with extension fields.</param>
    /// <param name="targetSystemOffset">
    /// Payload offset of <c>target_system</c>, or -1 where the message has none.
    /// </param>
    /// <param name="targetComponentOffset">
    /// Payload offset of <c>target_component</c>, or -1 where the message has none.
    /// </param>
    public MavlinkMessageInfo(
        int id, string name, byte crcExtra, byte minLength, byte maxLength, short targetSystemOffset,
        short targetComponentOffset)
    {
        Id = id;
        Name = name;
        CrcExtra = crcExtra;
        MinLength = minLength;
        MaxLength = maxLength;
        TargetSystemOffset = targetSystemOffset;
        TargetComponentOffset = targetComponentOffset;
    }

    /// <summary>Message id, 0 to 16 777 215.</summary>
    public int Id { get; }

    /// <summary>Name as the definition writes it, for example <c>COMMAND_LONG</c>.</summary>
    public string Name { get; }

    /// <summary>CRC_EXTRA, the last byte of the checksum; see <see cref="IMavlinkMessage.CrcExtra"/>.</summary>
    public byte CrcExtra { get; }

    /// <summary>Payload bytes without extension fields.</summary>
    public byte MinLength { get; }

    /// <summary>Payload bytes with extension fields.</summary>
    public byte MaxLength { get; }

    /// <summary>
    /// Payload offset of the <c>target_system</c> byte, or -1 where the message is a broadcast by its definition.
    /// </summary>
    public short TargetSystemOffset { get; }

    /// <summary>Payload offset of the <c>target_component</c> byte, or -1 where the message has none.</summary>
    public short TargetComponentOffset { get; }
}
