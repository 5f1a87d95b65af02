using System;

namespace Rabit.Vision;

/// <summary>
/// Reads one binary PPM or PGM (Netpbm, "PPM Format Specification", "PGM Format Specification"): "P6" or "P5", width,
/// height, the largest value, one white space, pixels. That is 255 for a PPM, and anything up to 65 535 for a PGM.
/// </summary>
internal sealed class PnmDecoder
{
    private const int MaxDigits = 9;
    private const int MaxByte = 255;
    private const int MaxValue = 65_535;

    private readonly byte[] _file;
    private readonly int _length;
    private readonly string _name;
    private readonly int _pixelsAt;
    private readonly bool _isGrey;
    private readonly int _max;

    /// <exception cref="PictureException">The bytes are no such file, or cut off.</exception>
    public PnmDecoder(byte[] file, int length, string name)
    {
        (_file, _length, _name) = (file, length, name);
        if (length < 2 || file[0] != 'P' || file[1] is not ((byte)'5' or (byte)'6'))
            throw new PictureException(name, "that is no binary PPM or PGM");
        _isGrey = file[1] == '5';
        int at = 2;
        Width = ReadNumber(ref at);
        Height = ReadNumber(ref at);
        _max = ReadNumber(ref at);
        if (RgbPicture.FindSizeFault(Width, Height) is { } fault)
            throw new PictureException(name, fault);
        if (!_isGrey && _max != MaxByte)
            throw new PictureException(name, $"its largest value is {_max}; only 255 is read");
        if (_max is < 1 or > MaxValue)
            throw new PictureException(name, $"its largest value is {_max}; it must be 1 to {MaxValue}");

        // One white space, for which a comment with its end of line may stand, as for Netpbm's own programs.
        bool isComment = file[at] == '#';
        while (isComment && at < length && file[at] != '\n')
            at++;
        _pixelsAt = at + 1;
        int bytesPerPixel = !_isGrey ? 3 : _max > MaxByte ? 2 : 1;
        if (length - _pixelsAt < Width * Height * bytesPerPixel)
            throw new PictureException(name, "it is cut off");
    }

    public int Width { get; }

    public int Height { get; }

    /// <summary>Writes red, green and blue of all pixels; of a grey picture they are the same.</summary>
    public void Decode(byte[] pixels)
    {
        if (!_isGrey)
        {
            Buffer.BlockCopy(_file, _pixelsAt, pixels, 0, Width * Height * 3);
            return;
        }

        int from = _pixelsAt;
        for (int to = 0; to < Width * Height * 3; to += 3)
        {
            int value = _file[from++];
            if (_max > MaxByte)
                value = (value << 8) | _file[from++];
            if (_max != MaxByte)
                value = ((Math.Min(value, _max) * MaxByte) + (_max / 2)) / _max;
            (pixels[to], pixels[to + 1], pixels[to + 2]) = ((byte)value, (byte)value, (byte)value);
        }
    }

    /// <summary>Writes the values of all pixels; false where they have 8 bits.</summary>
    public bool TryDecodeCounts(Span<ushort> counts)
    {
        if (!_isGrey || _max <= MaxByte)
            return false;
        int from = _pixelsAt;
        for (int i = 0; i < counts.Length; i++, from += 2)
            counts[i] = (ushort)((_file[from] << 8) | _file[from + 1]);
        return true;
    }

    private int ReadNumber(ref int at)
    {
        int before = at;
        while (at < _length && (IsSpace(_file[at]) || _file[at] == '#'))
        {
            bool isComment = _file[at] == '#';
            while (isComment && at < _length && _file[at] != '\n')
                at++;
            at++;
        }

        int value = 0;
        int digits = 0;
        for (; at < _length && _file[at] is >= (byte)'0' and <= (byte)'9' && digits <= MaxDigits; at++, digits++)
            value = unchecked((value * 10) + _file[at] - '0');
        if (at == before + digits || digits == 0 || digits > MaxDigits || at >= _length
            || !(IsSpace(_file[at]) || _file[at] == '#'))
            throw new PictureException(_name, "its header is wrong or cut off");
        return value;
    }

    private static bool IsSpace(byte value)
        => value is (byte)' ' or (byte)'\t' or (byte)'\n' or (byte)'\r' or 0x0B or 0x0C;
}
