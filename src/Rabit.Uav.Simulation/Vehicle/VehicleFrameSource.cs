using System;
using System.Threading;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Links;

namespace Rabit.Uav.Simulation;

/// <summary>Makes frames of the bytes that come over the vehicle's link. Runs on the reader's thread.</summary>
internal sealed class VehicleFrameSource(IByteLink link) : IReaderSource<MavlinkFrame>
{
    private readonly MavlinkFrameReader _frames = new(MavlinkDialect.All);
    private readonly byte[] _buffer = new byte[2048];
    private int _start;
    private int _count;
    private bool _hasEnded;
    private long _unknown;

    public bool Blocks => link.Blocks;

    /// <summary>Frames that no dialect knows, which nobody could check. Any thread.</summary>
    public long Unknown => Interlocked.Read(ref _unknown);

    public void Open(ReaderContext context)
    {
        if (!link.Blocks)
            link.SetReadableCallback(context.Signal);
    }

    public ReaderStep Read(out MavlinkFrame value)
    {
        while (true)
        {
            while (TryTake(out value, out bool isChecked))
            {
                if (isChecked)
                    return ReaderStep.Value;
                Interlocked.Increment(ref _unknown);
            }

            if (_hasEnded)
                return ReaderStep.Ended;
            LinkRead read = link.Read(_buffer);
            if (read.Kind == LinkReadKind.NothingYet)
                return ReaderStep.WaitForSignal;
            (_start, _count, _hasEnded) = (0, read.Count, read.Kind == LinkReadKind.Ended);
        }
    }

    public void Unblock() => link.Unblock();

    // The link itself belongs to whoever opened it.
    public void Close() => link.SetReadableCallback(null);

    private bool TryTake(out MavlinkFrame frame, out bool isChecked)
    {
        var rest = new ReadOnlySpan<byte>(_buffer, _start, _count);
        bool isTaken = _frames.TryRead(ref rest, out frame, out MavlinkFrameInfo info);
        _start += _count - rest.Length;
        _count = rest.Length;
        isChecked = info.IsChecked;
        return isTaken;
    }
}
