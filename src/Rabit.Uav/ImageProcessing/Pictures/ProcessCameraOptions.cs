using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>How a <see cref="ProcessCamera"/> gets its pictures.</summary>
public sealed class ProcessCameraOptions
{
    /// <summary>Stands for the path of a pipe in <see cref="Arguments"/>.</summary>
    internal const string MetadataPlace = "{metadata}";

    internal const double MinRate = 0.1;
    internal const double MaxRate = 1000;

    private const int MaxRowPadding = 4096;

    // As in the description of a camera; and what a timer takes.
    private static readonly TimeSpan MaxTime = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan MaxStallTimeout = TimeSpan.FromSeconds(600);

    /// <summary>The program, by its path or by a name that is found in PATH.</summary>
    public string Program { get; set; } = string.Empty;

    /// <summary>Its arguments, one each; no shell reads them.</summary>
    /// <remarks>
    /// <c>{metadata}</c> stands for the path of a pipe, from which the times of the pictures are read, as
    /// <c>rpicam-vid --metadata {metadata} --metadata-format txt</c> writes them: for each picture, after it, lines of
    /// the form Name=Value and an empty one. SensorTimestamp is when the readout of the first row began, in nanoseconds
    /// by CLOCK_MONOTONIC; ExposureTime is in microseconds, and counts instead of <see cref="Exposure"/>. Linux only.
    /// </remarks>
    public IReadOnlyList<string> Arguments { get; set; } = [];

    /// <summary>What it writes to its standard output.</summary>
    public ProcessCameraFormat Format { get; set; }

    /// <summary>Columns of its pictures.</summary>
    public int Width { get; set; }

    /// <summary>Rows of its pictures.</summary>
    public int Height { get; set; }

    /// <summary>
    /// Bytes from one row of a raw picture to the next, where the program pads them: <c>rpicam-vid --codec yuv420</c>
    /// makes them a multiple of 64, so that 1640 columns take 1664. Of <see cref="ProcessCameraFormat.Yuv420"/> and
    /// <see cref="ProcessCameraFormat.Yuv420FullRange"/> those of a row of brightness, an even number; a row of colour
    /// has half of it. Null for rows that follow each other.
    /// </summary>
    /// <value>The default is null.</value>
    public int? RowBytes { get; set; }

    /// <summary>How long an exposure takes.</summary>
    /// <value>The default is 5 ms.</value>
    public TimeSpan Exposure { get; set; } = TimeSpan.FromMilliseconds(5);

    /// <summary>
    /// How long after the end of its exposure a picture arrives: readout, compression and the pipe. What it is wrong by
    /// is <see cref="TimeNoise"/>.
    /// </summary>
    /// <value>The default is 50 ms.</value>
    public TimeSpan Latency { get; set; } = TimeSpan.FromMilliseconds(50);

    /// <summary>
    /// How wrong the time of a picture is, one standard deviation: it goes into the error budget of what is seen.
    /// </summary>
    /// <value>
    /// The default is 20 ms, which is the least that arrival alone can be relied on for: less is refused.
    /// </value>
    public TimeSpan TimeNoise { get; set; } = PictureTimeSource.MinArrivalNoise;

    /// <summary>As <see cref="TimeNoise"/>, of a picture whose time the program's metadata give.</summary>
    /// <value>The default is 1 ms.</value>
    public TimeSpan MetadataTimeNoise { get; set; } = TimeSpan.FromMilliseconds(1);

    /// <summary>
    /// How many pictures a second are decoded and searched, where the program gives more; null for all. More than the
    /// detector has time for are work for nothing.
    /// </summary>
    /// <value>The default is null.</value>
    public double? MaxFramesPerSecond { get; set; }

    /// <summary>
    /// The program is ended and started again when no whole picture has come for so long, whatever else it writes, or
    /// only pictures that cannot be used.
    /// </summary>
    /// <value>The default is 5 s.</value>
    public TimeSpan StallTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>The delay before it is started again; it doubles with each start that gives no picture.</summary>
    /// <value>The default is 0.5 s.</value>
    public TimeSpan FirstRestartDelay { get; set; } = TimeSpan.OfSeconds(0.5);

    /// <summary>Where the doubling ends.</summary>
    /// <value>The default is 10 s.</value>
    public TimeSpan MaxRestartDelay { get; set; } = TimeSpan.FromSeconds(10);

