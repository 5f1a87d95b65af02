namespace Rabit.Mavlink;

/// <summary>What a frame reader has seen since it was made. A copy, taken at one moment.</summary>
public readonly struct MavlinkReaderCounters
{
    /// <summary>Bytes received, the pending ones included.</summary>
    public long Bytes { get; internal init; }

    /// <summary>Bytes that belong to no frame: noise, and what is left of damaged frames.</summary>
    public long SkippedBytes { get; internal init; }

    /// <summary>Frames delivered whose id is known and whose checksum is right.</summary>
    public long Frames { get; internal init; }

    /// <summary>Frames delivered whose id is not in the dialect.</summary>
    public long UnknownFrames { get; internal init; }

    /// <summary>Whole frames dropped because of an incompatibility flag that is not known here.</summary>
    public long IncompatibleFrames { get; internal init; }

    /// <summary>
    /// Headers of a known id whose checksum was wrong. One damaged frame may count more than once, and noise that looks
    /// like a header counts too: a figure for the quality of a link, not a number of lost frames.
    /// </summary>
    public long BadChecksums { get; internal init; }

    /// <summary>
    /// Headers of an unknown id that were rejected: a checked frame begins inside, or no frame is next to them. Like
    /// <see cref="BadChecksums"/>, no number of lost frames.
    /// </summary>
    public long RejectedUnknown { get; internal init; }

    /// <summary>
    /// Bytes of which a checksum was computed: the measure of a reader's work. About as many as <see cref="Bytes"/> on
    /// a good link, and never more than a few dozen times as many, whatever is received
    /// (docs/decisions/0003-frame-reader.md).
    /// </summary>
    public long ChecksumBytes { get; internal init; }
}
