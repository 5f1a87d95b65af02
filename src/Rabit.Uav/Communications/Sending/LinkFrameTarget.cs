using System;
using System.Threading;
using Rabit.Core;
using Rabit.Links;

namespace Rabit.Uav.Communications;

/// <summary>
/// Writes frames to a link, those that belong together in one write. Counts what a link loses. Allocates nothing for a
/// frame. Used by one writer, whose thread calls it.
/// </summary>
internal sealed class LinkFrameTarget(IByteLink link) : IWriterTarget<FrameToWrite>
{
    /// <summary>What fits into one datagram on every net that has no tunnels (Ethernet has 1472).</summary>
    public const int MaxWriteBytes = 1400;

    private readonly byte[] _buffer = new byte[MaxWriteBytes];
    private int _length;
    private int _frames;
    private long _lost;
    private long _done;   // the writer's thread writes, any reads

    public bool Blocks => link.Blocks;

    /// <summary>Frames that the link could not take. Any thread.</summary>
    public long Lost => Interlocked.Read(ref _lost);

    /// <summary>Frames that it is through with, lost ones too. Any thread.</summary>
    public long Done => Interlocked.Read(ref _done);

    public void Open()
    {
    }

    // What begins a write may be dropped while it waits; its end never is before it.
    public void Write(in FrameToWrite value)
    {
        try
        {
            if (_length + value.Frame.WireLength > MaxWriteBytes)
                WriteAll();
            _length += value.Frame.WriteTo(_buffer.AsSpan(_length));
            _frames++;
            if (!value.HasMore)
                WriteAll();
        }
        finally
        {
            Interlocked.Increment(ref _done);
        }
    }

    public void Unblock() => link.Unblock();

    public void Close()
    {
    }

    private void WriteAll()
    {
        (int length, int frames) = (_length, _frames);
        (_length, _frames) = (0, 0);
        bool isWritten = false;
        try
        {
            isWritten = TryWrite(length);
        }
        finally
        {
            if (!isWritten)
                Interlocked.Add(ref _lost, frames);
        }
    }

    // Some links say by their counter alone that a write was lost.
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
