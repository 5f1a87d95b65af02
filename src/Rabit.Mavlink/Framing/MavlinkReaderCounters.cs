namespace Rabit.Mavlink;

/// <summary>What a frame reader has seen since it was made. A copy, taken at one moment.</summary>
public readonly struct MavlinkReaderCounters
{
    /// <summary>Bytes taken in, those that still wait to be judged included.</summary>
    public long Bytes { get; internal init; }

    /// <summary>Bytes that belong to no frame: noise, and what is left of damaged frames.</summary>
    public long SkippedBytes { get; internal init; }

    /// <summary>Frames delivered whose id is known and whose checksum is right.</summary>
    public long Frames { get; internal init; }

    /// <summary>Frames delivered whose id the dialect does not know.</summary>
    public long UnknownFrames { get; internal init; }

    /// <summary>Whole frames dropped because of an incompatibility flag that is not known here.</summary>
    public long IncompatibleFrames { get; internal init; }

    /// <summary>
    /// Places that looked like a frame of a known id, but the checksum was wrong. One damaged frame may count more than once,
    /// and noise that looks like a header counts too: a figure for the state of a link, not a number of lost frames.
    /// </summary>
    public long BadChecksums { get; internal init; }

    /// <summary>Places that looked like a frame of an unknown id, but gave way to what is proved, or stood alone among noise. Like <see cref="BadChecksums"/>, no number of lost frames.</summary>
    public long RejectedUnknown { get; internal init; }

    /// <summary>
    /// Bytes put through the checksum: what the work of a reader grows with. About as many as <see cref="Bytes"/> on a sound link, and
    /// never more than a few dozen times as many, whatever is sent (docs/decisions/0003-frame-reader.md).
    /// </summary>
    public long ChecksumBytes { get; internal init; }
}
