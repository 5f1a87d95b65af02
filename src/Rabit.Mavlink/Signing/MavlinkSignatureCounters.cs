namespace Rabit.Mavlink;

/// <summary>The results of a verifier since it was made. A copy, taken at one moment.</summary>
public readonly struct MavlinkSignatureCounters
{
    /// <summary>Accepted: correctly signed and in time.</summary>
    public long Valid { get; internal init; }

    /// <summary>Accepted without a signature, by the rule for those.</summary>
    public long UnsignedAllowed { get; internal init; }

    /// <summary>Rejected: no signature.</summary>
    public long NotSigned { get; internal init; }

    /// <summary>Rejected: another key, or changed on the way. Many of them: a wrong key, or an attack.</summary>
    public long BadSignatures { get; internal init; }

    /// <summary>Rejected: replayed, duplicated or overtaken.</summary>
    public long OldTimestamps { get; internal init; }

    /// <summary>Rejected: the first of a stream, more than a minute behind.</summary>
    public long NewStreamsTooOld { get; internal init; }

    /// <summary>Rejected: the first of a stream, and no room for another.</summary>
    public long TooManyStreams { get; internal init; }

    /// <summary>All that were rejected.</summary>
    public long Rejected => NotSigned + BadSignatures + OldTimestamps + NewStreamsTooOld + TooManyStreams;

    /// <summary>The same with one result added: for counting by link or by sender.</summary>
    /// <param name="result">What <see cref="MavlinkVerifier.Verify"/> returned.</param>
    /// <returns>The counters.</returns>
    public MavlinkSignatureCounters With(MavlinkSignatureResult result) => result switch
    {
        MavlinkSignatureResult.Valid or MavlinkSignatureResult.ValidNewStream => this with { Valid = Valid + 1 },
        MavlinkSignatureResult.UnsignedAllowed => this with { UnsignedAllowed = UnsignedAllowed + 1 },
        MavlinkSignatureResult.NotSigned => this with { NotSigned = NotSigned + 1 },
        MavlinkSignatureResult.BadSignature => this with { BadSignatures = BadSignatures + 1 },
        MavlinkSignatureResult.OldTimestamp => this with { OldTimestamps = OldTimestamps + 1 },
        MavlinkSignatureResult.NewStreamTooOld => this with { NewStreamsTooOld = NewStreamsTooOld + 1 },
        _ => this with { TooManyStreams = TooManyStreams + 1 },
    };
}
