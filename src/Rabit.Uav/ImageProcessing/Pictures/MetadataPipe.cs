using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A named pipe (FIFO) of Linux in the folder for temporary files, through which a program that was started reports
/// what is not in its pictures. One thread.
/// </summary>
internal sealed class MetadataPipe : IDisposable
{
    private const string Library = "libc";
    private const uint OwnerOnly = 0x180;                          // 0600
    private const int OpenFlags = 0x800 | 0x80000;                 // O_RDONLY, O_NONBLOCK, O_CLOEXEC
    private const int SetFlags = 4;                                // F_SETFL
    private const int Interrupted = 4;                             // EINTR

    private readonly byte[] _path;
    private readonly int _descriptor;
    private bool _hasName = true;

    /// <exception cref="IOException">It cannot be made.</exception>
    public MetadataPipe()
    {
        Path = System.IO.Path.Combine(System.IO.Path.GetTempPath(), $"rabit-metadata-{Guid.NewGuid():N}");
        _path = Encoding.UTF8.GetBytes(Path + "\0");
        if (mkfifo(_path, OwnerOnly) != 0)
            throw Fault("cannot be made");

        // Not blocking until the program has opened its end, which it may never do; blocking from then on.
        _descriptor = open(_path, OpenFlags);
        if (_descriptor < 0 || fcntl(_descriptor, SetFlags, IntPtr.Zero) < 0)
        {
            IOException fault = Fault("cannot be opened");
            Dispose();
            throw fault;
        }
    }

    public string Path { get; }

    /// <summary>Waits for bytes.</summary>
    /// <returns>How many came; 0 where no program has opened it, or it has closed it.</returns>
    public int Read(byte[] bytes)
    {
        while (true)
        {
            int count = (int)read(_descriptor, bytes, (UIntPtr)(uint)bytes.Length);
            if (count > 0)
                RemoveName();   // the program has opened it: nothing is left behind, even if this one is killed
            if (count >= 0)
                return count;
            if (Marshal.GetLastWin32Error() != Interrupted)
                return 0;
        }
    }

    public void Dispose()
    {
        RemoveName();
        if (_descriptor >= 0)
            _ = close(_descriptor);
    }

    private void RemoveName()
    {
        if (!_hasName)
            return;
        _hasName = false;
        _ = unlink(_path);
    }

    private IOException Fault(string what)
        => new(FormattableString.Invariant($"the pipe {Path} {what} (error {Marshal.GetLastWin32Error()})"));

    [DllImport(Library, SetLastError = true)]
    private static extern int mkfifo(byte[] path, uint mode);

    [DllImport(Library, SetLastError = true)]
    private static extern int open(byte[] path, int flags);

    [DllImport(Library, SetLastError = true)]
    private static extern int fcntl(int descriptor, int command, IntPtr argument);

    [DllImport(Library, SetLastError = true)]
    private static extern IntPtr read(int descriptor, byte[] bytes, UIntPtr count);

    [DllImport(Library)]
    private static extern int unlink(byte[] path);

    [DllImport(Library)]
    private static extern int close(int descriptor);
}
