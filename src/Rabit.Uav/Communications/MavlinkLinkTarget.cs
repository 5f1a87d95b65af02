using System;
using System.Threading;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// Writes MAVLink frames to a live link: the target of a manager's writer. A frame that a link loses, also the one by
/// which it ends, is counted. Allocates nothing per frame. Used by one writer, whose thread calls it.
/// </summary>
/// <param name="link">Open; it stays the caller's to dispose.</param>
/// <exception cref="ArgumentNullException">No link.</exception>
/// <example>
/// In the constructor of a manager, and in its unit of work:
/// <code>
/// _writer = AttachWriter("radio out", new MavlinkLinkTarget(link), 256, QueueFullMode.DropOldest);
/// </code>
/// <code>
/// _ = _writer.Push(mavlink.Create(message));   // a MavlinkSender, which numbers the frames; full: by its rule
/// </code>
/// </example>
public sealed class MavlinkLinkTarget(IByteLink link) : IWriterTarget<MavlinkFrame>
{
    private readonly IByteLink _link = link ?? throw new ArgumentNullException(nameof(link));
    private readonly byte[] _buffer = new byte[MavlinkFrame.MaxWireLength];
    private long _lost;

    /// <inheritdoc/>
    public bool Blocks => _link.Blocks;

    /// <summary>Frames that the link could not take. Any thread.</summary>
    public long Lost => Interlocked.Read(ref _lost);

    /// <inheritdoc/>
    public void Open()
    {
    }

    /// <inheritdoc/>
    /// <exception cref="LinkException">The link has ended.</exception>
    public void Write(in MavlinkFrame value)
    {
        int length = value.WriteTo(_buffer);
        bool isWritten = false;
        try
        {
            isWritten = TryWrite(length);
        }
        finally
        {
            if (!isWritten)
                Interlocked.Increment(ref _lost);
        }
    }

    /// <inheritdoc/>
    public void Unblock() => _link.Unblock();

    /// <inheritdoc/>
    public void Close()
    {
    }

    /// <returns>
    /// False where this frame is lost but the next one may get through. Some links say so by their counter alone.
    /// </returns>
    private bool TryWrite(int length)
    {
        long dropped = _link.Counters.WritesDropped;
        try
        {
            _link.Write(_buffer, 0, length);
        }
        catch (LinkException e) when (!e.LinkEnded)
        {
            return false;
        }

        return _link.Counters.WritesDropped == dropped;
    }
}