    /// <summary>How many pictures may be on their way at once; while all are, pictures are lost.</summary>
    /// <value>The default is 6.</value>
    public int Buffers { get; set; } = 6;

    /// <summary>
    /// Takes lines for people: what the program writes to its standard error, and why it was started again. Called from
    /// several threads.
    /// </summary>
    /// <value>The default is null. <see cref="ProcessCamera.LogTo"/> is given the same lines.</value>
    public Action<string>? Log { get; set; }

    /// <summary>
    /// How long an end of the program is no fault yet: what has ended it may be about to end this one, too.
    /// </summary>
    internal TimeSpan EndGrace { get; set; } = TimeSpan.OfSeconds(0.5);

    internal bool HasMetadata { get; private set; }

    /// <summary>What is wrong with the bytes of a row; null where nothing is.</summary>
    internal static string? FindRowFault(int? rowBytes, ProcessCameraFormat format, int width)
    {
        if (rowBytes is not { } bytes)
            return null;
        if (format == ProcessCameraFormat.Mjpeg)
            return "it is of raw pictures, and those of mjpeg have no rows";
        int min = format == ProcessCameraFormat.Grey16 ? width * 2 : width + (width % 2);
        int max = min + MaxRowPadding;
        return bytes >= min && bytes <= max && bytes % 2 == 0
            ? null
            : FormattableString.Invariant($"it is {bytes}; it must be even and {min} to {max}");
    }

    private string? FindTimeFault()
    {
        (string Name, TimeSpan Value, TimeSpan Max)[] times =
        [
            (nameof(Exposure), Exposure, MaxTime), (nameof(Latency), Latency, MaxTime),
            (nameof(TimeNoise), TimeNoise, MaxTime), (nameof(MetadataTimeNoise), MetadataTimeNoise, MaxTime),
            (nameof(StallTimeout), StallTimeout, MaxStallTimeout),
            (nameof(MaxRestartDelay), MaxRestartDelay, MaxStallTimeout),
        ];
        int wrong = Array.FindIndex(times, t => t.Value < TimeSpan.Zero || t.Value > t.Max);
        return wrong < 0
            ? null
            : FormattableString.Invariant(
                $"{times[wrong].Name} is {times[wrong].Value}; it must be 0 to {times[wrong].Max.ExactSeconds} s");
    }

    internal ProcessCameraOptions ValidatedCopy(string parameter)
    {
        var copy = (ProcessCameraOptions)MemberwiseClone();
        copy.Arguments = [.. Arguments];
        copy.HasMetadata = Arguments.Any(a => a.Contains(MetadataPlace));
        if (Program.Length == 0)
            throw new ArgumentException("A camera of a process needs a program.", parameter);
        if (RgbPicture.FindSizeFault(Width, Height) is { } fault)
            throw new ArgumentException($"The camera of {Program}: {fault}.", parameter);
        if (FindRowFault(RowBytes, Format, Width) is { } rowFault)
            throw new ArgumentException($"The camera of {Program}: {nameof(RowBytes)}: {rowFault}.", parameter);
        if (copy.HasMetadata && !OperatingSystem.IsLinux())
            throw new ArgumentException(
                $"The camera of {Program}: {MetadataPlace} stands in its arguments, and works on Linux only.",
                parameter);
        if (FindTimeFault() is { } timeFault)
            throw new ArgumentException($"The camera of {Program}: {timeFault}.", parameter);
        if (TimeNoise < PictureTimeSource.MinArrivalNoise)
        {
            throw new ArgumentException(
                FormattableString.Invariant($"The camera of {Program}: {nameof(TimeNoise)} is ")
                    + FormattableString.Invariant($"{TimeNoise.ExactMilliseconds} ms; a time by arrival is not known ")
                    + FormattableString.Invariant(
                        $"better than to {PictureTimeSource.MinArrivalNoise.ExactMilliseconds} ms."),
                parameter);
        }

        if (MaxFramesPerSecond is { } rate && !(rate >= MinRate && rate <= MaxRate))
            throw new ArgumentException(
                FormattableString.Invariant(
                    $"The camera of {Program}: {rate} frames a second; it must be {MinRate} to {MaxRate}."),
                parameter);
        if (StallTimeout <= TimeSpan.Zero || FirstRestartDelay <= TimeSpan.Zero || MaxRestartDelay < FirstRestartDelay)
            throw new ArgumentException(
                $"The camera of {Program}: timeout and delays must be above zero, the longest not below the first.",
                parameter);
        return copy;
    }
}
