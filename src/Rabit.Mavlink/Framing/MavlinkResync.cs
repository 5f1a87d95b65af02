namespace Rabit.Mavlink;

/// <summary>Where a reader goes on after bytes that looked like a frame, but are none.</summary>
public enum MavlinkResync
{
    /// <summary>At the next byte: no intact frame is lost, but a frame that carries frames is searched for them when it is damaged.</summary>
    NextByte,

    /// <summary>
    /// Behind the bytes that the header claims: what lies inside a damaged frame is never taken for a frame. For links where frames carry frames
    /// (TUNNEL, ENCAPSULATED_DATA, file transfer) that others may have written. A false header costs up to 280 bytes, and the frames in them.
    /// </summary>
    SkipFrame,
}
