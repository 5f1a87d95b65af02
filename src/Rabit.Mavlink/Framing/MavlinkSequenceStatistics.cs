namespace Rabit.Mavlink;

/// <summary>
/// Frames, gaps and disorder of one sender on one link, from its sequence numbers. A copy, taken at one moment.
/// </summary>
public readonly struct MavlinkSequenceStatistics
{
    // How far back a late frame is still taken off what is missing: links that reorder do so within a few frames.
    private const int Window = 64;

    // Bit n: the number n before the newest one has arrived, or is older than the first.
    private readonly ulong _arrived;

    internal MavlinkSequenceStatistics(byte systemId, byte componentId, byte firstSequence)
        : this(systemId, componentId, firstSequence, frames: 1, missing: 0, outOfOrder: 0, ulong.MaxValue)
    {
    }

    private MavlinkSequenceStatistics(
        byte systemId, byte componentId, byte lastSequence, long frames, long missing, long outOfOrder, ulong arrived)
    {
        SystemId = systemId;
        ComponentId = componentId;
        LastSequence = lastSequence;
        Frames = frames;
        Missing = missing;
        OutOfOrder = outOfOrder;
        _arrived = arrived;
    }

    /// <summary>System id of the sender.</summary>
    public byte SystemId { get; }

    /// <summary>Component id of the sender.</summary>
    public byte ComponentId { get; }

    /// <summary>The newest sequence number.</summary>
    public byte LastSequence { get; }

    /// <summary>Frames that arrived.</summary>
    public long Frames { get; }

    /// <summary>
    /// Sequence numbers that were jumped over and did not arrive since: a step of n+1 instead of 1 adds n, one of them
    /// that arrives late, within 64 numbers, takes one off. Of more than 127 lost in a row the count is wrong, since
    /// the number has 8 bits.
    /// </summary>
    public long Missing { get; }

    /// <summary>
    /// Frames whose number was not ahead of the newest one: late, or sent twice, or the sender restarted.
    /// </summary>
    public long OutOfOrder { get; }

    internal MavlinkSequenceStatistics Next(byte sequence)
    {
        // Ahead by 1 to 128 is a step forward, anything else is behind: the shorter way round the circle of 256.
        int step = (byte)(sequence - LastSequence);
        if (step is >= 1 and <= 128)
        {
            ulong arrived = (step < Window ? _arrived << step : 0) | 1;
            return new MavlinkSequenceStatistics(
                SystemId, ComponentId, sequence, Frames + 1, Missing + step - 1, OutOfOrder, arrived);
        }

        int back = (byte)(LastSequence - sequence);
        bool wasMissing = back < Window && (_arrived & (1UL << back)) == 0;
        return new MavlinkSequenceStatistics(
            SystemId, ComponentId, LastSequence, Frames + 1, wasMissing ? Missing - 1 : Missing, OutOfOrder + 1,
            wasMissing ? _arrived | (1UL << back) : _arrived);
    }
}
