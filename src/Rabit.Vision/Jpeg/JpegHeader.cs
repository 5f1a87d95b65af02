using System;

namespace Rabit.Vision;

/// <summary>
/// What the markers of a JPEG say (ITU-T T.81, annex B). Everything is checked before room is made for pixels; used
/// again for the next file.
/// </summary>
internal sealed class JpegHeader
{
    public const int MaxComponents = 3;

    private readonly HuffmanTable[] _huffman = new HuffmanTable[8];
    private readonly bool[] _hasQuantisation = new bool[4];
    private readonly bool _acceptsProgressive;
    private string _name = string.Empty;
    private byte[] _data = [];
    private int _end;
    private int _at;
    private bool _isJfif;
    private int _adobeTransform;

    /// <param name="acceptsProgressive">Whether progressive files are decoded, by another decoder.</param>
    public JpegHeader(bool acceptsProgressive = false)
    {
        _acceptsProgressive = acceptsProgressive;
        for (int at = 0; at < _huffman.Length; at++)
            _huffman[at] = new HuffmanTable();
        for (int at = 0; at < MaxComponents; at++)
            Components[at] = new JpegComponent();
        for (int at = 0; at < Quantisation.Length; at++)
            Quantisation[at] = new int[64];
    }

    public int Width { get; private set; }

    public int Height { get; private set; }

    /// <summary>How many of <see cref="Components"/> there are; 0 before the frame.</summary>
    public int ComponentCount { get; private set; }

    public JpegComponent[] Components { get; } = new JpegComponent[MaxComponents];

    /// <summary>The components of the scan that was read last.</summary>
    public JpegComponent[] ScanComponents { get; } = new JpegComponent[MaxComponents];

    public int ScanComponentCount { get; private set; }

    public int MaxHorizontal { get; private set; }

    public int MaxVertical { get; private set; }

    /// <summary>Columns of the smallest units that hold whole blocks of all components.</summary>
    public int UnitsAcross { get; private set; }

    public int UnitsDown { get; private set; }

    /// <summary>Units between two restart markers; 0 without them.</summary>
    public int RestartInterval { get; private set; }

    /// <summary>Steps of the coefficients, in the order of the file.</summary>
    public int[][] Quantisation { get; } = new int[4][];

    /// <summary>Whether the components are red, green and blue, not brightness and two colours.</summary>
    public bool IsRgb { get; private set; }

    /// <summary>Whether it is progressive; only its first scan header is read then.</summary>
    public bool IsProgressive { get; private set; }

    /// <summary>Where the bits of the scan begin.</summary>
    public int ScanAt => _at;

    /// <summary>Reads the markers up to the first scan.</summary>
    /// <exception cref="PictureException">It is no JPEG, of a kind that is not read, or damaged.</exception>
    public void Open(byte[] data, int offset, int count, string name)
    {
        (_data, _at, _end, _name) = (data, offset + 2, offset + count, name);
        (ComponentCount, RestartInterval, _isJfif, _adobeTransform) = (0, 0, false, -1);
        IsProgressive = false;
        Array.Clear(_hasQuantisation, 0, _hasQuantisation.Length);
        foreach (HuffmanTable table in _huffman)
            table.Clear();
        if (count < 2 || data[offset] != 0xFF || data[offset + 1] != JpegMarker.Start)
            throw Fault(count == 0 ? "the file is empty" : "that is no JPEG");
        ReadToScan(offset + 2);
        IsRgb = FindIsRgb();
    }

    /// <summary>Reads the markers from a place up to the next scan.</summary>
    /// <exception cref="PictureException">There is none, or something is wrong.</exception>
    public void ReadToScan(int from)
    {
        _at = from;
        while (true)
        {
            int marker = NextMarker();
            if (marker == JpegMarker.End)
                throw Fault(ComponentCount == 0 ? "there is no picture in it" : "a part of its pixels is missing");
            if (JpegMarker.IsAlone(marker))
                continue;
            int length = _end - _at < 2 ? 0 : (_data[_at] << 8) | _data[_at + 1];
            if (length < 2 || length > _end - _at)
                throw Fault("it is cut off");
            var segment = new ReadOnlySpan<byte>(_data, _at + 2, length - 2);
            _at += length;
            Read(marker, segment);
            if (marker == JpegMarker.Scan)
                return;
        }
    }

