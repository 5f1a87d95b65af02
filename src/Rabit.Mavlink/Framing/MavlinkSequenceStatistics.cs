namespace Rabit.Mavlink;

/// <summary>
/// Frames, gaps and disorder of one sender on one link, from its sequence numbers. A copy, taken at one moment.
/// </summary>
public readonly struct MavlinkSequenceStatistics
{
    internal MavlinkSequenceStatistics(
        byte systemId, byte componentId, byte lastSequence, long frames, long missing, long outOfOrder)
    {
        SystemId = systemId;
        ComponentId = componentId;
        LastSequence = lastSequence;
        Frames = frames;
        Missing = missing;
        OutOfOrder = outOfOrder;
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
    /// Sequence numbers that were jumped over: a step of n+1 instead of 1 adds n. Of more than 127 lost in a row the
    /// count is wrong, since the number has 8 bits, and a frame that arrives late after all is not taken off again: it
    /// is in <see cref="OutOfOrder"/>.
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
        return step is >= 1 and <= 128
            ? new MavlinkSequenceStatistics(SystemId, ComponentId, sequence, Frames + 1, Missing + step - 1, OutOfOrder)
            : new MavlinkSequenceStatistics(SystemId, ComponentId, LastSequence, Frames + 1, Missing, OutOfOrder + 1);
    }
}
