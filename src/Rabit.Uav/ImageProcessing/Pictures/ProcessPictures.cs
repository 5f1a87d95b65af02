using System;
using System.IO;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// What a program has written and is not taken yet, and the pictures in it. Its buffer grows to what a picture may have
/// at most. One thread.
/// </summary>
internal sealed class ProcessPictures
{
    private const int ChunkBytes = 65_536;

    private readonly ProcessCameraOptions _options;
    private readonly int _maxBytes;
    private int _filled;

    public ProcessPictures(ProcessCameraOptions options)
    {
        _options = options;

        // No JPEG of a camera is larger than its pixels.
        int picture = options.Format == ProcessCameraFormat.Mjpeg
            ? (options.Width * options.Height * 3) + ChunkBytes
            : RawBytes;
        _maxBytes = picture + ChunkBytes;
        Bytes = new byte[Math.Min(_maxBytes, (picture / 4) + (2 * ChunkBytes))];
    }

    /// <summary>What the places of pictures are in; another array after the next read.</summary>
    public byte[] Bytes { get; private set; }

    /// <summary>Whether there are more bytes without a picture than one may have.</summary>
    public bool IsFull => _filled == _maxBytes;

    // Of one picture, where all are of one size. Rows of colour have half of the bytes of those of brightness.
    private int RawBytes => (_options.Format, _options.RowBytes) switch
    {
        (ProcessCameraFormat.Grey16, _) => _options.Height * (_options.RowBytes ?? GreyRowBytes),
        (_, { } row) => (_options.Height + ((_options.Height + 1) / 2)) * row,
        _ => Yuv420.BytesOf(_options.Width, _options.Height),
    };

    private int GreyRowBytes => _options.Width * DetectorInput.BytesPerPixel(PixelFormat.Grey16);

    public void Clear() => _filled = 0;

    /// <summary>Reads what there is, and waits for something where there is nothing.</summary>
    /// <returns>How many bytes; 0 at the end, or where it was closed meanwhile.</returns>
    public int ReadFrom(Stream output)
    {
        if (Bytes.Length - _filled < ChunkBytes && Bytes.Length < _maxBytes)
        {
            byte[] larger = new byte[Math.Min(_maxBytes, Bytes.Length * 2)];
            Buffer.BlockCopy(Bytes, 0, larger, 0, _filled);
            Bytes = larger;
        }

        try
        {
            int read = output.Read(Bytes, _filled, Bytes.Length - _filled);
            _filled += read;
            return read;
        }
        catch (Exception e) when (e is IOException or ObjectDisposedException)
        {
            // It was killed.
            return 0;
        }
    }

    /// <summary>Finds the next whole picture.</summary>
    /// <param name="from">Where to begin.</param>
    /// <param name="start">Where it begins.</param>
    /// <param name="length">Its bytes.</param>
    /// <param name="keep">
    /// The place behind it; without one the first byte that is needed when more have come.
    /// </param>
    public bool TryFind(int from, out int start, out int length, out int keep)
    {
        if (_options.Format == ProcessCameraFormat.Mjpeg)
        {
            bool isFound = JpegStream.TryFind(Bytes, from, _filled - from, out start, out length);
            keep = start + length;
            return isFound;
        }

        (start, length) = (from, RawBytes);
        bool isWhole = _filled - from >= length;
        keep = isWhole ? from + length : from;
        return isWhole;
    }

    /// <summary>Removes what a raw picture has behind its rows, if anything, where it is.</summary>
    /// <param name="start">Where it begins.</param>
    /// <returns>Its bytes without that.</returns>
    public int RemovePadding(int start)
    {
        if (_options.RowBytes is not { } row)
            return RawBytes;
        (int from, int to) = (start, start);
        if (_options.Format == ProcessCameraFormat.Grey16)
        {
            MoveRows(_options.Height, row, GreyRowBytes, ref from, ref to);
            return to - start;
        }

        MoveRows(_options.Height, row, _options.Width, ref from, ref to);
        MoveRows(2 * ((_options.Height + 1) / 2), row / 2, (_options.Width + 1) / 2, ref from, ref to);
        return to - start;
    }

    private void MoveRows(int rows, int rowBytes, int used, ref int from, ref int to)
    {
        for (int i = 0; i < rows; i++, from += rowBytes, to += used)
            Buffer.BlockCopy(Bytes, from, Bytes, to, used);
    }

    /// <summary>Drops what is before a place.</summary>
    public void DropBefore(int place)
    {
        _filled -= place;
        Buffer.BlockCopy(Bytes, place, Bytes, 0, _filled);
    }
}
