namespace Rabit.Uav.Simulation;

/// <summary>What one station of a simulated radio sent, and what became of it. A plain value.</summary>
/// <remarks>Delivered and lost count each receiver: a frame that two others would receive counts twice.</remarks>
public struct RadioCounters
{
    /// <summary>Frames that it sent.</summary>
    public long FramesSent { get; set; }

    /// <summary>Bytes of them.</summary>
    public long BytesSent { get; set; }

    /// <summary>Frames that could not be sent: the radio was busy for more than a second.</summary>
    public long FramesRefused { get; set; }

    /// <summary>Frames that another station received, duplicates included.</summary>
    public long Delivered { get; set; }

    /// <summary>Frames that arrived at another station a second time.</summary>
    public long Duplicated { get; set; }

    /// <summary>Frames that were lost at random, or over the distance.</summary>
    public long LostAtRandom { get; set; }

    /// <summary>Frames that were lost in a burst.</summary>
    public long LostInBursts { get; set; }

    /// <summary>Frames that were lost since a partition or a radio that is dead or off separates the two.</summary>
    public long LostByPartition { get; set; }
}
