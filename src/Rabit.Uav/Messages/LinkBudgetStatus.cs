namespace Rabit.Uav.Messages;

/// <summary>How a link with a budget sends. A plain value.</summary>
public struct LinkBudgetStatus
{
    /// <summary>Bytes per second that it may send now; 0 where the link has no budget.</summary>
    public double BytesPerSecond { get; set; }

    /// <summary>
    /// How long a frame took over the link and back, last; 0 where that is not measured, or was not answered yet.
    /// </summary>
    public double RoundTripSeconds { get; set; }

    /// <summary>Bytes that it sent since the start.</summary>
    public long BytesOut { get; set; }

    /// <summary>Frames that wait for their turn.</summary>
    public int Waiting { get; set; }

    /// <summary>The smallest part of its asked rate that a piece of state gets, 0 to 1.</summary>
    public double GrantedShare { get; set; }

    /// <summary>Heartbeats and emergencies.</summary>
    public SendCounters Urgent { get; set; }

    /// <summary>Commands, acknowledgements, set-points.</summary>
    public SendCounters Commands { get; set; }

    /// <summary>Messages between vehicles, texts, events.</summary>
    public SendCounters Coordination { get; set; }

    /// <summary>State, of which the latest value counts.</summary>
    public SendCounters State { get; set; }

    /// <summary>Parameters, missions, files, logs, and what is not known.</summary>
    public SendCounters Bulk { get; set; }
}
