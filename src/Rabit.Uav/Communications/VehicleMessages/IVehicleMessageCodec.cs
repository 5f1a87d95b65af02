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
    /// Says on the wire what the bytes are: the payload type of TUNNEL, 32768 to 65535, which are free for private use.
    /// </summary>
    int PayloadType { get; }

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
    /// <param name="payload">The bytes, from any sender.</param>
    /// <param name="now">When they came in, by the clock of the run.</param>
    /// <param name="sourceSystemId">The system that sent them; a sender in the bytes is ignored.</param>
    /// <param name="content">The message.</param>
    /// <returns>False where the bytes are no such message.</returns>
    bool TryDecode(ReadOnlySpan<byte> payload, TimeSpan now, byte sourceSystemId, out T content);

    /// <summary>
    /// A number that two messages of one sender share only if they are the same message, which came twice.
    /// </summary>
    /// <param name="content">The message.</param>
    long IdentityOf(in T content);
}
