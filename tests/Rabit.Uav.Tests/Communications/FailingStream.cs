using System;
using System.IO;

namespace Rabit.Uav.Tests.Communications;

/// <summary>
/// A file on a disk that is full from some byte on, and says so as a disk does: in the middle of a write.
/// </summary>
internal sealed class FailingStream(Stream inner, Func<long> room) : Stream
{
    public override bool CanRead => false;

    public override bool CanSeek => true;

    public override bool CanWrite => true;

    public override long Length => inner.Length;

    public override long Position
    {
        get => inner.Position;
        set => inner.Position = value;
    }

    public override void Flush() => inner.Flush();

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => inner.Seek(offset, origin);

    public override void SetLength(long value) => inner.SetLength(value);

    public override void Write(byte[] buffer, int offset, int count)
    {
        long fits = Math.Max(0, Math.Min(count, room() - inner.Position));
        inner.Write(buffer, offset, (int)fits);
        if (fits < count)
            throw new IOException("No space left on device");
    }

    protected override void Dispose(bool disposing)
    {
        if (disposing)
            inner.Dispose();
        base.Dispose(disposing);
    }
}
