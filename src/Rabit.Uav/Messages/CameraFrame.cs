using System;
using Rabit.Core;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;

namespace Rabit.Uav.Messages;

/// <summary>
/// A picture in a pooled buffer: its holder is the only owner of the buffer, and hands it on or disposes it. 8 bits
/// each of red, green and blue, row by row from the top left, without padding; of a thermal camera 16 bits of counts
/// (<see cref="Format"/>). A plain value.
/// </summary>
public struct CameraFrame : IDisposable
{
    /// <summary>The longest exposure that a picture may have.</summary>
    internal static readonly TimeSpan MaxExposure = TimeSpan.FromHours(1);

    // So that the middle of an exposure, and what is added to it, are times.
    private static readonly TimeSpan MaxFrameStart = TimeSpan.FromDays(3_652_500);

    private TimeSpan _frameStart;
    private TimeSpan _exposure;

    /// <summary>
    /// The pixels: <see cref="Width"/> x <see cref="Height"/> x 3 bytes from the start of the buffer, 2 of a thermal
    /// camera.
    /// </summary>
    public BufferLease Pixels { get; set; }

    /// <summary>How the bytes are arranged.</summary>
    /// <value>The default is <see cref="PixelFormat.Rgb24"/>.</value>
    public PixelFormat Format { get; set; }

    /// <summary>Columns.</summary>
    public int Width { get; set; }

    /// <summary>Rows.</summary>
    public int Height { get; set; }

    /// <summary>Which picture of its camera it is, from 0; a gap is a picture that was lost.</summary>
    public long Number { get; set; }

    /// <summary>
    /// When the exposure began, that of the top row, by the clock of the run: within 10 000 years of its start.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">It is further off.</exception>
    public TimeSpan FrameStart
    {
        readonly get => _frameStart;
        set => _frameStart = value <= MaxFrameStart && value >= -MaxFrameStart
            ? value
            : throw new ArgumentOutOfRangeException(
                nameof(value), value, $"A picture's {nameof(FrameStart)} is within 10 000 years of the run's start.");
    }

    /// <summary>How long the exposure took: 0 to an hour.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is none of these.</exception>
    public TimeSpan Exposure
    {
        readonly get => _exposure;
        set => _exposure = value >= TimeSpan.Zero && value <= MaxExposure
            ? value
            : throw new ArgumentOutOfRangeException(
                nameof(value), value, $"A picture's {nameof(Exposure)} is 0 to 1 hour.");
    }

    /// <summary>
    /// How wrong <see cref="FrameStart"/> may be, one standard deviation, beside what the error budget has for all
    /// pictures (<c>ErrorBudget.TimeNoise</c>); zero where it is not known.
    /// </summary>
    public TimeSpan TimeNoise { get; set; }

    /// <summary>
    /// The middle of the exposure: what the picture shows was true then. With a rolling shutter
    /// (<c>CameraModel.Readout</c>) that holds of the top row, and each row comes so much later than the one above
    /// it.
    /// </summary>
    public readonly TimeSpan MidExposure => FrameStart + TimeSpan.FromTicks(Exposure.Ticks / 2);

    /// <summary>Gives the buffer back.</summary>
    public readonly void Dispose() => Pixels.Dispose();
}
