using System;
using System.IO;
using System.IO.Compression;

namespace Rabit.Vision;

/// <summary>
/// Reads one PNG. The chunks are checked at once, so that the size is known and validated before memory is spent on it;
/// the pixels when they are asked for.
/// </summary>
internal sealed class PngDecoder
{
    private const int MaxChunkLength = int.MaxValue - 12;

    private readonly byte[] _file;
    private readonly int _length;
    private readonly string _name;
    private readonly byte[] _data;   // all IDAT chunks, one after the other
    private int _dataLength;
    private byte[]? _palette;
    private PngColour _colour;
    private bool _isWide;   // 16 bits, of grey alone
    private bool _hasHeader;

    /// <exception cref="PictureException">The bytes are no PNG, one of a kind that is not read, or damaged.</exception>
    public PngDecoder(byte[] file, int length, string name)
    {
        (_file, _length, _name) = (file, length, name);
        _data = new byte[length];
        for (int at = 0; at < PngPicture.Signature.Length; at++)
        {
            if (at >= length || file[at] != PngPicture.Signature[at])
                throw Fault("that is no PNG");
        }

        int next = PngPicture.Signature.Length;
        while (ReadChunk(ref next))
        {
        }

        if (_colour == PngColour.Palette && _palette is null)
            throw Fault("its palette is missing");
        if (_dataLength < 6)
            throw Fault("it has no pixels");
    }

    public int Width { get; private set; }

    public int Height { get; private set; }

    /// <summary>Writes red, green and blue of all pixels.</summary>
    /// <exception cref="PictureException">The pixels are damaged.</exception>
    public void Decode(byte[] pixels) => Decode(pixels, default);

    /// <summary>Writes the values of all pixels; false where they are not of 16 bits.</summary>
    /// <exception cref="PictureException">The pixels are damaged.</exception>
    public bool TryDecodeCounts(Span<ushort> counts)
    {
        if (_isWide)
            Decode([], counts);
        return _isWide;
    }

    private void Decode(byte[] pixels, Span<ushort> counts)
    {
        if ((_data[0] & 0x0F) != 8 || ((_data[0] << 8) | _data[1]) % 31 != 0 || (_data[1] & 0x20) != 0)
            throw Fault("its pixels are not packed as PNG requires");

        using var packed = new MemoryStream(_data, 2, _dataLength - 6);
        using var deflate = new DeflateStream(packed, CompressionMode.Decompress);
        int bytesPerPixel = _isWide ? 2 : BytesPerPixel(_colour);
        byte[] line = new byte[(Width * bytesPerPixel) + 1];
        byte[] above = new byte[line.Length];
        uint adler = 1;
        for (int row = 0; row < Height; row++)
        {
            Fill(deflate, line, row);
            adler = Checksums.Adler32(adler, line, 0, line.Length);
            Unfilter(line, above, bytesPerPixel, row);
            if (!counts.IsEmpty)
                CopyCounts(line, counts.Slice(row * Width, Width));
            else
                Spread(line, pixels, row * Width * 3);
            (line, above) = (above, line);
        }

        if (adler != PngPicture.GetNumber(_data, _dataLength - 4))
            throw Fault("it is damaged: the checksum of its pixels is wrong");
    }

    private bool ReadChunk(ref int next)
    {
        if (_length - next < 12)
            throw Fault("it is cut off");
        uint length = PngPicture.GetNumber(_file, next);
        uint type = PngPicture.GetNumber(_file, next + 4);
        if (length > MaxChunkLength || length > (uint)(_length - next - 12))
            throw Fault("it is cut off");
        int at = next + 8;
        int count = (int)length;
        if (Checksums.Crc32(_file, next + 4, count + 4) != PngPicture.GetNumber(_file, at + count))
            throw Fault($"it is damaged: the checksum at byte {at + count} is wrong");
        if (!_hasHeader && type != PngPicture.Header)
            throw Fault("it does not begin with its size");

        next = at + count + 4;
        switch (type)
        {
            case PngPicture.Header:
                ReadHeader(at, count);
                return true;
            case PngPicture.Palette:
                ReadPalette(at, count);
                return true;
            case PngPicture.Data:
                Buffer.BlockCopy(_file, at, _data, _dataLength, count);
                _dataLength += count;
                return true;
            case PngPicture.End:
                return false;
            default:
                if ((type & 0x20000000) == 0)
                    throw Fault($"it needs a part that is not known here (at byte {at - 4})");
                return true;
        }
    }

