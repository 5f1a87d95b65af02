namespace Rabit.Uav.Messages;

/// <summary>The operator's decision on a track. A plain value.</summary>
public struct TrackDecision
{
    /// <summary>The track.</summary>
    public int TrackId { get; set; }

    /// <summary>What the operator said; the newest counts.</summary>
    public TargetDecision Decision { get; set; }
}
