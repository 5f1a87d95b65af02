using System;

namespace Rabit.Vision;

/// <summary>
/// Reads pictures out of files, one after the other, with the same memory: JPEG (see <see cref="JpegDecoder"/>), PNG,
/// binary PPM (P6) and binary PGM (P5, 8 and 16 bits, made 8 bits by its largest value). What a file is, its first
/// bytes say, not its name. One thread.
/// </summary>
/// <example>
/// <code>
/// var reader = new PictureReader();
/// byte[] pixels = new byte[640 * 480 * 3];
/// foreach (string path in Directory.GetFiles("pictures"))
///     reader.LoadInto(path, 640, 480, pixels);
/// </code>
/// </example>
public sealed class PictureReader
{
    private const string WhatIsRead = "only JPEG, PNG and binary PPM (P6) and PGM (P5) are";

    private byte[] _file = [];
    private JpegDecoder? _jpeg;
    private PngDecoder? _png;
    private PnmDecoder? _pnm;

    /// <summary>Reads a picture.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PictureException">
    /// There is no such file, it may not be read, it is of a kind that is not read, or damaged.
    /// </exception>
    public RgbPicture Load(string path)
    {
        (int width, int height) = Open(path);
        byte[] pixels = new byte[width * height * 3];
        Decode(pixels);
        return new RgbPicture(width, height, pixels);
    }

    /// <summary>Reads a picture of a known size.</summary>
    /// <param name="path">The file.</param>
    /// <param name="width">Columns it must have.</param>
    /// <param name="height">Rows it must have.</param>
    /// <param name="pixels">Takes red, green and blue.</param>
    /// <exception cref="PictureException">As for <see cref="Load"/>, or another size.</exception>
    public void LoadInto(string path, int width, int height, byte[] pixels)
    {
        PixelBuffer.Check(pixels, width, height);
        (int itsWidth, int itsHeight) = Open(path);
        if (itsWidth != width || itsHeight != height)
            throw new PictureException(
                path, $"it is {itsWidth} x {itsHeight} pixels; those of its camera are {width} x {height}");
        Decode(pixels);
    }

    /// <summary>
    /// Reads the counts of a thermal camera: a binary PGM or grey PNG of 16 bits. Others are refused, since what a
    /// camera program made 8 bits is stretched otherwise in each picture.
    /// </summary>
    /// <param name="path">The file.</param>
    /// <param name="width">Columns it must have.</param>
    /// <param name="height">Rows it must have.</param>
    /// <param name="counts">Takes width x height values.</param>
    /// <exception cref="PictureException">As for <see cref="Load"/>, another size, or not of 16 bits.</exception>
    /// <exception cref="ArgumentException">There is no room for so many values.</exception>
    public void LoadCountsInto(string path, int width, int height, Span<ushort> counts)
    {
        if (width < 1 || height < 1 || counts.Length / width < height)
            throw new ArgumentException(
                $"A span of {counts.Length} values does not hold a picture of {width} x {height} pixels.",
                nameof(counts));
        (int itsWidth, int itsHeight) = Open(path);
        if (itsWidth != width || itsHeight != height)
            throw new PictureException(
                path, $"it is {itsWidth} x {itsHeight} pixels; those of its camera are {width} x {height}");
        counts = counts.Slice(0, width * height);
        if (_png?.TryDecodeCounts(counts) != true && _pnm?.TryDecodeCounts(counts) != true)
            throw new PictureException(path, "it has no 16 bits of grey, as the pictures of a thermal camera have");
    }

    private void Decode(byte[] pixels)
    {
        if (_png is not null)
            _png.Decode(pixels);
        else if (_pnm is not null)
            _pnm.Decode(pixels);
        else
            _jpeg!.Decode(pixels);
    }

    private (int Width, int Height) Open(string path)
    {
        int length = PictureBytes.ReadAll(path, ref _file);
        (_png, _pnm) = (null, null);
        if (length == 0)
            throw new PictureException(path, "the file is empty");
        if (length >= 2 && _file[0] == 'P' && _file[1] is (byte)'5' or (byte)'6')
        {
            _pnm = new PnmDecoder(_file, length, path);
            return (_pnm.Width, _pnm.Height);
        }

        if (length >= 2 && _file[0] == 0xFF && _file[1] == JpegMarker.Start)
        {
            _jpeg ??= new JpegDecoder();
            _jpeg.Open(_file, 0, length, path);
            return (_jpeg.Width, _jpeg.Height);
        }

        if (_file[0] != PngPicture.Signature[0])
            throw new PictureException(path, "that is no picture that is read here; " + WhatIsRead);
        _png = new PngDecoder(_file, length, path);
        return (_png.Width, _png.Height);
    }
}
