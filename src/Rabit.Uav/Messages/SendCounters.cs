namespace Rabit.Uav.Messages;

/// <summary>What became of the frames of one class on a link with a budget, since the start. A plain value.</summary>
public struct SendCounters
{
    /// <summary>Frames that went out.</summary>
    public long Sent { get; set; }

    /// <summary>Frames that were dropped since a newer one said the same, which is no loss.</summary>
    public long Replaced { get; set; }

    /// <summary>Frames that were dropped since they had waited too long.</summary>
    public long Expired { get; set; }

    /// <summary>Frames that were dropped since too many waited.</summary>
    public long Full { get; set; }
}
