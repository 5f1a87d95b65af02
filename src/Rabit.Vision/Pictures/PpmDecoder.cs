using System;

namespace Rabit.Vision;

/// <summary>
/// Reads one binary PPM (Netpbm, "PPM Format Specification"): "P6", width, height, 255, one white space, pixels.
/// </summary>
internal sealed class PpmDecoder
{
    private const int MaxDigits = 9;

    private readonly byte[] _file;
    private readonly int _length;
    private readonly string _name;
    private readonly int _pixelsAt;

    /// <exception cref="PictureException">The bytes are no binary PPM with 8 bits per channel, or cut off.</exception>
    public PpmDecoder(byte[] file, int length, string name)
    {
        (_file, _length, _name) = (file, length, name);
        if (length < 2 || file[0] != 'P' || file[1] != '6')
            throw new PictureException(name, "that is no binary PPM");
        int at = 2;
        Width = ReadNumber(ref at);
        Height = ReadNumber(ref at);
        int max = ReadNumber(ref at);
        if (RgbPicture.FindSizeFault(Width, Height) is { } fault)
            throw new PictureException(name, fault);
        if (max != 255)
            throw new PictureException(name, $"its largest value is {max}; only 255 is read");
        _pixelsAt = at + 1;
        if (length - _pixelsAt < Width * Height * 3)
            throw new PictureException(name, "it is cut off");
    }

    public int Width { get; }

    public int Height { get; }

    public void Decode(byte[] pixels) => Buffer.BlockCopy(_file, _pixelsAt, pixels, 0, Width * Height * 3);

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
