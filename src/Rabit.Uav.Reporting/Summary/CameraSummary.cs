using System;
using Rabit.Uav.ImageProcessing;

namespace Rabit.Uav.Reporting;

/// <summary>What a camera delivered in a run. Immutable.</summary>
public sealed class CameraSummary
{
    /// <summary>Copies the counts of a camera.</summary>
    /// <param name="camera">After the run.</param>
    public CameraSummary(ICamera camera)
    {
        if (camera is null)
            throw new ArgumentNullException(nameof(camera));
        CameraStatistics counts = camera.Statistics;
        Name = camera.Name;
        Delivered = counts.Delivered;
        BeforeRun = counts.BeforeRun;
        Late = counts.Late;
        Ahead = counts.Ahead;
        Refused = counts.Refused;
        Skipped = counts.Skipped;
        WithoutBuffer = counts.WithoutBuffer;
        WithoutTime = counts.WithoutTime;
        TimeSource = counts.TimeSource;
        Restarts = counts.Restarts;
        LastRefusal = counts.LastFault;
    }

    /// <summary>What it is: "folder", the name of a program or of a device.</summary>
    public string Name { get; }

    /// <summary>Pictures that were delivered.</summary>
    public long Delivered { get; }

    /// <summary>Pictures that were not read, since they are older than the run.</summary>
    public long BeforeRun { get; }

    /// <summary>Pictures that were not read, since they came after a later one.</summary>
    public long Late { get; }

    /// <summary>Pictures that were not read, since their time is ahead of the clock.</summary>
    public long Ahead { get; }

    /// <summary>Pictures that were refused: damaged, of another size, or with a name without its time.</summary>
    public long Refused { get; }

    /// <summary>
    /// Pictures that were not decoded, since a newer one had come, or more came than were wanted.
    /// </summary>
    public long Skipped { get; }

    /// <summary>Pictures that were lost, since no buffer was free.</summary>
    public long WithoutBuffer { get; }

    /// <summary>
    /// Pictures whose time is known by their arrival alone, although the camera's program should report it.
    /// </summary>
    public long WithoutTime { get; }

    /// <summary>
    /// Where the time of its pictures comes from, with its standard deviation, as of the last one; null if it is not
    /// known.
    /// </summary>
    public string? TimeSource { get; }

    /// <summary>How often it was tried to open the camera again.</summary>
    public long Restarts { get; }

    /// <summary>
    /// Why the last refused picture was refused, or what was wrong with the camera after that; null without.
    /// </summary>
    public string? LastRefusal { get; }
}
