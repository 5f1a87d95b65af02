using System;
using System.Threading;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Makes MAVLink frames of the bytes of a live link: the source of a manager's reader. Frames that cannot be checked
/// are delivered too; see <see cref="LinkFrame.IsChecked"/>. Allocates nothing per frame. Used by one reader, whose
/// thread calls it.
/// </summary>
/// <example>
/// In the constructor of a manager, and in its unit of work:
/// <code>
/// _frames = AttachReader("radio", new MavlinkLinkSource(link), 256, QueueFullMode.DropOldest);
/// </code>
/// <code>
/// while (_frames.TryPop(out LinkFrame frame))
///     Log($"message {frame.Frame.MessageId} of system {frame.Frame.SystemId}");
/// </code>
/// </example>
public sealed class MavlinkLinkSource : IReaderSource<LinkFrame>
{
    private const int BufferLength = 4096;

    private readonly IByteLink _link;
    private readonly int _number;
    private readonly FrameStatistics? _statistics;
    private readonly MavlinkFrameReader _frames;
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

    /// <summary>Makes the source.</summary>
    /// <param name="link">
    /// Open; it stays the caller's to dispose, since its writer may not be done yet when its reader is.
    /// </param>
    /// <param name="number">What <see cref="LinkFrame.Link"/> says.</param>
    /// <param name="dialect">The messages that are checked; null for <see cref="MavlinkDialect.All"/>.</param>
    /// <exception cref="ArgumentNullException">No link.</exception>
    public MavlinkLinkSource(IByteLink link, int number = 0, MavlinkDialect? dialect = null)
        : this(link, number, dialect ?? MavlinkDialect.All, statistics: null)
    {
    }

    internal MavlinkLinkSource(IByteLink link, int number, MavlinkDialect dialect, FrameStatistics? statistics)
    {
        _link = link ?? throw new ArgumentNullException(nameof(link));
        _number = number;
        _statistics = statistics;
        _frames = new MavlinkFrameReader(dialect);
    }

    /// <inheritdoc/>
    public bool Blocks => _link.Blocks;

    /// <summary>Bytes that belong to no frame. Any thread.</summary>
    public long BytesLost => Interlocked.Read(ref _bytesLost);

    /// <summary>Frames that had to be left out, because an incompatibility flag is not known. Any thread.</summary>
    public long IncompatibleFrames => Interlocked.Read(ref _incompatibleFrames);

    /// <inheritdoc/>
    public void Open(ReaderContext context)
    {
        _context = context ?? throw new ArgumentNullException(nameof(context));
        if (!_link.Blocks)
            _link.SetReadableCallback(context.Signal);
    }

    /// <inheritdoc/>
    public ReaderStep Read(out LinkFrame value)
    {
        while (true)
        {
            if (TryTakeFrame(out MavlinkFrame frame, out MavlinkFrameInfo info))
            {
                _statistics?.Count(frame, info.IsChecked);
                value = new LinkFrame
                {
                    Frame = frame,
                    Link = _number,
                    Index = _index++,
                    Time = _time,
                    UtcMicroseconds = _utcMicroseconds
                };
                value.SetAddress(info.IsChecked, info.Message);
                return ReaderStep.Value;
            }

            value = default;
            Interlocked.Exchange(ref _bytesLost, _frames.Counters.SkippedBytes);
            Interlocked.Exchange(ref _incompatibleFrames, _frames.Counters.IncompatibleFrames);
            if (_hasEnded)
                return ReaderStep.Ended;

            LinkRead read = _link.Read(_buffer);
            if (read.Kind == LinkReadKind.NothingYet)
                return ReaderStep.WaitForSignal;
            Accept(read);
        }
    }

    /// <inheritdoc/>
    public void Unblock() => _link.Unblock();

    /// <inheritdoc/>
    public void Close() => _link.SetReadableCallback(null);

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

    // Where no more bytes come, what was held back as the beginning of a longer frame is searched for frames too.
    private bool TryTakeFrame(out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        var rest = new ReadOnlySpan<byte>(_buffer, _start, _count);
        bool taken = _frames.TryRead(ref rest, out frame, out info);
        _start += _count - rest.Length;
        _count = rest.Length;
        return taken || (_hasEnded && _frames.TryFlush(out frame, out info));
    }
}
