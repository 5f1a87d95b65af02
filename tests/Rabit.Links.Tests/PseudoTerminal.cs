using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Rabit.Links.Tests;

/// <summary>
/// The far end of a serial line: the master of a pseudo terminal, whose other side looks like a serial device.
/// </summary>
internal sealed unsafe class PseudoTerminal : IDisposable
{
    private int _master;

    public PseudoTerminal()
    {
        _master = posix_openpt(Libc.ReadWrite | Libc.NoControllingTerminal | Libc.CloseOnExec);
        byte[] name = new byte[100];
        fixed (byte* start = name)
        {
            if (_master < 0 || grantpt(_master) < 0 || unlockpt(_master) < 0
                || ptsname_r(_master, start, (nuint)name.Length) != 0)
                throw new InvalidOperationException($"no pseudo terminal, errno {Marshal.GetLastWin32Error()}");
        }

        Path = Encoding.ASCII.GetString(name, 0, Array.IndexOf(name, (byte)0));
    }

    /// <summary>The device to open.</summary>
    public string Path { get; }

    /// <summary>Gives the device a second name.</summary>
    public void LinkTo(string name)
    {
        if (symlink(Path, name) != 0)
            throw new InvalidOperationException($"no link {name}, errno {Marshal.GetLastWin32Error()}");
    }

    public void Write(byte[] bytes)
    {
        fixed (byte* start = bytes)
        {
            for (int sent = 0; sent < bytes.Length;)
            {
                int count = (int)Libc.write(_master, start + sent, (nuint)(bytes.Length - sent));
                if (count > 0) sent += count;
                else if (Marshal.GetLastWin32Error() != Errno.Interrupted) throw Fault("write");
            }
        }
    }

    public byte[] Read(int count)
    {
        byte[] bytes = new byte[count];
        fixed (byte* start = bytes)
        {
            for (int received = 0; received < count;)
            {
                WaitForBytes();
                int more = (int)Libc.read(_master, start + received, (nuint)(count - received));
                if (more > 0) received += more;
                else if (Marshal.GetLastWin32Error() != Errno.Interrupted) throw Fault("read");
            }
        }

        return bytes;
    }

    /// <summary>Pulls the plug.</summary>
    public void Dispose()
    {
        if (_master >= 0) _ = Libc.close(_master);
        _master = -1;
    }

    private void WaitForBytes()
    {
        var entry = new Libc.PollEntry { Descriptor = _master, Events = Libc.PollIn };
        DateTime deadline = DateTime.UtcNow + LinkTestBed.TestTimeout;
        while (Libc.poll(&entry, 1, (int)LinkTestBed.TestTimeout.TotalMilliseconds) <= 0)
        {
            if (DateTime.UtcNow > deadline) throw new TimeoutException("nothing came out of the pseudo terminal");
        }
    }

    private static InvalidOperationException Fault(string what) =>
        new($"cannot {what} the pseudo terminal, errno {Marshal.GetLastWin32Error()}");

    [DllImport("libc", SetLastError = true)]
    private static extern int posix_openpt(int flags);

    [DllImport("libc", SetLastError = true)]
    private static extern int grantpt(int master);

    [DllImport("libc", SetLastError = true, CharSet = CharSet.Ansi)]
    private static extern int symlink(string target, string name);

    [DllImport("libc", SetLastError = true)]
    private static extern int unlockpt(int master);

    [DllImport("libc")]
    private static extern int ptsname_r(int master, byte* name, nuint length);
}