    private void ReadHeader(int at, int count)
    {
        if (_hasHeader || count != PngPicture.HeaderLength)
            throw Fault("its header is wrong");
        _hasHeader = true;
        long width = PngPicture.GetNumber(_file, at);
        long height = PngPicture.GetNumber(_file, at + 4);
        if (RgbPicture.FindSizeFault(width, height) is { } fault)
            throw Fault(fault);
        (Width, Height) = ((int)width, (int)height);
        _colour = (PngColour)_file[at + 9];
        if (_colour is not (PngColour.Grey or PngColour.Rgb or PngColour.Palette or PngColour.GreyAlpha
            or PngColour.Rgba))
            throw Fault($"its colour type {_file[at + 9]} does not exist");
        _isWide = _file[at + 8] == 16 && _colour == PngColour.Grey;
        if (_file[at + 8] != 8 && !_isWide)
            throw Fault($"it has {_file[at + 8]} bits per channel; only 8 are read, and 16 of grey");
        if (_file[at + 10] != 0 || _file[at + 11] != 0)
            throw Fault("its packing or its filters are not known");
        if (_file[at + 12] != 0)
            throw Fault("it is interlaced, which is not read");
    }

    private void ReadPalette(int at, int count)
    {
        if (count % 3 != 0 || count > 256 * 3)
            throw Fault("its palette is wrong");
        _palette = new byte[count];
        Buffer.BlockCopy(_file, at, _palette, 0, count);
    }

    private void Fill(DeflateStream from, byte[] line, int row)
    {
        try
        {
            int filled = 0;
            while (filled < line.Length)
            {
                int read = from.Read(line, filled, line.Length - filled);
                if (read <= 0)
                    throw Fault($"it is damaged: its pixels end in row {row} of {Height}");
                filled += read;
            }
        }
        catch (Exception e) when (e is InvalidDataException or IOException)
        {
            throw new PictureException(
                _name, $"it is damaged: its pixels cannot be unpacked in row {row} of {Height}", e);
        }
    }

    // PNG specification, 9.2: each byte was written as a difference to those to the left, above, and above to the left.
    private void Unfilter(byte[] line, byte[] above, int step, int row)
    {
        byte filter = line[0];
        if (filter > 4)
            throw Fault($"it is damaged: row {row} has filter {filter}, which does not exist");
        for (int at = 1; at < line.Length; at++)
        {
            int left = at > step ? line[at - step] : 0;
            int up = row > 0 ? above[at] : 0;
            int upLeft = row > 0 && at > step ? above[at - step] : 0;
            line[at] += filter switch
            {
                1 => (byte)left,
                2 => (byte)up,
                3 => (byte)((left + up) / 2),
                4 => (byte)Paeth(left, up, upLeft),
                _ => (byte)0,
            };
        }
    }

    private static int Paeth(int left, int up, int upLeft)
    {
        int estimate = left + up - upLeft;
        int byLeft = Math.Abs(estimate - left);
        int byUp = Math.Abs(estimate - up);
        int byUpLeft = Math.Abs(estimate - upLeft);
        if (byLeft <= byUp && byLeft <= byUpLeft)
            return left;
        return byUp <= byUpLeft ? up : upLeft;
    }

    private static void CopyCounts(byte[] line, Span<ushort> counts)
    {
        for (int i = 0; i < counts.Length; i++)
            counts[i] = (ushort)((line[(2 * i) + 1] << 8) | line[(2 * i) + 2]);
    }

    // Of 16 bits the upper ones.
    private void Spread(byte[] line, byte[] pixels, int to)
    {
        int step = _isWide ? 2 : BytesPerPixel(_colour);
        for (int at = 1; at < line.Length; at += step, to += 3)
        {
            if (_colour is PngColour.Rgb or PngColour.Rgba)
            {
                (pixels[to], pixels[to + 1], pixels[to + 2]) = (line[at], line[at + 1], line[at + 2]);
                continue;
            }

            if (_colour != PngColour.Palette)
            {
                pixels[to] = pixels[to + 1] = pixels[to + 2] = line[at];
                continue;
            }

            int entry = line[at] * 3;
            if (entry >= _palette!.Length)
                throw Fault($"it is damaged: a pixel has colour {line[at]} of a palette of {_palette.Length / 3}");
            (pixels[to], pixels[to + 1], pixels[to + 2]) = (_palette[entry], _palette[entry + 1], _palette[entry + 2]);
        }
    }

    private static int BytesPerPixel(PngColour colour) => colour switch
    {
        PngColour.Rgb => 3,
        PngColour.GreyAlpha => 2,
        PngColour.Rgba => 4,
        _ => 1,
    };

    private PictureException Fault(string reason) => new(_name, reason);
}
