using System;
using System.Threading;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Links;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>Reads the bytes of a live link and makes frames of them. Runs on the reader's thread.</summary>
internal sealed class LinkFrameSource(IByteLink link, int number, MavlinkDialect dialect, FrameStatistics tally) : IReaderSource<LinkFrame>
{
    private const int BufferLength = 4096;

    private readonly MavlinkFrameReader _frames = new(dialect);
    private readonly byte[] _buffer = new byte[BufferLength];
    private ReaderContext? _context;
    private int _start;
    private int _count;
    private TimeSpan _time;
    private long _utcMicroseconds;
    private long _index;
    private long _bytesLost;
    private long _incompatibleFrames;
    private bool _hasEnded;

    public bool Blocks => link.Blocks;

    /// <summary>Bytes that belong to no frame. Any thread.</summary>
    public long BytesLost => Interlocked.Read(ref _bytesLost);

    /// <summary>Frames that had to be left out, because an incompatibility flag is not known. Any thread.</summary>
    public long IncompatibleFrames => Interlocked.Read(ref _incompatibleFrames);

    public void Open(ReaderContext context)
    {
        _context = context;
        if (!link.Blocks)
            link.SetReadableCallback(context.Signal);
    }

    public ReaderStep Read(out LinkFrame value)
    {
        while (true)
        {
            if (TryTakeFrame(out MavlinkFrame frame, out MavlinkFrameInfo info))
            {
                tally.Count(frame, info.IsChecked);
                value = new LinkFrame { Frame = frame, Link = number, Index = _index++, Time = _time, UtcMicroseconds = _utcMicroseconds };
                value.SetAddress(info.IsChecked, info.Message);
                return ReaderStep.Value;
            }

            value = default;
            Interlocked.Exchange(ref _bytesLost, _frames.Counters.SkippedBytes);
            Interlocked.Exchange(ref _incompatibleFrames, _frames.Counters.IncompatibleFrames);
            if (_hasEnded)
                return ReaderStep.Ended;

            LinkRead read = link.Read(_buffer);
            if (read.Kind == LinkReadKind.NothingYet)
                return ReaderStep.WaitForSignal;
            Accept(read);
        }
    }

    public void Unblock() => link.Unblock();

    // The link itself belongs to whoever opened it: its writer may not be done yet.
    public void Close() => link.SetReadableCallback(null);

    private void Accept(LinkRead read)
    {
        _start = 0;
        _count = read.Count;
        _hasEnded = read.Kind == LinkReadKind.Ended;
        if (_hasEnded)
            return;
        _time = _context!.Now;
        _utcMicroseconds = (_context.Clock.GetUtcNow() - DateTimeOffset.FromUnixTimeSeconds(0)).Ticks / 10;
    }

    private bool TryTakeFrame(out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        var rest = new ReadOnlySpan<byte>(_buffer, _start, _count);
        bool taken = _frames.TryRead(ref rest, out frame, out info);
        _start += _count - rest.Length;
        _count = rest.Length;
        return taken || (_hasEnded && _frames.TryFlush(out frame, out info));
    }
}
