using System;
using System.Threading;

namespace Rabit.Links;

/// <summary>
/// <c>serial:DEVICE:BAUD</c>: a serial line on Linux (x64, arm64, arm): raw, 8 data bits, no parity, 1 stop bit, no
/// flow control, this program's alone. Reading says that the link has ended when the device is unplugged. A write that
/// finds no room for the whole write time-out throws, and what was left of it is dropped and counted; the next one may
/// succeed.
/// </summary>
/// <example>
/// <code>
/// using SerialLink line = SerialLink.Open("/dev/ttyUSB0", 115200);
/// var buffer = new byte[256];
/// for (LinkRead read = line.Read(buffer); read.Kind != LinkReadKind.Ended; read = line.Read(buffer))
///     Console.WriteLine($"{read.Count} bytes");
/// </code>
/// </example>
public sealed class SerialLink : IByteLink
{
    private const string UnpluggedReason = "the device hung up (unplugged?)";

    private readonly SerialDevice _device;
    private readonly LinkLifetime _state;
    private readonly int _writeTimeoutMilliseconds;
    private readonly object _writeGate = new(); // keeps the bytes of one write together

    private SerialLink(SerialDevice device, LinkLifetime state, int writeTimeoutMilliseconds)
    {
        _device = device;
        _state = state;
        _writeTimeoutMilliseconds = writeTimeoutMilliseconds;
    }

    /// <inheritdoc/>
    public string Url => _state.Url;

    /// <inheritdoc/>
    public bool Blocks => true;

    /// <inheritdoc/>
    public LinkCounters Counters => _state.Counters;

    /// <inheritdoc/>
    public ByteLinkState State => _state.State;

    /// <inheritdoc/>
    public string? LastFault => _state.LastFault;

    /// <summary>Opens a serial line.</summary>
    /// <param name="device">
    /// Path of the device, for example <c>/dev/ttyAMA0</c>, <c>/dev/serial0</c> or one of <c>/dev/serial/by-id</c>.
    /// </param>
    /// <param name="baudRate">
    /// Bits per second, at least 1; any that the device can do within 2.5 %, also unusual ones such as 250000.
    /// </param>
    /// <param name="options">How long a write may wait; the defaults if left out.</param>
    /// <exception cref="LinkException">
    /// No such device, no permission, not a serial device, in use, or the rate cannot be done.
    /// </exception>
    /// <exception cref="PlatformNotSupportedException">Not on Linux.</exception>
    public static SerialLink Open(string device, int baudRate, LinkOptions? options = null)
    {
        if (string.IsNullOrEmpty(device))
            throw new ArgumentException("a serial line needs the path of its device", nameof(device));
        if (baudRate < 1)
            throw new ArgumentOutOfRangeException(nameof(baudRate), baudRate, "a baud rate is at least 1");
        string url = LinkUrl.ForSerial(device, baudRate).ToString();
        if (!OperatingSystem.IsLinux())
            throw new PlatformNotSupportedException(
                $"link {url}: serial links work on Linux only; elsewhere use udpin, udpout or tcp");

        SerialDevice opened = SerialDevice.TryOpen(device, baudRate, out string fault, out int errno)
            ?? throw new LinkException(
                url, $"cannot open: {fault}", linkEnded: true, mayPass: Errno.MayPass(errno));
        return new SerialLink(opened, new LinkLifetime(url), (options ?? LinkOptions.Default).WriteTimeoutMilliseconds);
    }

    /// <inheritdoc/>
    public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
    {
        _state.CheckRead(buffer, timeoutMilliseconds);
        bool held = false;
        try
        {
            _device.DangerousAddRef(ref held);
            return ReadHeld(buffer, timeoutMilliseconds);
        }
        finally
        {
            if (held) _device.DangerousRelease();
        }
    }

    /// <inheritdoc/>
    public void Write(byte[] buffer, int offset, int count)
    {
        if (!_state.CheckWrite(buffer, offset, count)) return;
        bool held = false;
        try
        {
            _device.DangerousAddRef(ref held);
            lock (_writeGate) WriteHeld(buffer, offset, count);
        }
        finally
        {
            if (held) _device.DangerousRelease();
        }
    }

    /// <inheritdoc/>
    public void Unblock() => End(LinkLifetime.UnblockedReason);

    /// <inheritdoc/>
    public void SetReadableCallback(Action? callback)
    {
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        if (!_state.TryDispose()) return;
        Unblock();
        Wake(); // again, in case another thread is about to: after the device is disposed it is too late
        _device.Dispose();
    }

    private LinkRead ReadHeld(byte[] buffer, int timeoutMilliseconds)
    {
        var left = new Deadline(timeoutMilliseconds);
        while (true)
        {
            _device.WaitReadable(left.Milliseconds);
            if (_state.EndReason is { } reason) return LinkRead.Ended(reason);
            int count = _device.Read(buffer, out int errno);
            if (count > 0) return _state.Arrived(count);
            if (count == 0 || Errno.IsUnplugged(errno)) End(UnpluggedReason);
            else if (errno is not (Errno.TryAgain or Errno.Interrupted)) throw Broken(Errno.Describe(errno));
            else if (left.HasPassed) return LinkRead.NothingYet;
        }
    }

    private void WriteHeld(byte[] buffer, int offset, int count)
    {
        Deadline? deadline = null; // set at the first wait: most writes need none
        int left = count;
        while (left > 0)
        {
            if (_state.EndReason is not null) throw _state.DroppedByEnd(left);
            int taken = _device.Write(buffer, offset + count - left, left, out int errno);
            if (taken >= 0)
            {
                _state.Sent(taken);
                left -= taken;
            }
            else if (errno == Errno.TryAgain)
            {
                if (!WaitForRoom(ref deadline)) throw DroppedByTimeout(left);
            }
            else if (errno != Errno.Interrupted)
            {
                End(Errno.IsUnplugged(errno) ? UnpluggedReason : Errno.Describe(errno));
                throw _state.DroppedByEnd(left);
            }
        }
    }

    // A wait may return early, so it is counted against a deadline, which a garbage collection does not move.
    private bool WaitForRoom(ref Deadline? deadline)
    {
        Deadline set = deadline ??= new Deadline(_writeTimeoutMilliseconds);
        if (set.HasPassed) return false;
        _device.WaitWritable(set.Milliseconds);
        return true;
    }

    private LinkException DroppedByTimeout(int count)
    {
        _state.Dropped(count);
        return new LinkException(
            Url, $"cannot write: the line took no more for {_writeTimeoutMilliseconds} ms; {count} bytes dropped",
            linkEnded: false);
    }

    private LinkException Broken(string reason)
    {
        End(reason);
        return new LinkException(Url, $"cannot read: {reason}", linkEnded: true);
    }

    private void End(string reason)
    {
        if (_state.TryEnd(reason)) Wake();
    }

    private void Wake()
    {
        bool held = false;
        try
        {
            _device.DangerousAddRef(ref held);
            _device.Wake();
        }
        catch (ObjectDisposedException)
        {
            // Then the dispose has woken all waits first.
        }
        finally
        {
            if (held) _device.DangerousRelease();
        }
    }
}
