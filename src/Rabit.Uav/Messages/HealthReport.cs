namespace Rabit.Uav.Messages;

/// <summary>What Health Monitoring found, at least once a second. A plain value.</summary>
public struct HealthReport
{
    /// <summary>The worst of all reasons.</summary>
    public HealthLevel Level { get; set; }

    /// <summary>What is wrong.</summary>
    public HealthReasons Reasons { get; set; }

    /// <summary>The same for people, with names and figures; null when nothing is wrong.</summary>
    public string? Text { get; set; }

    /// <summary>What Mission Control is asked to do about it.</summary>
    public HealthAdvice Advice { get; set; }

    /// <summary>What led to the advice, for people, also when it is over; null while there is no advice.</summary>
    public string? AdviceText { get; set; }

    /// <summary>Whether our own heartbeat goes out: only while every manager works.</summary>
    public bool SendsHeartbeat { get; set; }

    /// <summary>Heartbeats of ours that were handed to Communications.</summary>
    public long HeartbeatsSent { get; set; }
}
