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

    /// <summary>All that were rejected.</summary>
    public long Rejected => NotSigned + BadSignatures + OldTimestamps + NewStreamsTooOld + TooManyStreams;

    /// <summary>The same with one verdict more: for those who count by link or by sender.</summary>
    /// <param name="verdict">What <see cref="MavlinkVerifier.Verify"/> gave.</param>
    /// <returns>The counters.</returns>
    public MavlinkSignatureCounters With(MavlinkSignatureVerdict verdict) => verdict switch
    {
        MavlinkSignatureVerdict.Valid or MavlinkSignatureVerdict.ValidNewStream => this with { Valid = Valid + 1 },
        MavlinkSignatureVerdict.UnsignedAllowed => this with { UnsignedAllowed = UnsignedAllowed + 1 },
        MavlinkSignatureVerdict.NotSigned => this with { NotSigned = NotSigned + 1 },
        MavlinkSignatureVerdict.BadSignature => this with { BadSignatures = BadSignatures + 1 },
        MavlinkSignatureVerdict.OldTimestamp => this with { OldTimestamps = OldTimestamps + 1 },
        MavlinkSignatureVerdict.NewStreamTooOld => this with { NewStreamsTooOld = NewStreamsTooOld + 1 },
        _ => this with { TooManyStreams = TooManyStreams + 1 },
    };
}
