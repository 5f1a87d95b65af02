namespace Rabit.Mavlink;

/// <summary>What a verifier thinks of a frame. <see cref="MavlinkSignatureVerdicts.IsAccepted"/> sums it up.</summary>
public enum MavlinkSignatureVerdict
{
    /// <summary>Rejected: not signed, and no rule lets it through.</summary>
    NotSigned,

    /// <summary>Rejected: the signature is not that of our key over these bytes.</summary>
    BadSignature,

    /// <summary>Rejected: rightly signed, but not later than the last frame of its stream: replayed, doubled or overtaken.</summary>
    OldTimestamp,

    /// <summary>Rejected: rightly signed and the first of its stream, but more than a minute behind our signing clock.</summary>
    NewStreamTooOld,

    /// <summary>Rejected: rightly signed and the first of its stream, but there is no room to remember another stream.</summary>
    TooManyStreams,

    /// <summary>Accepted: rightly signed, and later than the last frame of its stream.</summary>
    Valid,

    /// <summary>Accepted: rightly signed, the first of its stream, and not too old.</summary>
    ValidNewStream,

    /// <summary>Accepted: not signed, but the rule for unsigned frames lets it through. Anybody may have sent it.</summary>
    UnsignedAllowed,
}
