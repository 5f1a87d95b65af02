using System;
using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Uav.Links;

namespace Rabit.Uav.Communications;

/// <summary>What Communications is made of. Read once, when the manager is made.</summary>
public sealed class CommunicationsOptions
{
    /// <summary>Live links, open. They stay the caller's to dispose, after the run.</summary>
    public IReadOnlyList<IByteLink> Links { get; set; } = Array.Empty<IByteLink>();

    /// <summary>Recorded logs that are played, open. They are numbered behind the live links, and stay the caller's to dispose.</summary>
    public IReadOnlyList<RecordedFile> RecordedFiles { get; set; } = Array.Empty<RecordedFile>();

    /// <summary>How many frames of one link may wait to be handled.</summary>
    /// <value>The default is 256: a second of the busiest autopilot stream fits twice over.</value>
    public int FramesWaitingIn { get; set; } = 256;

    /// <summary>How many frames may wait to be written to one link; the oldest makes room.</summary>
    /// <value>The default is 256.</value>
    public int FramesWaitingOut { get; set; } = 256;

    /// <summary>After what time without a frame a link is called silent.</summary>
    /// <value>The default is 5 s: four to five heartbeats (MAVLink guide, "Heartbeat/Connection Protocol").</value>
    public TimeSpan SilentAfter { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>Whether the end of all links stops the run: for a replay, which then is over.</summary>
    /// <value>The default is false.</value>
    public bool StopsWhenAllLinksEnd { get; set; }

    internal int Count => Links.Count + RecordedFiles.Count;

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal CommunicationsOptions Validate(string parameter)
    {
        var faults = new List<string>();
        if (Links is null || RecordedFiles is null)
            throw new ArgumentException("Communications: the lists of links and recorded files may be empty, but not null.", parameter);
        if (Count == 0)
            faults.Add("there is no link");
        if (Count > MavlinkRouter.MaximumLinks)
            faults.Add($"there are {Count} links; at most {MavlinkRouter.MaximumLinks} are possible");
        if (FramesWaitingIn < 1)
            faults.Add($"{nameof(FramesWaitingIn)} is {FramesWaitingIn}; it must be at least 1");
        if (FramesWaitingOut < 1)
            faults.Add($"{nameof(FramesWaitingOut)} is {FramesWaitingOut}; it must be at least 1");
        if (SilentAfter <= TimeSpan.Zero)
            faults.Add($"{nameof(SilentAfter)} is {SilentAfter}; it must be above zero");
        if (faults.Count > 0)
            throw new ArgumentException("Communications: " + string.Join("; ", faults) + ".", parameter);
        return (CommunicationsOptions)MemberwiseClone();
    }
}
