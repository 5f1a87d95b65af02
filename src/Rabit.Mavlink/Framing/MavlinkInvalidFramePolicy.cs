namespace Rabit.Mavlink;

/// <summary>
/// Where a <see cref="MavlinkFrameReader"/> continues after an invalid frame: bytes that begin like a frame, but whose
/// checksum or header is wrong. The resynchronisation itself is in the reader.
/// </summary>
public enum MavlinkInvalidFramePolicy
{
    /// <summary>
    /// At the next byte: no intact frame is lost, but the payload of a damaged frame is searched for frames.
    /// </summary>
    NextByte,

    /// <summary>
    /// Behind the length that the header states: the payload of a damaged frame is never searched for frames. For links
    /// where frames carry frames (TUNNEL, ENCAPSULATED_DATA, file transfer) that others may have written. A false
    /// header costs up to 280 bytes, and the frames in them.
    /// </summary>
    SkipFrame,
}
