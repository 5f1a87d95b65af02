namespace Rabit.Uav.Messages;

/// <summary>
/// How far the times of the pictures are off those of the poses, as the passes over the same targets show it. A plain
/// value.
/// </summary>
public struct CameraClockEstimate
{
    /// <summary>
    /// How much later the pictures' times are than those of the poses, seconds: the error of the camera's clock, less
    /// what the times of the poses are late by. 0 while it is not known.
    /// </summary>
    public double OffsetSeconds { get; set; }

    /// <summary>
    /// One standard deviation of it, seconds, with what the mount and the vehicle's attitude may add: at one speed and
    /// height in all passes, a camera that is mounted nose up or down looks the same.
    /// </summary>
    public double ErrorSeconds { get; set; }

    /// <summary>
    /// Whether the passes show a wrong time also where nothing is known of the mount: it is not a camera that is
    /// mounted nose up or down.
    /// </summary>
    public bool ExcludesMount { get; set; }

    /// <summary>How many passes it is made of; 0 while it is not known.</summary>
    public int Passes { get; set; }

    /// <summary>Of how many targets; 0 while it is not known.</summary>
    public int Targets { get; set; }

    /// <summary>Whether there are passes enough that contradict or confirm each other.</summary>
    public readonly bool IsKnown => Passes > 0;
}
