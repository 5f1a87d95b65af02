namespace Rabit.Mavlink;

/// <summary>What a frame reader has seen since it was made. A copy, taken at one moment.</summary>
public readonly struct MavlinkReaderCounters
{
    internal MavlinkReaderCounters(long bytes, long skippedBytes, long frames, long unknownFrames, long incompatibleFrames, long badChecksums)
    {
        Bytes = bytes;
        SkippedBytes = skippedBytes;
        Frames = frames;
        UnknownFrames = unknownFrames;
        IncompatibleFrames = incompatibleFrames;
        BadChecksums = badChecksums;
    }

    /// <summary>Bytes taken in, those that still wait to be judged included.</summary>
    public long Bytes { get; }

    /// <summary>Bytes that belong to no frame: noise, and what is left of damaged frames.</summary>
    public long SkippedBytes { get; }

    /// <summary>Frames delivered whose id is known and whose checksum is right.</summary>
    public long Frames { get; }

    /// <summary>Frames delivered whose id the dialect does not know.</summary>
    public long UnknownFrames { get; }

    /// <summary>Whole frames dropped because of an incompatibility flag that is not known here.</summary>
    public long IncompatibleFrames { get; }

    /// <summary>
    /// Places that looked like a frame of a known id, but the checksum was wrong. One damaged frame may count more than once,
    /// and noise that looks like a header counts too: a figure for the state of a link, not a number of lost frames.
    /// </summary>
    public long BadChecksums { get; }
}
