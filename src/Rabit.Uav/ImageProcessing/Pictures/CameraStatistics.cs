namespace Rabit.Uav.ImageProcessing;

/// <summary>What became of the pictures of an <see cref="ICamera"/> since it was made. A plain value.</summary>
public readonly record struct CameraStatistics
{
    /// <summary>Pictures delivered.</summary>
    public long Delivered { get; init; }

    /// <summary>
    /// Pictures that could not be read, have another size than the camera's, or a name without their time.
    /// </summary>
    public long Refused { get; init; }

    /// <summary>Pictures that were not decoded: a newer one had come, or more come than are wanted.</summary>
    public long Skipped { get; init; }

    /// <summary>Pictures lost because no buffer was free.</summary>
    public long WithoutBuffer { get; init; }

    /// <summary>
    /// Pictures whose time is known by their arrival alone, although the camera's program should report it.
    /// </summary>
    public long WithoutTime { get; init; }

    /// <summary>
    /// Where the time of its pictures comes from and how wrong it may be, one line, as of the last picture; null before
    /// the first of a camera that finds out by it, and where a camera does not report it.
    /// </summary>
    public string? TimeSource { get; init; }

    /// <summary>Pictures that were begun before the run, and were therefore not read.</summary>
    public long BeforeRun { get; init; }

    /// <summary>Pictures that appeared when a later one had already been delivered, and were not read.</summary>
    public long Late { get; init; }

    /// <summary>Pictures whose time is ahead of the clock, and that were not read.</summary>
    public long Ahead { get; init; }

    /// <summary>How often it was tried to open the camera again.</summary>
    public long Restarts { get; init; }

    /// <summary>What keeps it from giving pictures, one line; null while nothing does.</summary>
    public string? Fault { get; init; }

    /// <summary>What went wrong last, one line, also with one picture; null if nothing did.</summary>
    public string? LastFault { get; init; }
}
