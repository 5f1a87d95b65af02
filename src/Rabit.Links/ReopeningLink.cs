using System;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// A link that opens another one, and opens it again whenever it has ended: after the end of the file, a reset, an
/// unplugged cable, and from the start where nothing is there yet. The delay between two tries doubles from 100 ms to
/// 2 s at most. It ends only by <see cref="Unblock"/> and <see cref="Dispose"/>.
/// </summary>
/// <remarks>
/// The thread that reads also opens: who only writes must read all the same. What is written while it is not open is
/// dropped and counted, without an exception and without a wait. A device that has another number when it comes back
/// is found by a name that stays, such as those in <c>/dev/serial/by-id</c>. Bytes before and after a break follow each
/// other without a mark; a frame that the break cut is for the checksum to find.
/// </remarks>
/// <example>
/// <code>
/// using ReopeningLink line = ReopeningLink.Open(LinkUrl.Parse("serial:/dev/ttyUSB0:115200"));
/// LinkRead read = line.Read(buffer);   // waits for bytes, through any number of unpluggings, or Unblock
/// </code>
/// </example>
public sealed class ReopeningLink : IByteLink, INonBlockingWriter
{
    private readonly LinkLifetime _state;
    private readonly LinkStop _stop;
    private readonly Func<IByteLink> _open;
    private readonly ReopenSchedule _schedule;
    private readonly object _gate = new();
    private IByteLink? _session; // the link that is open; written by the reader's thread under _gate
    private IByteLink? _retired; // the one before: a late writer may still count on it; guarded by _gate
    private LinkCounters _past; // of those before that; guarded by _gate
    private string? _lastFault; // volatile access
    private int _isOpening; // volatile access
    private Action? _readable; // volatile access

    /// <summary>Makes a link that opens what a function opens. The first read opens it.</summary>
    /// <param name="url">See <see cref="Url"/>.</param>
    /// <param name="open">
    /// Opens the link, and throws a <see cref="LinkException"/> when that fails. Called on the thread that reads.
    /// </param>
    /// <param name="blocks">Whether the links that it opens block; see <see cref="Blocks"/>.</param>
    /// <param name="options">The delays, and for links that do not block the clock; the defaults if left out.</param>
    public ReopeningLink(string url, Func<IByteLink> open, bool blocks = true, LinkOptions? options = null)
        : this(url, open, blocks, options ?? LinkOptions.Default, new LinkStop())
    {
    }

    private ReopeningLink(string url, Func<IByteLink> open, bool blocks, LinkOptions options, LinkStop stop)
    {
        _state = new LinkLifetime(url ?? throw new ArgumentNullException(nameof(url)), openings: 0);
        _open = open ?? throw new ArgumentNullException(nameof(open));
        _stop = stop;
        _schedule = new ReopenSchedule(options);
        Blocks = blocks;
    }

    /// <inheritdoc/>
    public string Url => _state.Url;

    /// <inheritdoc/>
    public bool Blocks { get; }

    /// <inheritdoc/>
    public ByteLinkState State =>
        _state.EndReason is not null ? ByteLinkState.Closed
        : Volatile.Read(ref _isOpening) != 0 ? ByteLinkState.Opening
        : Volatile.Read(ref _session) is null ? ByteLinkState.WaitingToReopen
        : ByteLinkState.Open;

    /// <inheritdoc/>
    public string? LastFault => Volatile.Read(ref _lastFault);

    /// <summary>What has gone through in all openings together.</summary>
    public LinkCounters Counters
    {
        get
        {
            lock (_gate)
            {
                LinkCounters all = _past.Plus(_state.Counters);
                if (_retired is not null) all = all.Plus(_retired.Counters);
                return _session is null ? all : all.Plus(_session.Counters);
            }
        }
    }

    /// <summary>
    /// Makes a link of a URL and tries to open it, once. What may pass (nothing listens yet, no such device) is left
    /// to later tries; what a user must put right (a permission, a port in use) is an exception now, but not once
    /// it has been open.
    /// </summary>
    /// <param name="url">Any kind but <see cref="LinkKind.RecordedFile"/>.</param>
    /// <param name="options">How long to wait; the defaults if left out.</param>
    /// <exception cref="LinkException">It cannot be opened, and waiting would not help.</exception>
    /// <exception cref="PlatformNotSupportedException">A serial line on another system than Linux.</exception>
    /// <exception cref="ArgumentException">A recorded file: it is played, not opened as a live link.</exception>
    public static ReopeningLink Open(LinkUrl url, LinkOptions? options = null)
    {
        if (url is null) throw new ArgumentNullException(nameof(url));
        var stop = new LinkStop();
        var link = new ReopeningLink(
            url.Address, () => LinkFactory.Open(url, options, stop), blocks: true, options ?? LinkOptions.Default,
            stop);
        if (link.TryOpen() is { MayPass: false } fault) throw fault;
        return link;
    }

