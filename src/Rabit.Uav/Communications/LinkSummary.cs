using System.Collections.Generic;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>What came in over one link since the start, counted where its frames are made. Immutable.</summary>
public sealed class LinkSummary
{
    internal LinkSummary(
        string url, long frames, IReadOnlyList<FrameCount> counts, IReadOnlyList<MavlinkSequenceStatistics> sources,
        long bytesLost, long? firstDamageOffset, long incompatibleFrames, long framesNotListed, long mendedFrames = 0,
        IReadOnlyDictionary<int, long>? refusedFrames = null)
    {
        Url = url;
        Frames = frames;
        Counts = counts;
        Sources = sources;
        BytesLost = bytesLost;
        FirstDamageOffset = firstDamageOffset;
        IncompatibleFrames = incompatibleFrames;
        FramesNotListed = framesNotListed;
        MendedFrames = mendedFrames;
        RefusedFrames = refusedFrames ?? new Dictionary<int, long>();
    }

    /// <summary>What the link was opened by.</summary>
    public string Url { get; }

    /// <summary>All frames.</summary>
    public long Frames { get; }

    /// <summary>The frames by message and source, ordered by source, then by message id.</summary>
    public IReadOnlyList<FrameCount> Counts { get; }

    /// <summary>
    /// Frames of so many kinds that <see cref="Counts"/> has no room for them; they are in <see cref="Frames"/>.
    /// </summary>
    public long FramesNotListed { get; }

    /// <summary>Frames and gaps of each source.</summary>
    public IReadOnlyList<MavlinkSequenceStatistics> Sources { get; }

    /// <summary>Bytes that belong to no frame or record.</summary>
    public long BytesLost { get; }

    /// <summary>
    /// Intact frames that had to be left out, because they have an incompatibility flag that is not known here. They
    /// are in no other figure.
    /// </summary>
    public long IncompatibleFrames { get; }

    /// <summary>
    /// Frames of a recorded log whose trailing zeros the recorder had cut off, and that are as they were sent again.
    /// They are among <see cref="Frames"/>.
    /// </summary>
    public long MendedFrames { get; }

    /// <summary>
    /// Whole records of a recorded log whose frame was refused, by message id: the message of that id is another one.
    /// Their bytes are in <see cref="BytesLost"/>.
    /// </summary>
    public IReadOnlyDictionary<int, long> RefusedFrames { get; }

    /// <summary>File offset of the first damage of a recorded log; null where there is none.</summary>
    public long? FirstDamageOffset { get; }
}
