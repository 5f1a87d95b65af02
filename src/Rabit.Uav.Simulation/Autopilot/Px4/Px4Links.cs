using System;

namespace Rabit.Uav.Simulation;

/// <summary>The links of the autopilot: what is streamed over each, and who is connected.</summary>
internal sealed class Px4Links
{
    // PX4 takes a heartbeat for lost 1.4 s after the last one; COM_DL_LOSS_T counts from there (recorded: 6.3 to 6.4 s
    // with COM_DL_LOSS_T 5).
    private static readonly TimeSpan HeartbeatTimeout = TimeSpan.OfSeconds(1.4);

    private readonly Px4Streams[] _streams;
    private readonly TimeSpan?[] _groundReceived;

    public Px4Links(int count)
    {
        _streams = new Px4Streams[count];
        for (int link = 0; link < count; link++)
            _streams[link] = new Px4Streams();
        _groundReceived = new TimeSpan?[count];
    }

    public int Count => _streams.Length;

    public TimeSpan Now { get; set; }

    /// <summary>Whether a ground station was ever connected, over any link.</summary>
    public bool HadGroundStation { get; private set; }

    public Px4Streams Streams(int link) => _streams[link];

    /// <summary>A heartbeat with MAV_TYPE_GCS was received.</summary>
    public void ReceiveGroundHeartbeat(int link)
    {
        _groundReceived[link] = Now;
        HadGroundStation = true;
    }

    public bool HasGroundStation(int link)
        => _groundReceived[link] is { } received && Now - received <= HeartbeatTimeout;

    /// <summary>Whether no link has had a ground station for a time.</summary>
    public bool IsGroundStationLost(double seconds)
    {
        foreach (TimeSpan? received in _groundReceived)
        {
            if (received is { } last && Now - last <= HeartbeatTimeout + TimeSpan.OfSeconds(seconds))
                return false;
        }

        return true;
    }
}
