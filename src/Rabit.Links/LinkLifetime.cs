using System;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// What every link keeps beside its device: its name, whether and why it has ended, whether it was disposed, and its
/// counters. Any thread; each field is changed by an interlocked operation and never changes back.
/// </summary>
internal sealed class LinkLifetime(string url, int openings = 1)
{
    public const string UnblockedReason = "it was closed on this side";

    private string? _endReason;
    private int _disposed;
    private long _bytesRead;
    private long _bytesWritten;
    private long _bytesDropped;
    private long _writesDropped;
    private long _transientFaults;
    private long _peersForgotten;
    private long _peersDisplaced;

    public string Url { get; } = url;

    /// <summary>Why the link has ended; null while it has not. The first reason given stays.</summary>
    public string? EndReason => Volatile.Read(ref _endReason);

    public LinkCounters Counters => new(
        Interlocked.Read(ref _bytesRead),
        Interlocked.Read(ref _bytesWritten),
        Interlocked.Read(ref _bytesDropped),
        Interlocked.Read(ref _writesDropped),
        Interlocked.Read(ref _transientFaults),
        openings,
        Interlocked.Read(ref _peersForgotten),
        Interlocked.Read(ref _peersDisplaced));

    public ByteLinkState State => EndReason is null ? ByteLinkState.Open : ByteLinkState.Closed;

    /// <summary>What went wrong; that this side closed it is no fault.</summary>
    public string? LastFault => EndReason is { } reason && reason != UnblockedReason ? reason : null;

    /// <summary>Ends the link. True for the one call that did.</summary>
    public bool TryEnd(string reason) => Interlocked.CompareExchange(ref _endReason, reason, null) is null;

    /// <summary>Marks the link as disposed. True for the one call that did.</summary>
    public bool TryDispose() => Interlocked.Exchange(ref _disposed, 1) == 0;

    /// <summary>Counts bytes that a read hands out.</summary>
    public LinkRead Arrived(int count, int peer = 0)
    {
        Interlocked.Add(ref _bytesRead, count);
        return LinkRead.Bytes(count, peer);
    }

    public void Sent(int count) => Interlocked.Add(ref _bytesWritten, count);

    public void Dropped(int count)
    {
        Interlocked.Add(ref _bytesDropped, count);
        Interlocked.Increment(ref _writesDropped);
    }

    public void PeerForgotten() => Interlocked.Increment(ref _peersForgotten);

    public void PeerDisplaced() => Interlocked.Increment(ref _peersDisplaced);

    public void TransientFault() => Interlocked.Increment(ref _transientFaults);

    /// <summary>Checks what is wrong with a call of Read whatever the link.</summary>
    public void CheckRead(byte[] buffer, int timeoutMilliseconds)
    {
        ThrowIfDisposed();
        if (timeoutMilliseconds is < 1 and not Timeout.Infinite) ThrowBadTimeout(timeoutMilliseconds);
        if (buffer is null) ThrowNoBuffer(nameof(buffer));
        if (buffer!.Length == 0) ThrowEmptyBuffer(nameof(buffer));
    }

    /// <summary>Checks what is wrong with a call of Write whatever the link. False if there is nothing to do.</summary>
    /// <exception cref="LinkException">The link has ended; the bytes are counted as dropped.</exception>
    public bool CheckWrite(byte[] buffer, int offset, int count)
    {
        ThrowIfDisposed();
        if (buffer is null) ThrowNoBuffer(nameof(buffer));
        if ((uint)offset > (uint)buffer!.Length || (uint)count > (uint)(buffer.Length - offset))
            ThrowBadRange(offset, count, buffer.Length);
        if (count == 0) return false;
        if (EndReason is not null) throw DroppedByEnd(count);
        return true;
    }

    /// <summary>Whether Write would have something to do; wrong arguments and a link that has ended are left to it.
    /// </summary>
    public bool IsWritable(byte[] buffer, int offset, int count)
        => buffer is not null && (uint)offset <= (uint)buffer.Length && (uint)count <= (uint)(buffer.Length - offset)
            && count > 0 && EndReason is null && Volatile.Read(ref _disposed) == 0;

    /// <summary>Counts bytes that cannot go out because the link has ended, and makes the error to throw.</summary>
    public LinkException DroppedByEnd(int count)
    {
        Dropped(count);
        return new LinkException(Url, $"cannot write: {EndReason}", linkEnded: true);
    }

    private void ThrowIfDisposed()
    {
        if (Volatile.Read(ref _disposed) != 0) ThrowDisposed();
    }

    private void ThrowDisposed() => throw new ObjectDisposedException(Url, $"link {Url} was disposed");

    private void ThrowNoBuffer(string parameter)
        => throw new ArgumentNullException(parameter, $"link {Url}: a buffer is needed");

    private void ThrowEmptyBuffer(string parameter)
        => throw new ArgumentException($"link {Url}: cannot read into an empty buffer", parameter);

    private void ThrowBadTimeout(int milliseconds) => throw new ArgumentOutOfRangeException(
        nameof(milliseconds), milliseconds, $"link {Url}: a time-out is at least 1 ms, or Timeout.Infinite");

    private void ThrowBadRange(int offset, int count, int length) => throw new ArgumentOutOfRangeException(
        nameof(count), $"link {Url}: offset {offset} and count {count} do not lie in a buffer of {length} bytes");
}
