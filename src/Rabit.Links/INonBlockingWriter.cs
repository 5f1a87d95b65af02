namespace Rabit.Links;

/// <summary>
/// A link that may be able to write without a wait: what a thread that must not wait asks before it leaves the bytes to
/// one that may. Those of UDP are; what <see cref="ReopeningLink"/> opened says so for itself.
/// </summary>
/// <example>
/// <code>
/// using ReopeningLink link = ReopeningLink.Open(LinkUrl.Parse("udpout:127.0.0.1:14550"));
/// byte[] heartbeat = [0xFD, 9, 0, 0];   // a whole frame in truth
/// if (!link.TryWrite(heartbeat, 0, heartbeat.Length))
///     link.Write(heartbeat, 0, heartbeat.Length);   // may wait: the work of a thread that may
/// </code>
/// </example>
public interface INonBlockingWriter
{
    /// <summary>
    /// Sends bytes if that takes no wait. From any thread; never throws and never waits for the device.
    /// </summary>
    /// <param name="buffer">Holds the bytes; may be used again after the call.</param>
    /// <param name="offset">Index of the first byte.</param>
    /// <param name="count">How many.</param>
    /// <returns>
    /// True where they are sent and counted. False where they are neither: <see cref="IByteLink.Write"/> waits, or says
    /// what is wrong.
    /// </returns>
    bool TryWrite(byte[] buffer, int offset, int count);
}
