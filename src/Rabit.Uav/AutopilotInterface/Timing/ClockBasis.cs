namespace Rabit.Uav.AutopilotInterface;

/// <summary>By what the autopilot's clock is mapped to ours.</summary>
internal enum ClockBasis
{
    /// <summary>Nothing came yet.</summary>
    None,

    /// <summary>By when its messages come in.</summary>
    Arrival,

    /// <summary>By its answers to TIMESYNC.</summary>
    Timesync,
}
