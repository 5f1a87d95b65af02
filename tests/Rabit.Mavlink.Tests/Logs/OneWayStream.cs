using System;
using System.IO;

namespace Rabit.Mavlink.Tests.Logs;

/// <summary>
/// A stream that cannot seek, as pipes and sockets are, and may give little at a time. Where it is longer than its
/// bytes, they come over and over: a file of any size without a disk.
/// </summary>
internal sealed class OneWayStream(byte[] bytes, long length, int readLength = int.MaxValue) : Stream
{
    private long _position;

    public override bool CanRead => true;

    public override bool CanSeek => false;

    public override bool CanWrite => false;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public override int Read(byte[] buffer, int offset, int count)
    {
        if (_position == length)
            return 0;
        int from = (int)(_position % bytes.Length);
        int given = (int)Math.Min(Math.Min(Math.Min(count, readLength), bytes.Length - from), length - _position);
        Array.Copy(bytes, from, buffer, offset, given);
        _position += given;
        return given;
    }

    public override void Flush() => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();
}
