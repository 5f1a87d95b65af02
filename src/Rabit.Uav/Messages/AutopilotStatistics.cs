namespace Rabit.Uav.Messages;

/// <summary>What Autopilot Interface counted since the start. A plain value.</summary>
public struct AutopilotStatistics
{
    /// <summary>Frames that Communications handed over.</summary>
    public long Frames { get; set; }

    /// <summary>
    /// Those of them that came from other systems or components than the autopilot, or before it was known.
    /// </summary>
    public long FramesOfOthers { get; set; }

    /// <summary>Heartbeats of further autopilots, which are not the vehicle's.</summary>
    public long HeartbeatsOfOtherAutopilots { get; set; }

    /// <summary>
    /// Messages of the autopilot with values out of range (not a number, a latitude beyond the pole, ...), which were
    /// ignored.
    /// </summary>
    public long RefusedMessages { get; set; }

    /// <summary>How often the connection to the autopilot was lost.</summary>
    public long Losses { get; set; }

    /// <summary>How often the autopilot rebooted (its time since boot went down).</summary>
    public long Reboots { get; set; }

    /// <summary>One standard deviation of the times of poses, seconds; see PoseSample.</summary>
    public double PoseTimeErrorSeconds { get; set; }

    /// <summary>
    /// The shortest round trip of a request for the autopilot's time, seconds; 0 while none was answered.
    /// </summary>
    public double RoundTripSeconds { get; set; }

    /// <summary>Observations of the landing marker that were sent to the autopilot as LANDING_TARGET.</summary>
    public long LandingTargetsSent { get; set; }

    /// <summary>
    /// Observations of the landing marker that were not: no autopilot is connected or it is of another make, they are
    /// too old, the marker is not below the vehicle (ArduPilot), or the local position is not known (PX4).
    /// </summary>
    public long LandingTargetsNotSent { get; set; }

    /// <summary>The results of the requests for message rates.</summary>
    public RateRequestCounts RateRequests { get; set; }
}
