using System;
using System.IO;
using System.Text;
using Microsoft.Win32.SafeHandles;

namespace UavConsole;

/// <summary>
/// Standard output that may be full, closed or gone: what cannot be written is counted and the flight goes on.
/// </summary>
/// <param name="inner">Standard output.</param>
internal sealed class GuardedWriter(TextWriter inner) : TextWriter
{
    private const int StandardOutputDescriptor = 1;

    private readonly object _gate = new();   // guards the two below
    private long _lost;
    private string? _failure;

    public override Encoding Encoding => inner.Encoding;

    /// <summary>What was lost, as a sentence; null where nothing was. Any thread.</summary>
    public string? Loss
    {
        get
        {
            lock (_gate)
                return _failure is null ? null : $"standard output: {_lost} writes were lost: {_failure}";
        }
    }

    /// <summary>Guards standard output as it is now.</summary>
    public static GuardedWriter Create() => new(OpenPipe() ?? Console.Out);

    public override void Write(char value) => Guard(() => inner.Write(value));

    public override void Write(char[] buffer, int index, int count)
        => Guard(() => inner.Write(buffer, index, count));

    public override void Write(string? value) => Guard(() => inner.Write(value));

    public override void WriteLine(string? value) => Guard(() => inner.WriteLine(value));

    public override void Flush() => Guard(inner.Flush);

    // The console's own stream does not say that the reader of a pipe is gone. A file goes on by the console's: its
    // position may be shared with standard error.
    private static StreamWriter? OpenPipe()
    {
        if (Path.DirectorySeparatorChar != '/' || !Console.IsOutputRedirected)
            return null;
        try
        {
            var handle = new SafeFileHandle((IntPtr)StandardOutputDescriptor, ownsHandle: false);
            var stream = new FileStream(handle, FileAccess.Write, bufferSize: 1);

            // What cannot be written shall not be tried again by a finalizer.
#pragma warning disable CA1816   // It is not ours to dispose: the descriptor is the process's.
            GC.SuppressFinalize(stream);
#pragma warning restore CA1816
            var utf8 = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false);
            return stream.CanSeek ? null : new StreamWriter(stream, utf8) { AutoFlush = true };
        }
        catch (Exception e) when (e is IOException or ArgumentException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    private void Guard(Action write)
    {
        try
        {
            write();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            lock (_gate)
            {
                _lost++;
                _failure ??= e.Message;
            }
        }
    }
}
