namespace Rabit.Mavlink;

/// <summary>What a verifier has decided since it was made. A copy, taken at one moment.</summary>
public readonly struct MavlinkSignatureCounters
{
    /// <summary>Accepted: signed rightly and in time.</summary>
    public long Valid { get; internal init; }

    /// <summary>Accepted without a signature, by the rule for those.</summary>
    public long UnsignedAllowed { get; internal init; }

    /// <summary>Rejected: no signature.</summary>
    public long NotSigned { get; internal init; }

    /// <summary>Rejected: another key, or changed on the way. Many of them: somebody has the wrong key, or tries.</summary>
    public long BadSignatures { get; internal init; }

    /// <summary>Rejected: replayed, doubled or overtaken.</summary>
    public long OldTimestamps { get; internal init; }

    /// <summary>Rejected: the first of a stream, more than a minute behind.</summary>
    public long NewStreamsTooOld { get; internal init; }

    /// <summary>Rejected: the first of a stream, and no room for another.</summary>
    public long TooManyStreams { get; internal init; }
}
