using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Threading;
using Rabit.Mavlink;
using Rabit.Tests.Shared;
using Rabit.Uav.Tests;
using Rabit.Uav.Tests.Communications;

namespace UavConsole.Tests;

/// <summary>
/// Plays a recorded autopilot to a UDP port at its own pace, and keeps what comes back: a stand-in for the aircraft.
/// </summary>
internal sealed class LiveFlight : IDisposable
{
    private readonly Socket _socket = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
    private readonly IPEndPoint _console;
    private readonly Thread _listener;
    private readonly object _gate = new();
    private readonly List<MavlinkFrame> _received = [];

    public LiveFlight(int port)
    {
        _console = new IPEndPoint(IPAddress.Loopback, port);
        _socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        _listener = new Thread(Listen) { IsBackground = true, Name = "live flight" };
        _listener.Start();
    }

    public long Sent { get; private set; }

    public IReadOnlyList<MavlinkFrame> Received
    {
        get
        {
            lock (_gate)
                return _received.ToArray();
        }
    }

    /// <summary>Sends the frames of the autopilot alone (1/1), each when it is due.</summary>
    public void Play(string flight, TimeSpan length)
    {
        using FileStream file = File.OpenRead(TestData.PathOf(flight + ".tlog"));
        var log = new TlogReader(file, MavlinkDialect.All);
        using var pace = new ManualResetEvent(false);
        Stopwatch clock = Stopwatch.StartNew();
        var buffer = new byte[MavlinkFrame.MaxWireLength];
        long? first = null;
        while (log.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            first ??= record.TimeMicroseconds;
            TimeSpan due = TimeSpan.FromTicks((record.TimeMicroseconds - first.Value) * 10);
            if (due > length)
                return;
            if (frame.SystemId != 1 || frame.ComponentId != 1)
                continue;
            if (due - clock.Elapsed is { Ticks: > 0 } early)
                pace.WaitOne(early);
            _socket.SendTo(buffer, 0, frame.WriteTo(buffer), SocketFlags.None, _console);
            Sent++;
        }
    }

    public void Send(byte[] bytes) => _socket.SendTo(bytes, _console);

    /// <summary>Waits until a frame has come back.</summary>
    public bool WaitFor(Func<MavlinkFrame, bool> isMeant)
    {
        lock (_gate)
        {
            var timeout = new TestTimeout();
            while (!_received.Any(isMeant))
            {
                if (!timeout.TryWait(_gate))
                    return false;
            }

            return true;
        }
    }

    public void Dispose()
    {
        _socket.Dispose();
        _listener.Join(TimeSpan.FromSeconds(5));
    }

    private void Listen()
    {
        var datagram = new byte[2048];
        try
        {
            while (true)
            {
                int count = _socket.Receive(datagram);
                List<MavlinkFrame> frames = Frames.Read(datagram.Take(count).ToArray());
                lock (_gate)
                {
                    _received.AddRange(frames);
                    Monitor.PulseAll(_gate);
                }
            }
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            // Disposing the socket is what ends this thread.
        }
    }
}
