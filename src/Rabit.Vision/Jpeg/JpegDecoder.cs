using System;

namespace Rabit.Vision;

/// <summary>
/// Reads JPEG pictures (ITU-T T.81), baseline and extended sequential ones of 8 bits, grey or in colour, as cameras
/// give them: sampled in any whole ratio, with restart markers, also without Huffman tables. The pixels are those of
/// libjpeg's accurate integer method, to the bit. One decoder reads one picture after the other and allocates nothing
/// after the first of a size. One thread.
/// </summary>
/// <remarks>
/// <para>
/// Lossless, hierarchical and arithmetic coded files, 12 bits and CMYK are refused by name, and so is a picture of
/// which a part is missing: what is not there must not be taken for ground without targets. The orientation that a file
/// may state is not applied.
/// </para>
/// <para>
/// Where libturbojpeg is installed (Linux; Debian's libturbojpeg0), it decodes the pixels, which are the same, and
/// progressive files are read too. What it finds fault with is decoded by Rabit's own decoder, which decides. Without
/// it progressive files are refused. Only damaged files with values that no encoder writes may give other pixels.
/// </para>
/// </remarks>
/// <example>
/// <code>
/// var decoder = new JpegDecoder();
/// byte[] frame = File.ReadAllBytes("frame.jpg");
/// decoder.Open(frame, 0, frame.Length, "frame.jpg");
/// byte[] pixels = new byte[decoder.Width * decoder.Height * 3];
/// decoder.Decode(pixels);
/// </code>
/// </example>
public sealed class JpegDecoder
{
    private const int MaxScans = 200;

    private readonly JpegHeader _header;
    private readonly TurboJpegLibrary? _library;
    private readonly JpegScan _scan;
    private readonly JpegUpsampler[] _rows = [new(), new(), new()];
    private byte[] _file = [];
    private int _begin;
    private int _end;
    private bool _isOpen;

    /// <summary>Makes a decoder.</summary>
    /// <param name="mayUseLibrary">Whether libturbojpeg is used where it is installed.</param>
    public JpegDecoder(bool mayUseLibrary = true)
    {
        _library = mayUseLibrary ? TurboJpegLibrary.TryCreate() : null;
        _header = new JpegHeader(acceptsProgressive: _library is not null);
        _scan = new JpegScan(_header);
    }

    /// <summary>What decodes, for people: "libturbojpeg" or "Rabit".</summary>
    public string Engine => _library is null ? "Rabit" : "libturbojpeg";

    /// <summary>Columns of the picture that was opened.</summary>
    public int Width => _header.Width;

    /// <summary>Rows of the picture that was opened.</summary>
    public int Height => _header.Height;

    /// <summary>Reads what the file says before its pixels.</summary>
    /// <param name="file">The bytes, which are read again by <see cref="Decode"/>.</param>
    /// <param name="offset">Where the file begins in them.</param>
    /// <param name="count">How many bytes belong to it; what follows the end of the picture is not read.</param>
    /// <param name="name">What errors call it.</param>
    /// <exception cref="PictureException">It is no JPEG, one of a kind that is not read, or damaged.</exception>
    public void Open(byte[] file, int offset, int count, string name)
    {
        if (file is null)
            throw new ArgumentNullException(nameof(file));
        if (offset < 0 || count < 0 || offset > file.Length - count)
            throw new ArgumentOutOfRangeException(nameof(count), "These bytes are not in the array.");
        _isOpen = false;
        (_file, _begin, _end) = (file, offset, offset + count);
        _header.Open(file, offset, count, name);
        _isOpen = true;
    }

    /// <summary>Writes red, green and blue of all pixels, row by row from the top left.</summary>
    /// <param name="pixels">At least width x height x 3 bytes.</param>
    /// <exception cref="PictureException">The pixels are damaged, or a part of them is missing.</exception>
    public void Decode(byte[] pixels)
    {
        PixelBuffer.Check(pixels, Math.Max(Width, 1), Math.Max(Height, 1));
        if (!_isOpen)
            throw new InvalidOperationException("No file is open: Open must succeed first, once for each picture.");
        _isOpen = false;
        if (_header.IsProgressive && CountScans() > MaxScans)
            throw _header.Fault($"it has more than {MaxScans} scans, which no camera makes");
        if (_library?.TryDecode(_file, _begin, _end - _begin, Width, Height, pixels) == true)
            return;
        if (_header.IsProgressive)
            throw _header.Fault("its pixels are damaged, or a part of them is missing");
        for (int at = 0; at < _header.ComponentCount; at++)
            _header.Components[at].Arrange(_header);

        int decoded = 0;
        while (true)
        {
            int next = _scan.Decode(_file, _header.ScanAt, _end);
            decoded += _header.ScanComponentCount;
            if (decoded == _header.ComponentCount)
                break;
            _header.ReadToScan(next);
        }

        WriteRows(pixels);
    }

    // Each goes over all pixels: a small file could take hours.
    private int CountScans()
    {
        int scans = 0;
        ReadOnlySpan<byte> left = _file.AsSpan(_begin, _end - _begin);
        while (left.IndexOf((byte)0xFF) is var at && at >= 0 && at + 1 < left.Length)
        {
            scans += left[at + 1] == JpegMarker.Scan ? 1 : 0;
            left = left.Slice(at + 1);
        }

        return scans;
    }

    private void WriteRows(byte[] pixels)
    {
        for (int at = 0; at < _header.ComponentCount; at++)
            _rows[at].Arrange(_header, _header.Components[at]);
        for (int row = 0; row < Height; row++)
        {
            Span<byte> to = pixels.AsSpan(row * Width * 3, Width * 3);
            ReadOnlySpan<byte> first = Select(0, row);
            if (_header.ComponentCount == 1)
                JpegColours.Interleave(first, first, first, to);
            else if (_header.IsRgb)
                JpegColours.Interleave(first, Select(1, row), Select(2, row), to);
            else
                JpegColours.Convert(first, Select(1, row), Select(2, row), to);
        }
    }

    private ReadOnlySpan<byte> Select(int component, int row)
    {
        JpegUpsampler rows = _rows[component];
        rows.Select(row);
        return rows.Row.AsSpan(rows.RowAt, Width);
    }
}