    /// <inheritdoc/>
    public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
    {
        _state.CheckRead(buffer, timeoutMilliseconds);
        var deadline = new Deadline(timeoutMilliseconds);
        while (true)
        {
            if (_state.EndReason is { } reason) return LinkRead.Ended(reason);
            if (_session is null)
            {
                TimeSpan left = _schedule.Left;
                if (left <= TimeSpan.Zero) TryOpen();
                else if (!Blocks) return LinkRead.NothingYetFor(left);
                else if (deadline.HasPassed) return LinkRead.NothingYet;
                else _stop.Wait(Shorter(left, deadline.Milliseconds));
            }
            else if (TryRead(_session, buffer, deadline.Milliseconds, out LinkRead read))
            {
                return read;
            }
        }
    }

    /// <inheritdoc/>
    public void Write(byte[] buffer, int offset, int count)
    {
        if (!_state.CheckWrite(buffer, offset, count)) return;
        if (Volatile.Read(ref _session) is not { } session)
        {
            _state.Dropped(count);
            return;
        }

        try
        {
            session.Write(buffer, offset, count);
        }
        catch (LinkException e) when (e.LinkEnded && _state.EndReason is null)
        {
            // Counted by the link that ended, whose reader opens the next one.
        }
        catch (ObjectDisposedException)
        {
            _state.Dropped(count);
        }
    }

    /// <inheritdoc/>
    public bool TryWrite(byte[] buffer, int offset, int count)
        => _state.IsWritable(buffer, offset, count) && Volatile.Read(ref _session) is INonBlockingWriter session
            && session.TryWrite(buffer, offset, count);

    /// <inheritdoc/>
    public void Unblock()
    {
        if (!_state.TryEnd(LinkLifetime.UnblockedReason)) return;
        _stop.Request();
        Volatile.Read(ref _session)?.Unblock();
        SignalReadable();
    }

    /// <inheritdoc/>
    public void SetReadableCallback(Action? callback) => Volatile.Write(ref _readable, callback);

    /// <inheritdoc/>
    public void Dispose()
    {
        if (!_state.TryDispose()) return;
        Unblock();
        Volatile.Read(ref _session)?.Dispose();
    }

    private static TimeSpan Shorter(TimeSpan delay, int milliseconds)
        => milliseconds != Timeout.Infinite && delay.TotalMilliseconds > milliseconds
            ? TimeSpan.FromMilliseconds(milliseconds)
            : delay;

    // False where the link that was open has ended.
    private bool TryRead(IByteLink session, byte[] buffer, int timeoutMilliseconds, out LinkRead read)
    {
        try
        {
            read = session.Read(buffer, timeoutMilliseconds);
        }
        catch (Exception e) when (e is LinkException or ObjectDisposedException)
        {
            read = LinkRead.Ended(e is LinkException fault ? fault.Reason : LinkLifetime.UnblockedReason);
        }

        if (read.Kind == LinkReadKind.Bytes) _schedule.Received();
        if (read.Kind != LinkReadKind.Ended) return true;
        if (_state.EndReason is null) Volatile.Write(ref _lastFault, read.Reason);
        _schedule.Lost();
        Replace(session, null);
        return false;
    }

    // What was thrown; null when it is open.
    private LinkException? TryOpen()
    {
        Volatile.Write(ref _isOpening, 1);
        try
        {
            IByteLink session = _open();
            if (!Blocks) session.SetReadableCallback(SignalReadable);
            _schedule.Opened();
            Replace(null, session);
            return null;
        }
        catch (LinkException e)
        {
            if (_state.EndReason is null) Volatile.Write(ref _lastFault, e.Reason);
            _schedule.Failed();
            return e;
        }
        finally
        {
            Volatile.Write(ref _isOpening, 0);
        }
    }

    private void Replace(IByteLink? old, IByteLink? session)
    {
        lock (_gate)
        {
            Volatile.Write(ref _session, session);
            if (old is not null)
            {
                if (_retired is not null) _past = _past.Plus(_retired.Counters);
                _retired = old;
            }
        }

        old?.Dispose();

        // A stop that came while it was opened found nothing to end.
        if (session is not null && _state.EndReason is not null) session.Dispose();
    }

    private void SignalReadable() => Volatile.Read(ref _readable)?.Invoke();
}
