using System;
using System.Threading;
using Rabit.Links;

namespace Rabit.Uav.Tests.Communications;

/// <summary>A link that hands out what the test gives it, and throws when the test says so.</summary>
internal sealed class FaultyLink : IByteLink
{
    private Action? _readable;
    private byte[]? _bytes;

    public Exception? ReadFault { get; private set; }

    public Exception? WriteFault { get; set; }

    public int Written { get; private set; }

    public string Url => "fake:0";

    public bool Blocks => false;

    public LinkCounters Counters => default;

    public void Give(byte[] bytes)
    {
        _bytes = bytes;
        _readable?.Invoke();
    }

    public void FailReading(Exception fault)
    {
        ReadFault = fault;
        _readable?.Invoke();
    }

    public ByteLinkState State => ByteLinkState.Open;

    public string? LastFault => null;

    public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
    {
        if (ReadFault is not null)
            throw ReadFault;
        if (_bytes is not { } bytes)
            return LinkRead.NothingYet;
        _bytes = null;
        bytes.CopyTo(buffer, 0);
        return LinkRead.Bytes(bytes.Length);
    }

    public void Write(byte[] buffer, int offset, int count)
    {
        if (WriteFault is not null)
            throw WriteFault;
        Written++;
    }

    public void Unblock()
    {
    }

    public void SetReadableCallback(Action? callback) => _readable = callback;

    public void Dispose()
    {
    }
}
