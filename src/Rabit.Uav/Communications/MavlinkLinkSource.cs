using System;
using System.Threading;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Makes MAVLink frames of the bytes of a live link: the source of a manager's reader. Frames that cannot be checked
/// are delivered too; see <see cref="LinkFrame.IsChecked"/>. What a false header holds back is delivered after a short
/// silence. Allocates nothing per frame. Used by one reader, whose thread calls it.
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
    private readonly PeerFrames _peers;
    private MavlinkFrameReader? _frames; // of the peer whose bytes are in the buffer
    private readonly byte[] _buffer = new byte[BufferLength];
    private ReaderContext? _context;
    private int _start;
    private int _count;
    private TimeSpan _time;
    private long _utcMicroseconds;
    private long _index;
    private long _bytesLost;
    private long _incompatibleFrames;
    private bool _isFlushing;
    private bool _hasEnded;

    /// <summary>Makes the source.</summary>
    /// <param name="link">
    /// Open; it stays the caller's to dispose, since its writer may not be done yet when its reader is.
    /// </param>
    /// <param name="number">What <see cref="LinkFrame.Link"/> says.</param>
    /// <param name="dialect">The messages that are checked; null for <see cref="MavlinkDialect.All"/>.</param>
    /// <param name="flushAfter">
    /// After what silence what looks like the beginning of a frame is taken for noise; null for
    /// <see cref="DatagramFlush"/> on links whose URL says that they carry datagrams, else <see cref="StreamFlush"/>.
    /// </param>
    /// <exception cref="ArgumentNullException">No link.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The silence is not above zero.</exception>
    public MavlinkLinkSource(
        IByteLink link, int number = 0, MavlinkDialect? dialect = null, TimeSpan? flushAfter = null)
        : this(link, number, dialect ?? MavlinkDialect.All, statistics: null, flushAfter)
    {
    }

    internal MavlinkLinkSource(
        IByteLink link, int number, MavlinkDialect dialect, FrameStatistics? statistics, TimeSpan? flushAfter = null)
    {
        if (flushAfter <= TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(flushAfter), flushAfter, "the silence must be above zero");
        _link = link ?? throw new ArgumentNullException(nameof(link));
        _number = number;
        _statistics = statistics;
        _peers = new PeerFrames(dialect, flushAfter ?? DefaultFlush(link));
    }

    /// <summary>The silence after which a byte stream is flushed: 100 ms.</summary>
    public static TimeSpan StreamFlush { get; } = TimeSpan.FromMilliseconds(100);

    /// <summary>The silence after which a link of datagrams is flushed: 20 ms.</summary>
    public static TimeSpan DatagramFlush { get; } = TimeSpan.FromMilliseconds(20);

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
            Interlocked.Exchange(ref _bytesLost, _peers.SkippedBytes);
            Interlocked.Exchange(ref _incompatibleFrames, _peers.IncompatibleFrames);
            if (_hasEnded)
                return ReaderStep.Ended;
            if (!TryReadLink(out ReaderStep wait))
                return wait;
        }
    }

    /// <inheritdoc/>
    public void Unblock() => _link.Unblock();

    /// <inheritdoc/>
    public void Close() => _link.SetReadableCallback(null);

    // False where there is nothing to do before the step that it gives. Bytes come first: what is flushed has been
    // silent up to now, however late this thread is.
    private bool TryReadLink(out ReaderStep wait)
    {
        TimeSpan flush = _peers.NextFlush;
        LinkRead read = _link.Read(_buffer, flush == TimeSpan.MaxValue ? Timeout.Infinite : Milliseconds(flush));
        wait = default;
        if (read.Kind != LinkReadKind.NothingYet)
        {
            Accept(read);
            return true;
        }

        TimeSpan now = _context!.Now;
        _isFlushing = flush <= now;
        if (_isFlushing || _link.Blocks)
            return true;
        TimeSpan due = read.RetryAfter is { } delay && now + delay < flush ? now + delay : flush;
        wait = due == TimeSpan.MaxValue ? ReaderStep.WaitForSignal : ReaderStep.WaitUntil(due);
        return false;
    }

    private int Milliseconds(TimeSpan due)
        => Math.Max(1, (int)Math.Ceiling((due - _context!.Now).ExactMilliseconds));

    private void Accept(LinkRead read)
    {
        _start = 0;
        _count = read.Count;
        _hasEnded = read.Kind == LinkReadKind.Ended;
        if (_hasEnded)
            return;
        _time = _context!.Now;
        _frames = _peers.Of(read, _time);
        _utcMicroseconds = (_context.Clock.GetUtcNow() - DateTimeOffset.FromUnixTimeSeconds(0)).Ticks / 10;
    }

    // Where no more bytes come, what was held back as the beginning of a longer frame is searched for frames too.
    private bool TryTakeFrame(out MavlinkFrame frame, out MavlinkFrameInfo info)
    {
        frame = default;
        info = default;
        if (_frames is null)
            return false;
        if (_hasEnded)
            return _peers.TryFlush(TimeSpan.MaxValue, out frame, out info);
        if (_isFlushing)
        {
            _isFlushing = _peers.TryFlush(_context!.Now, out frame, out info);
            return _isFlushing;
        }

        var rest = new ReadOnlySpan<byte>(_buffer, _start, _count);
        bool taken = _frames.TryRead(ref rest, out frame, out info);
        _start += _count - rest.Length;
        _count = rest.Length;
        return taken;
    }

    private static TimeSpan DefaultFlush(IByteLink link)
        => LinkUrl.TryParse(link.Url, out LinkUrl? url, out _) && url.IsDatagram ? DatagramFlush : StreamFlush;
}
