using System;
using System.IO;

namespace Rabit.Tool;

/// <summary>Standard output, whose failures are another exception than those of files.</summary>
internal sealed class OutputStream(Stream inner) : Stream
{
    private const int BrokenPipe = 32;   // EPIPE of Linux and macOS, which .NET gives as it is
    private const int BrokenPipeOfMono = unchecked((int)0x8007001D);   // and Mono as ERROR_WRITE_FAULT of Windows

    public override bool CanRead => false;

    public override bool CanSeek => false;

    public override bool CanWrite => true;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public override void Write(byte[] buffer, int offset, int count) => Guard(() => inner.Write(buffer, offset, count));

    public override void Flush() => Guard(inner.Flush);

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    private static void Guard(Action write)
    {
        try
        {
            write();
        }
        catch (IOException e)
        {
            throw new OutputException(e, e.HResult is BrokenPipe or BrokenPipeOfMono);
        }
    }
}
