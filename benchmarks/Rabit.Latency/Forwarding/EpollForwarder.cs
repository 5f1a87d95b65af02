using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;
using Rabit.Latency.Native;

namespace Rabit.Latency.Forwarding;

/// <summary>The limit: a thread that waits with epoll, receives and sends, and looks at nothing.</summary>
internal sealed unsafe class EpollForwarder : IForwarder
{
    private const int MaxDatagram = 2048;

    private readonly Socket _in = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
    private readonly Socket _out = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
    private readonly Thread _thread;
    private int _isEnding;

    public EpollForwarder(int target)
    {
        _in.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        _out.Connect(new IPEndPoint(IPAddress.Loopback, target));
        _thread = new Thread(Forward) { IsBackground = true };
        _thread.Start();
    }

    public int Port => ((IPEndPoint)_in.LocalEndPoint!).Port;

    public void Dispose()
    {
        Volatile.Write(ref _isEnding, 1);
        _thread.Join();
        _in.Dispose();
        _out.Dispose();
    }

    private void Forward()
    {
        (int from, int to) = ((int)_in.Handle, (int)_out.Handle);
        int epoll = EpollCalls.epoll_create1(0);
        byte* events = stackalloc byte[16];
        byte* buffer = stackalloc byte[MaxDatagram];
        *(uint*)events = EpollCalls.Readable;
        _ = EpollCalls.epoll_ctl(epoll, EpollCalls.Add, from, events);
        while (Volatile.Read(ref _isEnding) == 0)
        {
            if (EpollCalls.epoll_wait(epoll, events, 1, 50) <= 0)
                continue;
            long count = (long)EpollCalls.recv(from, buffer, new UIntPtr(MaxDatagram), EpollCalls.DoNotWait);
            if (count > 0)
                _ = EpollCalls.send(to, buffer, new UIntPtr((ulong)count), 0);
        }

        _ = EpollCalls.close(epoll);
    }
}
