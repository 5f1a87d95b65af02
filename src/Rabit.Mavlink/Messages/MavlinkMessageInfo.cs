namespace Rabit.Mavlink;

/// <summary>What a receiver must know of a message before it can check or route it. A plain value, immutable.</summary>
public readonly struct MavlinkMessageInfo
{
    /// <summary>Describes one message of a dialect.</summary>
    /// <param name="id">Message id, 0 to 16 777 215.</param>
    /// <param name="name">Name as the definition writes it, for example <c>COMMAND_LONG</c>.</param>
    /// <param name="crcExtra">See <see cref="IMavlinkMessage.CrcExtra"/>.</param>
    /// <param name="minimumLength">Payload bytes without extension fields.</param>
    /// <param name="maximumLength">Payload bytes with extension fields.</param>
    /// <param name="targetSystemOffset">Payload offset of <c>target_system</c>, or -1 where the message has none.</param>
    /// <param name="targetComponentOffset">Payload offset of <c>target_component</c>, or -1 where the message has none.</param>
    public MavlinkMessageInfo(
        int id, string name, byte crcExtra, byte minimumLength, byte maximumLength, short targetSystemOffset, short targetComponentOffset)
    {
        Id = id;
        Name = name;
        CrcExtra = crcExtra;
        MinimumLength = minimumLength;
        MaximumLength = maximumLength;
        TargetSystemOffset = targetSystemOffset;
        TargetComponentOffset = targetComponentOffset;
    }

    /// <summary>Message id, 0 to 16 777 215.</summary>
    public int Id { get; }

    /// <summary>Name as the definition writes it, for example <c>COMMAND_LONG</c>.</summary>
    public string Name { get; }

    /// <summary>See <see cref="IMavlinkMessage.CrcExtra"/>.</summary>
    public byte CrcExtra { get; }

    /// <summary>Payload bytes without extension fields.</summary>
    public byte MinimumLength { get; }

    /// <summary>Payload bytes with extension fields.</summary>
    public byte MaximumLength { get; }

    /// <summary>Payload offset of the <c>target_system</c> byte, or -1 where the message is a broadcast by its definition.</summary>
    public short TargetSystemOffset { get; }

    /// <summary>Payload offset of the <c>target_component</c> byte, or -1 where the message has none.</summary>
    public short TargetComponentOffset { get; }
}
