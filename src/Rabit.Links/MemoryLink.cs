using System;
using System.Threading;

namespace Rabit.Links;

/// <summary>One end of a <see cref="MemoryLinkPair"/>. It owns the bytes on their way to it.</summary>
internal sealed class MemoryLink(string url, int capacityBytes) : IByteLink
{
    private const string PeerGoneReason = "the other end was closed";

    private readonly LinkLifetime _state = new(url);
    private readonly object _gate = new();
    private readonly byte[] _ring = new byte[capacityBytes];
    private MemoryLink? _peer; // set once, before another thread can see this end
    private Action? _readable; // volatile access
    private int _head; // guarded by _gate: index of the oldest byte
    private int _resident; // guarded by _gate: bytes not yet read
    private bool _peerGone; // guarded by _gate

    public string Url => _state.Url;

    public bool Blocks => false;

    public LinkCounters Counters => _state.Counters;

    public ByteLinkState State => _state.State;

    public string? LastFault => _state.LastFault;

    public void ConnectTo(MemoryLink peer) => _peer = peer;

    public LinkRead Read(byte[] buffer, int timeoutMilliseconds = Timeout.Infinite)
    {
        _state.CheckRead(buffer, timeoutMilliseconds);
        lock (_gate)
        {
            if (_state.EndReason is { } reason) return LinkRead.Ended(reason);
            if (_resident > 0) return _state.Arrived(TakeInto(buffer));
            if (!_peerGone) return LinkRead.NothingYet;
            _state.TryEnd(PeerGoneReason);
            return LinkRead.Ended(PeerGoneReason);
        }
    }

    public void Write(byte[] buffer, int offset, int count)
    {
        if (!_state.CheckWrite(buffer, offset, count)) return;
        if (!_peer!.TryAccept(buffer, offset, count, out bool closed))
        {
            _state.Dropped(count);
            if (closed) throw new LinkException(Url, $"cannot write: {PeerGoneReason}", linkEnded: true);
            return;
        }

        _state.Sent(count);
        _peer.SignalReadable();
    }

    public void Unblock()
    {
        if (!_state.TryEnd(LinkLifetime.UnblockedReason)) return;
        SignalReadable();
        _peer!.LosePeer();
    }

    public void Dispose()
    {
        if (_state.TryDispose()) Unblock();
    }

    public void SetReadableCallback(Action? callback) => Volatile.Write(ref _readable, callback);

    private bool TryAccept(byte[] buffer, int offset, int count, out bool closed)
    {
        lock (_gate)
        {
            closed = _state.EndReason is not null;
            if (closed || count > _ring.Length - _resident) return false;
            int tail = (int)(((long)_head + _resident) % _ring.Length);
            int untilWrap = Math.Min(count, _ring.Length - tail);
            Buffer.BlockCopy(buffer, offset, _ring, tail, untilWrap);
            Buffer.BlockCopy(buffer, offset + untilWrap, _ring, 0, count - untilWrap);
            _resident += count;
            return true;
        }
    }

    private int TakeInto(byte[] buffer)
    {
        int count = Math.Min(buffer.Length, _resident);
        int untilWrap = Math.Min(count, _ring.Length - _head);
        Buffer.BlockCopy(_ring, _head, buffer, 0, untilWrap);
        Buffer.BlockCopy(_ring, 0, buffer, untilWrap, count - untilWrap);
        _head = (int)(((long)_head + count) % _ring.Length);
        _resident -= count;
        return count;
    }

    private void LosePeer()
    {
        lock (_gate) _peerGone = true;
        SignalReadable();
    }

    private void SignalReadable() => Volatile.Read(ref _readable)?.Invoke();
}
