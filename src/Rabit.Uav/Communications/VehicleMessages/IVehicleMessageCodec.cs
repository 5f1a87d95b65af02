using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// Turns one type of message into bytes for other vehicles, and back. Called on the thread of Communications; must not
/// throw, whatever the bytes are.
/// </summary>
/// <typeparam name="T">A plain value.</typeparam>
public interface IVehicleMessageCodec<T>
    where T : struct
{
    /// <summary>
    /// Says on the wire what the bytes are, 0 to 65535: below 1000 it is Rabit's, above it yours.
    /// </summary>
    int MessageType { get; }

    /// <summary>
    /// Of the form of the bytes, 0 to 255. Older ones are given to <see cref="TryDecode"/>; newer ones of other
    /// vehicles are counted and ignored.
    /// </summary>
    int Version { get; }

    /// <summary>Writes a message.</summary>
    /// <param name="content">The message.</param>
    /// <param name="now">
    /// The time, by the clock of the run: clocks of vehicles differ, so that times travel as ages.
    /// </param>
    /// <param name="destination">Where to: <see cref="VehicleMessageRoute.MaxLength"/> bytes.</param>
    /// <param name="length">How many bytes were written.</param>
    /// <returns>False where the message does not fit into the form.</returns>
    bool TryEncode(in T content, TimeSpan now, Span<byte> destination, out int length);

    /// <summary>Reads a message, strictly: anything that cannot be is refused as a whole.</summary>
    /// <param name="bytes">The bytes, from any sender.</param>
    /// <param name="version">The version of their form: not newer than <see cref="Version"/>.</param>
    /// <param name="sentTime">
    /// When it was written, by the clock of the run here; see <see cref="Messages.Envelope{T}.SentTime"/>.
    /// </param>
    /// <param name="sourceSystemId">The system that sent them; a sender in the bytes is ignored.</param>
    /// <param name="content">The message.</param>
    /// <returns>False where the bytes are no such message.</returns>
    bool TryDecode(ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out T content);
}
