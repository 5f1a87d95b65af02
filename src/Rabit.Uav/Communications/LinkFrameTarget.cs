using System.Threading;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Links;

namespace Rabit.Uav.Communications;

/// <summary>Writes frames to a live link. Runs on the writer's thread.</summary>
internal sealed class LinkFrameTarget(IByteLink link) : IWriterTarget<MavlinkFrame>
{
    private readonly byte[] _buffer = new byte[MavlinkFrame.MaxWireLength];
    private long _lost;

    public bool Blocks => link.Blocks;

    /// <summary>Frames that the link could not take. Any thread.</summary>
    public long Lost => Interlocked.Read(ref _lost);

    public void Open()
    {
    }

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

    public void Unblock() => link.Unblock();

    public void Close()
    {
    }

    /// <returns>False where this frame is lost but the next one may get through. Some links say so by their counter alone.</returns>
    private bool TryWrite(int length)
    {
        long dropped = link.Counters.WritesDropped;
        try
        {
            link.Write(_buffer, 0, length);
        }
        catch (LinkException e) when (!e.LinkEnded)
        {
            return false;
        }

        return link.Counters.WritesDropped == dropped;
    }
}
