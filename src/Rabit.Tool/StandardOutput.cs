using System;
using System.IO;
using System.Text;
using Microsoft.Win32.SafeHandles;

namespace Rabit.Tool;

/// <summary>Standard output as a stream that says when its reader is gone.</summary>
internal static class StandardOutput
{
    private const int Descriptor = 1;

    /// <exception cref="OutputException">Of each write: the output takes no more.</exception>
    public static Stream Open() => new OutputStream(OpenPipe() ?? Console.OpenStandardOutput());

    /// <summary>The same for text: each write goes out at once.</summary>
    public static TextWriter CreateWriter()
        => new StreamWriter(Open(), new UTF8Encoding(encoderShouldEmitUTF8Identifier: false)) { AutoFlush = true };

    // The console's own stream does not say that the reader of a pipe is gone. A file goes on by the console's: its
    // position may be shared with standard error, and with the next program of a script.
    private static FileStream? OpenPipe()
    {
        if (Path.DirectorySeparatorChar != '/' || !Console.IsOutputRedirected)
            return null;
        try
        {
            var stream = new FileStream(
                new SafeFileHandle((IntPtr)Descriptor, ownsHandle: false), FileAccess.Write, bufferSize: 1);
#pragma warning disable CA1816   // It is not ours to dispose: the descriptor is the process's.
            GC.SuppressFinalize(stream);
#pragma warning restore CA1816
            return stream.CanSeek ? null : stream;
        }
        catch (Exception e) when (e is IOException or ArgumentException or UnauthorizedAccessException)
        {
            return null;
        }
    }
}
