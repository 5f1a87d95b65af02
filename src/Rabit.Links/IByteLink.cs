using System;

namespace Rabit.Links;

/// <summary>
/// A way for bytes to and from the outside: a socket, a serial line, a piece of memory. It knows nothing of what the
/// bytes mean and has no thread of its own: one thread may read while another writes, and any thread may ask for the
/// counters, unblock or dispose it.
/// </summary>
/// <remarks>
/// A link is opened by its class or by <see cref="LinkFactory"/>, which throw a <see cref="LinkException"/> when that
/// fails. What goes wrong later and passes (a peer that is not up yet) is counted; what does not pass ends the link.
/// <see cref="ReopeningLink"/> opens such a link again and again, and ends only at a stop.
/// </remarks>
/// <example>
/// Two ends in memory; every other link is used alike.
/// <code>
/// var pair = new MemoryLinkPair("bench");
/// pair.A.Write(bytes, 0, bytes.Length);
/// LinkRead read = pair.B.Read(buffer);
/// if (read.Kind == LinkReadKind.Bytes) Use(buffer, read.Count);
/// </code>
/// </example>
public interface IByteLink : IDisposable
{
    /// <summary>
    /// What the link is, in the form of <see cref="LinkUrl"/> where there is one; the same in every error it reports.
    /// </summary>
    string Url { get; }

    /// <summary>
    /// Whether <see cref="Read"/> waits for bytes. If false it returns at once, and <see cref="SetReadableCallback"/>
    /// says when to read again.
    /// </summary>
    bool Blocks { get; }

    /// <summary>
    /// What has gone through so far, and what was lost. From any thread, also after the link ended or was disposed.
    /// </summary>
    LinkCounters Counters { get; }

    /// <summary>Where the link is in its life. From any thread.</summary>
    ByteLinkState State { get; }

    /// <summary>
    /// What went wrong last, one line without the URL; null while nothing did. It stays when the link has recovered.
    /// From any thread.
    /// </summary>
    string? LastFault { get; }

    /// <summary>
    /// Fills <paramref name="buffer"/> from its start with bytes that have arrived, in their order. One thread at a
    /// time. A link that blocks waits for at least one byte, the end of the link, the time-out,
    /// <see cref="Unblock"/> or <see cref="IDisposable.Dispose"/>. Nothing is lost if the buffer is smaller than what
    /// has arrived: the rest comes with the next read.
    /// </summary>
    /// <param name="buffer">Where the bytes go; not empty. The link does not keep it.</param>
    /// <param name="timeoutMilliseconds">
    /// After what time without a byte a link that blocks says <see cref="LinkReadKind.NothingYet"/>; at least 1, or
    /// <see cref="System.Threading.Timeout.Infinite"/>.
    /// </param>
    /// <returns>How many bytes came, or that there are none yet, or that none will ever come and why.</returns>
    /// <exception cref="LinkException">The link broke. Every later read says that it has ended.</exception>
    /// <exception cref="ObjectDisposedException">The link was disposed before the call.</exception>
    LinkRead Read(byte[] buffer, int timeoutMilliseconds = System.Threading.Timeout.Infinite);

    /// <summary>
    /// Sends bytes. From any thread; the bytes of one call stay together. Waits at most the write time-out of the link
    /// when the way out is full. Bytes that the link itself did not send are counted as dropped, whether it throws or,
    /// where its class says so, goes on.
    /// </summary>
    /// <param name="buffer">Holds the bytes; may be used again after the call.</param>
    /// <param name="offset">Index of the first byte.</param>
    /// <param name="count">How many; 0 does nothing.</param>
    /// <exception cref="LinkException">
    /// They, or the rest of them, could not be sent. <see cref="LinkException.LinkEnded"/> says whether a later write
    /// may succeed.
    /// </exception>
    /// <exception cref="ObjectDisposedException">The link was disposed before the call.</exception>
    void Write(byte[] buffer, int offset, int count);

    /// <summary>
    /// Ends a blocked <see cref="Read"/> and <see cref="Write"/> within milliseconds and the link for good: reading
    /// says that it has ended, writing throws. For shutting down, from any thread, any number of times, also after
    /// Dispose.
    /// </summary>
    void Unblock();

    /// <summary>
    /// Sets what a link that does not block calls when there is something to read again: bytes, or its end. Called on
    /// the thread that wrote, unblocked or disposed, with no lock held; it may be called when nothing is left to read.
    /// Set it before the first read. A link that blocks never calls it.
    /// </summary>
    /// <param name="callback">What to call, short and without throwing; null for nothing.</param>
    void SetReadableCallback(Action? callback);
}
