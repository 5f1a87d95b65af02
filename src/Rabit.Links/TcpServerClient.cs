using System;
using System.Net.Sockets;

namespace Rabit.Links;

/// <summary>
/// One client of a <see cref="TcpServerLink"/>. A write never waits for it: what the system does not take at once is
/// kept, one write at most, and further writes pass it by until it has gone, so that no write is cut in two. Guarded
/// by the link.
/// </summary>
internal sealed class TcpServerClient(Socket socket, TimeProvider clock)
{
    private byte[] _rest = [];
    private int _restStart;
    private int _restEnd;
    private long _stalledSince;

    public Socket Socket { get; } = socket;

    /// <summary>When it was last read from, or was accepted.</summary>
    public long LastReceived { get; set; } = clock.GetTimestamp();

    /// <summary>Whether a part of a write waits for room.</summary>
    public bool HasRest => _restEnd > _restStart;

    /// <summary>For how long it has taken nothing while something waited.</summary>
    public TimeSpan StalledFor => HasRest ? clock.GetElapsedTime(_stalledSince) : TimeSpan.Zero;

    /// <summary>Sends what waits, as far as there is room. False where the connection is broken.</summary>
    public bool TrySendRest()
    {
        if (!HasRest) return true;
        if (!TrySend(_rest, _restStart, _restEnd - _restStart, out int taken)) return false;
        if (taken > 0) _stalledSince = clock.GetTimestamp();
        _restStart += taken;
        return true;
    }

    /// <summary>
    /// Sends, or keeps the rest of what was begun: then it is taken, else nothing of it is. False where the connection
    /// is broken.
    /// </summary>
    public bool TryWrite(byte[] buffer, int offset, int count, out bool isTaken)
    {
        isTaken = false;
        if (!TrySendRest()) return false;
        if (HasRest) return true;
        if (!TrySend(buffer, offset, count, out int taken)) return false;
        isTaken = taken > 0;
        if (taken is 0 || taken == count) return true;

        _restStart = 0;
        _restEnd = count - taken;
        if (_rest.Length < _restEnd) _rest = new byte[Math.Max(_restEnd, 1024)];
        Buffer.BlockCopy(buffer, offset + taken, _rest, 0, _restEnd);
        _stalledSince = clock.GetTimestamp();
        return true;
    }

    private bool TrySend(byte[] buffer, int offset, int count, out int taken)
    {
        taken = 0;
        try
        {
            // Mono tries again for as long as there is no room, although the socket does not block.
            if (!Socket.Poll(0, SelectMode.SelectWrite)) return true;
            taken = Socket.Send(buffer, offset, count, SocketFlags.None, out SocketError error);
            if (error != SocketError.Success) taken = 0;
            return error is SocketError.Success || SocketFaults.IsTimeout(error);
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            taken = 0;
            return e is SocketException fault && SocketFaults.IsTimeout(fault.SocketErrorCode);
        }
    }
}
