using System;

namespace Rabit.Mavlink;

/// <summary>
/// Where a signing clock keeps its state, so that a restart does not go back: two places of 12 bytes each, that outlive
/// the process and the loss of power. They are written in turn, so that power that fails in the middle of a write costs
/// one of them only. Called on the thread that advances the clock, about every 30 s.
/// </summary>
public interface IMavlinkTimestampStore
{
    /// <summary>Reads a place.</summary>
    /// <param name="slot">0 or 1.</param>
    /// <param name="record">Room for the 12 bytes.</param>
    /// <returns>
    /// How many bytes were read; 0 where nothing was ever written, or it cannot be read. Damaged content is detected
    /// and not used.
    /// </returns>
    int Read(int slot, Span<byte> record);

    /// <summary>Writes a place, and returns when it is safe there.</summary>
    /// <param name="slot">0 or 1.</param>
    /// <param name="record">The 12 bytes.</param>
    /// <returns>Whether it was written; where not, the clock counts it and tries again.</returns>
    bool Write(int slot, ReadOnlySpan<byte> record);
}
