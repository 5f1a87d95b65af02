using System;
using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A picture for a detector, and what is known about it. A plain value; the pixels and the ground scale are valid only
/// during the call.
/// </summary>
public readonly struct DetectorInput
{
    /// <summary>Makes an input: Image Processing does, and tests of a detector.</summary>
    /// <param name="pixels">At least width x height x 3 bytes; 2 of a thermal camera.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="classes">The classes to search for.</param>
    /// <param name="groundScale">How large pixels are on the ground.</param>
    /// <param name="format">How the bytes are arranged.</param>
    /// <exception cref="ArgumentException">The size is not positive, or the bytes are too few for it.</exception>
    public DetectorInput(
        ReadOnlyMemory<byte> pixels, int width, int height, ImmutableArray<TargetClass> classes,
        PictureGroundScale groundScale, PixelFormat format = PixelFormat.Rgb24)
    {
        if (width < 1 || height < 1 || pixels.Length / BytesPerPixel(format) / width < height)
        {
            throw new ArgumentException(
                $"A buffer of {pixels.Length} bytes does not hold a picture of {width} x {height} pixels.",
                nameof(pixels));
        }

        Pixels = pixels;
        (Width, Height, Format) = (width, height, format);
        Classes = classes.IsDefault ? [] : classes;
        GroundScale = groundScale;
    }

    /// <summary>
    /// The pixels: row r begins at byte r x <see cref="StrideBytes"/>. To be read only, and not to be kept: the buffer
    /// goes back to the camera after the call. To hand it to native code, pin it (<see cref="ReadOnlyMemory{T}.Pin"/>).
    /// </summary>
    public ReadOnlyMemory<byte> Pixels { get; }

    /// <summary>Columns.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>
    /// How the bytes are arranged: <see cref="PixelFormat.Rgb24"/>, but of a thermal camera
    /// <see cref="PixelFormat.Grey16"/>.
    /// </summary>
    public PixelFormat Format { get; }

    /// <summary>Bytes from one row to the next: those of its pixels, since rows are not padded.</summary>
    public int StrideBytes => Width * BytesPerPixel(Format);

    /// <summary>
    /// The classes to search for: those of the mission that are declared. The array stays the same until they change.
    /// </summary>
    public ImmutableArray<TargetClass> Classes { get; }

    /// <summary>How large pixels are on the ground, by the pose of the camera.</summary>
    public PictureGroundScale GroundScale { get; }

    /// <summary>Number of the picture: <see cref="CameraFrame.Number"/>.</summary>
    public long PictureNumber { get; init; }

    /// <summary>Mid-exposure, by the clock of the run.</summary>
    public TimeSpan Time { get; init; }

    internal static int BytesPerPixel(PixelFormat format) => format == PixelFormat.Grey16 ? 2 : 3;
}
