namespace Rabit.Mavlink;

/// <summary>
/// The result of the validation of a signature by <see cref="MavlinkVerifier.Verify"/>.
/// <see cref="MavlinkSignatureResultExtensions.IsAccepted"/> sums it up.
/// </summary>
public enum MavlinkSignatureResult
{
    /// <summary>Rejected: not signed, and not accepted by the rule for unsigned frames.</summary>
    NotSigned,

    /// <summary>Rejected: the signature is not that of our key over these bytes.</summary>
    BadSignature,

    /// <summary>
    /// Rejected: correctly signed, but not later than the last frame of its stream: replayed, duplicated or overtaken.
    /// </summary>
    OldTimestamp,

    /// <summary>
    /// Rejected: correctly signed and the first of its stream, but more than a minute behind our signing clock.
    /// </summary>
    NewStreamTooOld,

    /// <summary>
    /// Rejected: correctly signed and the first of its stream, but there is no room to remember another stream.
    /// </summary>
    TooManyStreams,

    /// <summary>Accepted: correctly signed, and later than the last frame of its stream.</summary>
    Valid,

    /// <summary>Accepted: correctly signed, the first of its stream, and not too old.</summary>
    ValidNewStream,

    /// <summary>
    /// Accepted: not signed, but accepted by the rule for unsigned frames. Any sender may have sent it.
    /// </summary>
    UnsignedAllowed,
}
