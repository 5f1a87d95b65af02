using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Says where the times of a camera's pictures come from, for people.</summary>
internal static class PictureTimeSource
{
    /// <summary>
    /// The least that arrival can be relied on for, one standard deviation: a picture waits for the scheduler, the bus
    /// and the pictures before it, and its latency is stated, not measured.
    /// </summary>
    public static readonly TimeSpan MinArrivalNoise = TimeSpan.FromMilliseconds(20);

    /// <summary>Of an origin whose error is known.</summary>
    /// <param name="origin">As "names of the files".</param>
    /// <param name="noise">One standard deviation.</param>
    public static string Describe(string origin, TimeSpan noise)
        => FormattableString.Invariant($"{origin}, standard deviation {noise.ExactMilliseconds:0.###} ms");

    /// <summary>Of pictures that are stamped when they arrive.</summary>
    /// <param name="latency">What is taken off.</param>
    /// <param name="noise">One standard deviation.</param>
    public static string OfArrival(TimeSpan latency, TimeSpan noise)
        => Describe(FormattableString.Invariant($"arrival less {latency.ExactMilliseconds:0.###} ms"), noise);
}