    public HuffmanTable Huffman(bool isAc, int number) => _huffman[(isAc ? 4 : 0) + number];

    public PictureException Fault(string reason) => new(_name, reason);

    private int NextMarker()
    {
        for (; _at < _end - 1; _at++)
        {
            if (_data[_at] != 0xFF || _data[_at + 1] is 0 or 0xFF)
                continue;
            _at += 2;
            return _data[_at - 1];
        }

        throw Fault("it is cut off");
    }

    private void Read(int marker, ReadOnlySpan<byte> segment)
    {
        switch (marker)
        {
            case JpegMarker.QuantisationTables:
                ReadQuantisation(segment);
                break;
            case JpegMarker.HuffmanTables:
                ReadHuffman(segment);
                break;
            case JpegMarker.RestartInterval:
                if (segment.Length != 2)
                    throw Fault("its restart interval is wrong");
                RestartInterval = (segment[0] << 8) | segment[1];
                break;
            case JpegMarker.App0:
                _isJfif |= segment.Length >= 12 && segment[0] == 'J' && segment[1] == 'F' && segment[2] == 'I'
                    && segment[3] == 'F' && segment[4] == 0;
                break;
            case JpegMarker.App14:
                if (segment.Length >= 12 && segment[0] == 'A' && segment[1] == 'd' && segment[2] == 'o'
                    && segment[3] == 'b' && segment[4] == 'e')
                    _adobeTransform = segment[11];
                break;
            case JpegMarker.Scan:
                ReadScan(segment);
                break;
            default:
                if (JpegMarker.IsFrame(marker))
                    ReadFrame(marker, segment);
                break;
        }
    }

    private void ReadFrame(int marker, ReadOnlySpan<byte> segment)
    {
        IsProgressive = marker == JpegMarker.ProgressiveFrame && _acceptsProgressive;
        if (!IsProgressive && JpegMarker.FindFrameFault(marker) is { } kind)
            throw Fault(kind);
        if (ComponentCount > 0)
            throw Fault("it has two frame headers");
        if (segment.Length < 6)
            throw Fault("its frame header is wrong");
        if (segment[0] != 8)
            throw Fault($"it has {segment[0]} bits per sample; only 8 are read");
        Height = (segment[1] << 8) | segment[2];
        Width = (segment[3] << 8) | segment[4];
        if (RgbPicture.FindSizeFault(Width, Height) is { } fault)
            throw Fault(fault);
        int count = segment[5];
        if (count == 4)
            throw Fault("it has 4 components, as CMYK has; only grey and colour pictures are read");
        if (count is not (1 or 3))
            throw Fault($"it has {count} components; only 1 and 3 are read");
        if (segment.Length != 6 + (3 * count))
            throw Fault("its frame header is wrong");
        ReadComponents(segment.Slice(6), count);
        ComponentCount = count;
    }

    private void ReadComponents(ReadOnlySpan<byte> segment, int count)
    {
        (MaxHorizontal, MaxVertical) = (1, 1);
        for (int at = 0; at < count; at++)
        {
            JpegComponent component = Components[at];
            component.Id = segment[3 * at];
            component.Horizontal = segment[(3 * at) + 1] >> 4;
            component.Vertical = segment[(3 * at) + 1] & 15;
            component.QuantisationTable = segment[(3 * at) + 2];
            component.IsDecoded = false;
            if (component.Horizontal is < 1 or > 4 || component.Vertical is < 1 or > 4
                || component.QuantisationTable > 3)
                throw Fault("its frame header is wrong");
            MaxHorizontal = Math.Max(MaxHorizontal, component.Horizontal);
            MaxVertical = Math.Max(MaxVertical, component.Vertical);
        }

        for (int at = 0; at < count; at++)
        {
            if (MaxHorizontal % Components[at].Horizontal != 0 || MaxVertical % Components[at].Vertical != 0)
                throw Fault("its components are sampled in a ratio that is not whole, which is not read");
        }

        UnitsAcross = JpegComponent.CeilingOf(Width, 8 * MaxHorizontal);
        UnitsDown = JpegComponent.CeilingOf(Height, 8 * MaxVertical);
    }

