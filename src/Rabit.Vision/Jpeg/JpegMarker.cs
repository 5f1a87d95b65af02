namespace Rabit.Vision;

/// <summary>Markers of a JPEG file: the byte after FF (ITU-T T.81, table B.1).</summary>
internal static class JpegMarker
{
    public const int BaselineFrame = 0xC0;
    public const int ExtendedFrame = 0xC1;
    public const int ProgressiveFrame = 0xC2;
    public const int HuffmanTables = 0xC4;
    public const int FirstRestart = 0xD0;
    public const int LastRestart = 0xD7;
    public const int Start = 0xD8;
    public const int End = 0xD9;
    public const int Scan = 0xDA;
    public const int QuantisationTables = 0xDB;
    public const int RestartInterval = 0xDD;
    public const int App0 = 0xE0;
    public const int App1 = 0xE1;
    public const int App14 = 0xEE;

    /// <summary>Whether a marker begins a frame, of whatever kind.</summary>
    public static bool IsFrame(int marker) => marker is >= 0xC0 and <= 0xCF and not (HuffmanTables or 0xC8 or 0xCC);

    /// <summary>Whether a marker stands alone, without a length.</summary>
    public static bool IsAlone(int marker) => marker is 0x01 or (>= FirstRestart and <= End);

    /// <summary>What is not read about a kind of frame; null for those that are.</summary>
    public static string? FindFrameFault(int marker) => marker switch
    {
        BaselineFrame or ExtendedFrame => null,
        ProgressiveFrame => "it is a progressive JPEG, which is read only where libturbojpeg is installed",
        0xC3 => "it is a lossless JPEG; only baseline and extended sequential ones are read",
        0xC5 or 0xC6 or 0xC7 => "it is a hierarchical JPEG; only baseline and extended sequential ones are read",
        _ => "it is a JPEG with arithmetic coding; only Huffman coding is read",
    };
}
