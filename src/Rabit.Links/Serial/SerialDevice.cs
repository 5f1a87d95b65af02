using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Rabit.Links;

/// <summary>
/// An open terminal and the event that ends waiting for it. The two descriptors are closed when the last call that uses
/// them has returned: closing does not end a blocked poll, and a descriptor closed under a call could by then be
/// another file's.
/// </summary>
internal sealed unsafe class SerialDevice : SafeHandle
{
    private static readonly byte[] One = BitConverter.GetBytes(1UL);

    private readonly int _terminal;
    private readonly int _wakeEvent;

    private SerialDevice(int terminal, int wakeEvent)
        : base(IntPtr.Zero, ownsHandle: true)
    {
        _terminal = terminal;
        _wakeEvent = wakeEvent;
        SetHandle((IntPtr)1); // only says "open"
    }

    /// <inheritdoc/>
    public override bool IsInvalid => handle == IntPtr.Zero;

    /// <summary>Opens and sets a terminal. Null, with the reason, if that cannot be done.</summary>
    public static SerialDevice? TryOpen(string path, int baudRate, out string fault, out int errno)
    {
        fault = "";
        errno = 0;
        int terminal = OpenTerminal(path);
        if (terminal < 0)
        {
            errno = Marshal.GetLastWin32Error();
            fault = Errno.Describe(errno);
            return null;
        }

        int wakeEvent = -1;
        if (SerialSettings.Apply(terminal, baudRate) is { } settingsFault) fault = settingsFault;
        else if ((wakeEvent = Libc.eventfd(0, Libc.NonBlocking | Libc.CloseOnExec)) < 0)
            fault = Errno.Describe(Marshal.GetLastWin32Error());
        if (fault.Length == 0) return new SerialDevice(terminal, wakeEvent);

        _ = Libc.close(terminal);
        return null;
    }

    /// <summary>Reads what has arrived. Bytes, 0 if the line has hung up, or -1 and the error number.</summary>
    public int Read(byte[] buffer, out int errno)
    {
        fixed (byte* start = buffer)
        {
            int count = (int)Libc.read(_terminal, start, (nuint)buffer.Length);
            errno = count < 0 ? Marshal.GetLastWin32Error() : 0;
            return count;
        }
    }

    /// <summary>Writes what there is room for. Bytes, or -1 and the error number.</summary>
    public int Write(byte[] buffer, int offset, int count, out int errno)
    {
        fixed (byte* start = &buffer[offset])
        {
            int taken = (int)Libc.write(_terminal, start, (nuint)count);
            errno = taken < 0 ? Marshal.GetLastWin32Error() : 0;
            return taken;
        }
    }

    /// <summary>
    /// Waits until the line can be read (or has hung up), the time is up, or <see cref="Wake"/> was called. Also
    /// returns early for no reason: under Mono nearly every garbage collection interrupts a poll.
    /// </summary>
    public void WaitReadable(int timeoutMilliseconds) => Wait(Libc.PollIn, timeoutMilliseconds);

    /// <summary>
    /// Waits until the line takes bytes (or has hung up), the time is up, <see cref="Wake"/> was called, or for no
    /// reason.
    /// </summary>
    public void WaitWritable(int timeoutMilliseconds) => Wait(Libc.PollOut, timeoutMilliseconds);

    /// <summary>Ends every wait, those to come included.</summary>
    public void Wake()
    {
        fixed (byte* one = One) _ = Libc.write(_wakeEvent, one, (nuint)One.Length);
    }

    /// <inheritdoc/>
    protected override bool ReleaseHandle()
    {
        _ = Libc.close(_wakeEvent);
        return Libc.close(_terminal) == 0;
    }

    private static int OpenTerminal(string path)
    {
        byte[] name = Encoding.UTF8.GetBytes(path + "\0");
        fixed (byte* start = name)
        {
            int terminal;
            do
            {
                terminal = Libc.open(
                    start, Libc.ReadWrite | Libc.NoControllingTerminal | Libc.NonBlocking | Libc.CloseOnExec);
            }
            while (terminal < 0 && Marshal.GetLastWin32Error() == Errno.Interrupted);

            // A second program on the line would take some of the bytes. It fails for what is no terminal, which the
            // settings then report.
            if (terminal >= 0) _ = Libc.ioctl(terminal, Libc.SetExclusive, null);
            return terminal;
        }
    }

    private void Wait(short events, int timeoutMilliseconds)
    {
        Libc.PollEntry* entries = stackalloc Libc.PollEntry[2];
        entries[0] = new Libc.PollEntry { Descriptor = _terminal, Events = events };
        entries[1] = new Libc.PollEntry { Descriptor = _wakeEvent, Events = Libc.PollIn };
        _ = Libc.poll(entries, 2, timeoutMilliseconds);
    }
}