    private void ReadQuantisation(ReadOnlySpan<byte> segment)
    {
        while (segment.Length > 0)
        {
            int number = segment[0] & 15;
            int bytes = (segment[0] >> 4) + 1;
            if (number > 3 || bytes > 2 || segment.Length < 1 + (64 * bytes))
                throw Fault("a quantisation table of it is wrong");
            for (int at = 0; at < 64; at++)
                Quantisation[number][at] =
                    bytes == 1 ? segment[1 + at] : (segment[1 + (2 * at)] << 8) | segment[2 + (2 * at)];
            _hasQuantisation[number] = true;
            segment = segment.Slice(1 + (64 * bytes));
        }
    }

    private void ReadHuffman(ReadOnlySpan<byte> segment)
    {
        while (segment.Length > 0)
        {
            int used = TryReadHuffman(segment);
            if (used == 0)
                throw Fault("a Huffman table of it is wrong");
            segment = segment.Slice(used);
        }
    }

    private int TryReadHuffman(ReadOnlySpan<byte> segment)
    {
        int number = segment[0] & 15;
        bool isAc = segment[0] >> 4 == 1;
        if (number > 3 || segment[0] >> 4 > 1 || segment.Length < 17)
            return 0;
        int symbols = 0;
        for (int at = 1; at <= 16; at++)
            symbols += segment[at];
        if (symbols > 256 || segment.Length < 17 + symbols)
            return 0;
        return Huffman(isAc, number).TrySet(segment.Slice(1, 16), segment.Slice(17, symbols), isAc) ? 17 + symbols : 0;
    }

    private void ReadScan(ReadOnlySpan<byte> segment)
    {
        if (ComponentCount == 0)
            throw Fault("its pixels come before its frame header");
        int count = segment.Length == 0 ? 0 : segment[0];
        if (count < 1 || count > ComponentCount || segment.Length != 4 + (2 * count))
            throw Fault("its scan header is wrong");
        int blocks = 0;
        for (int at = 0; at < count; at++)
        {
            JpegComponent component = FindComponent(segment[1 + (2 * at)]);
            int tables = segment[2 + (2 * at)];
            (component.DcTable, component.AcTable, component.IsDecoded) = (tables >> 4, tables & 15, true);
            ScanComponents[at] = component;
            blocks += component.Horizontal * component.Vertical;
            if (IsProgressive)
                continue;
            if (!HasTable(false, component.DcTable) || !HasTable(true, component.AcTable)
                || !_hasQuantisation[component.QuantisationTable])
                throw Fault("a table that its pixels need is missing");
        }

        if (count > 1 && blocks > 10)
            throw Fault("its scan header is wrong: more than 10 blocks belong together");
        ScanComponentCount = count;
        DemandBytes(count, blocks);
    }

    // Each block takes two codes of at least one bit, or one in the first scan of a progressive file. So a small file
    // makes no room for a large picture.
    private void DemandBytes(int count, int blocks)
    {
        long all = count > 1
            ? (long)UnitsAcross * UnitsDown * blocks
            : (long)BlocksAcross(ScanComponents[0]) * BlocksDown(ScanComponents[0]);
        if (_end - _at < all / (IsProgressive ? 8 : 4))
            throw Fault("it is cut off");
    }

    public int BlocksAcross(JpegComponent component)
        => JpegComponent.CeilingOf(Width * component.Horizontal, MaxHorizontal * 8);

    public int BlocksDown(JpegComponent component)
        => JpegComponent.CeilingOf(Height * component.Vertical, MaxVertical * 8);

    private JpegComponent FindComponent(int id)
    {
        for (int at = 0; at < ComponentCount; at++)
        {
            if (Components[at].Id == id && !Components[at].IsDecoded)
                return Components[at];
        }

        throw Fault("its scan header is wrong: it names a component that there is not, or one twice");
    }

    private bool HasTable(bool isAc, int number)
    {
        if (number > 3)
            return false;
        HuffmanTable table = Huffman(isAc, number);
        if (!table.IsSet && JpegTables.FindHuffman(isAc, number) is { } standard)
            table.TrySet(standard.AsSpan(0, 16), standard.AsSpan(16), isAc);
        return table.IsSet;
    }

    // As JFIF and Adobe say it, else by the names of the components.
    private bool FindIsRgb()
    {
        if (ComponentCount != 3 || _isJfif)
            return false;
        return _adobeTransform >= 0
            ? _adobeTransform == 0
            : Components[0].Id == 'R' && Components[1].Id == 'G' && Components[2].Id == 'B';
    }
}
