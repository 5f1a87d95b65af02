using System;
using System.Collections.Generic;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How a <see cref="V4l2Camera"/> gets its pictures.</summary>
public sealed class V4l2CameraOptions
{
    internal static readonly TimeSpan AssumedExposure = TimeSpan.FromMilliseconds(5);

    // By ticks: some runtimes make whole milliseconds of a number of them.
    private static readonly TimeSpan MinExposure = TimeSpan.FromTicks(TimeSpan.TicksPerMillisecond / 10);

    private static readonly TimeSpan MaxTime = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan MaxStallTimeout = TimeSpan.FromSeconds(600);

    /// <summary>The device, for example "/dev/video0", or a link below /dev/v4l/by-id that stays the same.</summary>
    public string Device { get; set; } = string.Empty;

    /// <summary>What it is asked for.</summary>
    public V4l2PixelFormat Format { get; set; }

    /// <summary>Columns of its pictures.</summary>
    public int Width { get; set; }

    /// <summary>Rows of its pictures.</summary>
    public int Height { get; set; }

    /// <summary>
    /// How many pictures a second the device is asked for; where it gives more, the others are passed over and counted.
    /// Null leaves the device as it is, and takes all.
    /// </summary>
    /// <value>The default is null.</value>
    public double? FramesPerSecond { get; set; }

    /// <summary>
    /// The exposure that the device is set to, which limits the motion blur; what its driver makes of it counts. Null
    /// leaves it automatic, no longer than a period of the pictures, and it is taken to be 5 ms.
    /// </summary>
    /// <value>The default is null. A device without such a control says so in the log.</value>
    public TimeSpan? Exposure { get; set; }

    /// <summary>
    /// The place that the focus is locked at, in the device's own unit; null leaves it as it is, where that is
    /// automatic too.
    /// </summary>
    /// <value>The default is null. A device without such a control says so in the log.</value>
    public int? Focus { get; set; }

    /// <summary>How long the sensor reads a whole picture, as <c>CameraModel.Readout</c>.</summary>
    /// <value>The default is zero.</value>
    public TimeSpan Readout { get; set; }

    /// <summary>
    /// How much later than it says the driver takes the time of a picture; of a driver that takes none, how long after
    /// the end of its exposure a picture arrives.
    /// </summary>
    /// <value>The default is null: zero, and 50 ms without the driver's time.</value>
    public TimeSpan? Latency { get; set; }

    /// <summary>
    /// How wrong the time of a picture is, one standard deviation: it goes into the error budget of what is seen.
    /// </summary>
    /// <value>
    /// The default is null: 5 ms, and 20 ms without the driver's time. Both are assumed, not measured. Without the
    /// driver's time less than 20 ms counts as 20 ms.
    /// </value>
    public TimeSpan? TimeNoise { get; set; }

    /// <summary>
    /// The device is closed and opened again when it has given nothing for so long, or only pictures that cannot be
    /// used.
    /// </summary>
    /// <value>The default is 5 s.</value>
    public TimeSpan StallTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>The delay before it is opened again; it doubles with each time that gives no picture.</summary>
    /// <value>The default is 0.5 s.</value>
    public TimeSpan FirstRestartDelay { get; set; } = TimeSpan.OfSeconds(0.5);

    /// <summary>Where the doubling ends.</summary>
    /// <value>The default is 10 s.</value>
    public TimeSpan MaxRestartDelay { get; set; } = TimeSpan.FromSeconds(10);

    /// <summary>How many pictures may be on their way at once; while all are, pictures are lost.</summary>
    /// <value>The default is 6.</value>
    public int Buffers { get; set; } = 6;

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal V4l2CameraOptions ValidatedCopy(string parameter)
    {
        List<string> faults = [.. FindFaults()];
        return faults.Count == 0
            ? (V4l2CameraOptions)MemberwiseClone()
            : throw new ArgumentException($"The camera {Device}: {string.Join("; ", faults)}.", parameter);
    }

    private IEnumerable<string> FindFaults()
    {
        if (Device.Length == 0)
            yield return $"{nameof(Device)} is empty";
        if (RgbPicture.FindSizeFault(Width, Height) is { } fault)
            yield return fault;
        if (Format == V4l2PixelFormat.Yuyv && Width % 2 != 0)
            yield return FormattableString.Invariant($"{nameof(Width)} is {Width}; it must be even for YUYV");
        if (FramesPerSecond is { } rate
            && !(rate is >= ProcessCameraOptions.MinRate and <= ProcessCameraOptions.MaxRate))
        {
            yield return FormattableString.Invariant(
                $"{nameof(FramesPerSecond)} is {rate}; it must be {ProcessCameraOptions.MinRate} to ")
                + FormattableString.Invariant($"{ProcessCameraOptions.MaxRate}");
        }

        if (Exposure < MinExposure || Exposure > MaxTime)
            yield return $"{nameof(Exposure)} is {Exposure}; it must be 0.1 ms to 10 s";
        if (Readout < TimeSpan.Zero || Latency < TimeSpan.Zero || TimeNoise < TimeSpan.Zero)
            yield return $"{nameof(Readout)}, {nameof(Latency)} and {nameof(TimeNoise)} must not be negative";
        if (Readout > MaxTime || Latency > MaxTime || TimeNoise > MaxTime)
            yield return $"{nameof(Readout)}, {nameof(Latency)} and {nameof(TimeNoise)} must be at most 10 s";
        if (StallTimeout <= TimeSpan.Zero || FirstRestartDelay <= TimeSpan.Zero || MaxRestartDelay < FirstRestartDelay)
            yield return "timeout and delays must be above zero, the longest not below the first";
        if (StallTimeout > MaxStallTimeout || MaxRestartDelay > MaxStallTimeout)
            yield return $"{nameof(StallTimeout)} and {nameof(MaxRestartDelay)} must be at most 600 s";
        if (Buffers < 1)
            yield return FormattableString.Invariant($"{nameof(Buffers)} is {Buffers}; it must be at least 1");
    }
}
