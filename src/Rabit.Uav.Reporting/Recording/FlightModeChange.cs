using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// A heartbeat of the vehicle that differs from the one before in its mode, its flags (armed among them) or its
/// system status; also the first heartbeat. A plain value.
/// </summary>
public readonly struct FlightModeChange
{
    internal FlightModeChange(
        in FlightPlace place, uint customMode, MavModeFlag baseMode, MavState systemStatus, string mode)
    {
        Link = place.Link;
        Record = place.Record;
        UtcMicroseconds = place.UtcMicroseconds;
        CustomMode = customMode;
        BaseMode = baseMode;
        SystemStatus = systemStatus;
        Mode = mode;
    }

    /// <summary>Number of the link that it came from, from 0.</summary>
    public int Link { get; }

    /// <summary>Which frame of its link it is, from 0; in a recorded log the number of its record.</summary>
    public long Record { get; }

    /// <summary>When it came in, microseconds since 1970 UTC; for a recorded log the stamp of its record.</summary>
    public long UtcMicroseconds { get; }

    /// <summary>The flight mode as the autopilot sends it.</summary>
    public uint CustomMode { get; }

    /// <summary>The mode flags as the autopilot sends them.</summary>
    public MavModeFlag BaseMode { get; }

    /// <summary>The autopilot's own view of its state.</summary>
    public MavState SystemStatus { get; }

    /// <summary>The flight mode by the autopilot's own name.</summary>
    public string Mode { get; }

    /// <summary>Whether the motors may turn.</summary>
    public bool IsArmed => (BaseMode & MavModeFlag.SafetyArmed) != 0;
}
