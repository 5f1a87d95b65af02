using System;

namespace Rabit.Mavlink;

/// <summary>
/// What every generated message struct can do: name itself and put its fields into a payload and back. Use it as a
/// generic constraint (<c>where T : struct, IMavlinkMessage</c>), never as a variable, so that nothing is boxed.
/// </summary>
public interface IMavlinkMessage
{
    /// <summary>The message id, 0 to 16 777 215; ids above 255 exist in MAVLink 2 only.</summary>
    int MessageId { get; }

    /// <summary>
    /// CRC_EXTRA: the last byte of the checksum, computed from the fields, so that sender and receiver agree on them
    /// (MAVLink guide, "CRC_EXTRA calculation").
    /// </summary>
    byte CrcExtra { get; }

    /// <summary>Payload length in bytes without extension fields: what MAVLink 1 sends.</summary>
    int MinLength { get; }

    /// <summary>
    /// Payload length in bytes with all extension fields: what MAVLink 2 sends before trailing zeros are cut.
    /// </summary>
    int MaxLength { get; }

    /// <summary>Writes all fields, extensions included, in wire order, little endian.</summary>
    /// <param name="payload">At least <see cref="MaxLength"/> bytes; exactly that many are written.</param>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    void Encode(Span<byte> payload);

    /// <summary>Reads all fields, extensions included.</summary>
    /// <param name="payload">
    /// At least <see cref="MaxLength"/> bytes, with zeros where the sender truncated the payload or its definition
    /// lacks a field.
    /// </param>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    void Decode(ReadOnlySpan<byte> payload);
}
