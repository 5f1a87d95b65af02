using System;
using System.Buffers.Binary;
using System.Net;
using System.Net.Sockets;
using System.Threading;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Latency.Forwarding;

/// <summary>
/// Sends frames of 44 bytes to a port of 127.0.0.1, one in each datagram, and takes what comes back at another: how
/// many, how late, and what that cost beside the two threads here.
/// </summary>
internal sealed class FrameFlow : IDisposable
{
    // Fewer than any of the queues on the way holds, so that none is lost.
    private const int Window = 32;
    private const int TimeOffset = 10;   // of the first field, in a frame of MAVLink 2

    private readonly Socket _from = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
    private readonly Socket _to = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
    private readonly byte[] _frame = new byte[MavlinkFrame.MaxWireLength];
    private readonly LatencyHistogram _latencies = new();
    private readonly Thread _thread;
    private byte _sequence;
    private long _received;
    private long _receiverTime;
    private int _isEnding;

    public FrameFlow()
    {
        _to.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        _to.ReceiveTimeout = 50;
        _thread = new Thread(Receive) { IsBackground = true };
        _thread.Start();
    }

    /// <summary>Where frames are to come back.</summary>
    public int Target => ((IPEndPoint)_to.LocalEndPoint!).Port;

    public LatencyHistogram Latencies => _latencies;

    /// <summary>As many as there is room for.</summary>
    /// <returns>Frames in one second of a core's time, that of the two threads here not counted.</returns>
    public double Flood(int port, double seconds)
    {
        _from.Connect(new IPEndPoint(IPAddress.Loopback, port));
        Start(out long others, out long first);
        long end = MonotonicClock.Now + (long)(seconds * 1e9);
        long sent = first;
        while (MonotonicClock.Now < end)
        {
            long deadline = MonotonicClock.Now + 20_000_000;
            while (sent - Interlocked.Read(ref _received) >= Window && MonotonicClock.Now < deadline)
                Thread.Yield();
            if (sent - Interlocked.Read(ref _received) >= Window)
                sent = Interlocked.Read(ref _received);   // lost ones
            Send();
            sent++;
        }

        MonotonicClock.SleepMilliseconds(100);
        return (Interlocked.Read(ref _received) - first) / ((OthersTime - others) / 1e9);
    }

    /// <summary>So many each second, evenly.</summary>
    /// <returns>Per cent of a core, that of the two threads here not counted.</returns>
    public double Pace(int port, double perSecond, double seconds)
    {
        _from.Connect(new IPEndPoint(IPAddress.Loopback, port));
        Start(out long others, out long first);
        _latencies.Clear();
        long start = MonotonicClock.Now;
        long count = (long)(perSecond * seconds);
        for (long n = 0; n < count; n++)
        {
            MonotonicClock.SleepUntil(start + (long)(n * 1e9 / perSecond));
            Send();
        }

        MonotonicClock.SleepMilliseconds(100);
        double load = 100.0 * (OthersTime - others) / (MonotonicClock.Now - start);

        // Some are lost where the machine stands still for longer than the queues last.
        if (Interlocked.Read(ref _received) - first < count / 2)
            throw new InvalidOperationException(
                $"Of {count} frames only {Interlocked.Read(ref _received) - first} came back.");
        return load;
    }

    public void Dispose()
    {
        Volatile.Write(ref _isEnding, 1);
        _thread.Join();
        _from.Dispose();
        _to.Dispose();
    }

    private long OthersTime
        => MonotonicClock.CpuTime - MonotonicClock.ThreadTime - Interlocked.Read(ref _receiverTime);

    private void Start(out long others, out long received)
    {
        MonotonicClock.SleepMilliseconds(200);   // what the start costs is not what is asked
        others = OthersTime;
        received = Interlocked.Read(ref _received);
    }

    private void Send()
    {
        MavlinkFrame frame = MavlinkFrame.Create(
            new VisionPositionEstimate { Usec = (ulong)MonotonicClock.Now, X = 1, Y = 2, Z = 3, Yaw = 4 }, 9, 1,
            _sequence++);
        int length = frame.WriteTo(_frame);
        _from.Send(_frame, length, SocketFlags.None);
    }

    private void Receive()
    {
        var buffer = new byte[2048];
        while (Volatile.Read(ref _isEnding) == 0)
        {
            int count;
            try
            {
                count = _to.Receive(buffer);
            }
            catch (SocketException)
            {
                continue;   // nothing for a while
            }

            long now = MonotonicClock.Now;
            if (count > TimeOffset + sizeof(long))
                _latencies.Record(now - BinaryPrimitives.ReadInt64LittleEndian(buffer.AsSpan(TimeOffset)));
            Interlocked.Exchange(ref _receiverTime, MonotonicClock.ThreadTime);
            Interlocked.Increment(ref _received);
        }
    }
}
