using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Vision.Tests.Jpeg;

namespace Rabit.Vision.Tests.Metadata;

/// <summary>Makes photos with EXIF and XMP as cameras write them.</summary>
internal static class PhotoBytes
{
    /// <summary>EXIF and XMP of a drone, in either order of bytes.</summary>
    public static byte[] Drone(bool isBig = false) => With(Exif(isBig, First, Detail, Gps), Xmp(DroneXmp));

    public const string DroneXmp =
        "drone-dji:RelativeAltitude=\"+39.80\" drone-dji:AbsoluteAltitude=\"198.310000\" "
        + "drone-dji:GimbalRollDegree=\"+0.10\" drone-dji:GimbalPitchDegree=\"-89.90\" "
        + "drone-dji:GimbalYawDegree=\"+45.00\" drone-dji:FlightRollDegree=\"+3.00\" "
        + "drone-dji:FlightPitchDegree=\"+1.80\" drone-dji:FlightYawDegree=\"-46.00\"";

    public static readonly (int Tag, object Value)[] First = [(0x10F, "DJI"), (0x110, "FC300S"), (0x112, 1)];

    public static readonly (int Tag, object Value)[] Detail =
    [
        (0x9003, "2016:06:23 16:31:59"), (0x9011, "-05:00"), (0x9291, "25"), (0x920A, Rationals(361, 100)),
        (0xA002, 4000), (0xA003, 2250), (0xA405, 20),
    ];

    public static readonly (int Tag, object Value)[] Gps =
    [
        (1, "N"), (2, Rationals(46, 1, 50, 1, 333855, 10000)), (3, "W"), (4, Rationals(91, 1, 59, 1, 404156, 10000)),
        (5, (byte)1), (6, Rationals(198309, 1000)), (7, Rationals(21, 1, 31, 1, 595, 10)), (0x10, "M"),
        (0x11, Rationals(4525, 100)), (0x1D, "2016:06:23"),
    ];

    public static uint[] Rationals(params uint[] numbers) => numbers;

    public static byte[] With(byte[]? exif, byte[]? xmp)
    {
        byte[] file = JpegFiles.Read("420.jpg");
        if (xmp is not null)
            file = JpegFiles.With(file, 0xE1, xmp);
        return exif is null ? file : JpegFiles.With(file, 0xE1, exif);
    }

    public static byte[] Xmp(string attributes) => Encoding.ASCII.GetBytes(
        "http://ns.adobe.com/xap/1.0/\0<?xpacket begin=\"\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>"
        + "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
        + "<rdf:Description rdf:about=\"DJI Meta Data\" xmlns:drone-dji=\"http://www.dji.com/drone-dji/1.0/\" "
        + attributes + "></rdf:Description></rdf:RDF></x:xmpmeta><?xpacket end=\"w\"?>");

    /// <summary>A first directory that leads to the two others.</summary>
    public static byte[] Exif(
        bool isBig, (int Tag, object Value)[] first, (int Tag, object Value)[] detail, (int Tag, object Value)[] gps)
    {
        var tiff = new List<byte>();
        tiff.AddRange(isBig ? "MM\0*"u8.ToArray() : "II*\0"u8.ToArray());
        tiff.AddRange(Number(isBig, 8, 4));
        int detailAt = 8 + SizeOf(first.Length + 2, first);
        int gpsAt = detailAt + SizeOf(detail.Length, detail);
        AddDirectory(tiff, isBig, [.. first, (0x8769, (uint)detailAt), (0x8825, (uint)gpsAt)]);
        AddDirectory(tiff, isBig, detail);
        AddDirectory(tiff, isBig, gps);
        return Encoding.ASCII.GetBytes("Exif\0\0").Concat(tiff).ToArray();
    }

    private static int SizeOf(int entries, (int Tag, object Value)[] values)
        => 2 + (12 * entries) + 4 + values.Sum(v => BytesOf(true, v.Value) is { Length: > 4 } b ? b.Length : 0);

    private static void AddDirectory(List<byte> tiff, bool isBig, (int Tag, object Value)[] entries)
    {
        int dataAt = tiff.Count + 2 + (12 * entries.Length) + 4;
        var data = new List<byte>();
        tiff.AddRange(Number(isBig, entries.Length, 2));
        foreach ((int tag, object value) in entries)
        {
            byte[] bytes = BytesOf(isBig, value);
            (int type, int size) = value switch
            {
                string => (2, 1),
                byte => (1, 1),
                int => (3, 2),
                uint => (4, 4),
                _ => (5, 8),
            };
            tiff.AddRange(Number(isBig, tag, 2));
            tiff.AddRange(Number(isBig, type, 2));
            tiff.AddRange(Number(isBig, bytes.Length / size, 4));
            tiff.AddRange(bytes.Length > 4
                ? Number(isBig, dataAt + data.Count, 4)
                : bytes.Concat(new byte[4]).Take(4).ToArray());
            if (bytes.Length > 4)
                data.AddRange(bytes);
        }

        tiff.AddRange(new byte[4]);
        tiff.AddRange(data);
    }

    private static byte[] BytesOf(bool isBig, object value) => value switch
    {
        string text => Encoding.ASCII.GetBytes(text + "\0"),
        byte one => [one],
        int number => Number(isBig, number, 2),
        uint number => Number(isBig, number, 4),
        uint[] numbers => numbers.SelectMany(n => Number(isBig, n, 4)).ToArray(),
        _ => throw new InvalidDataException(),
    };

    private static byte[] Number(bool isBig, long value, int bytes)
    {
        byte[] number = new byte[bytes];
        for (int at = 0; at < bytes; at++)
            number[isBig ? bytes - 1 - at : at] = (byte)(value >> (8 * at));
        return number;
    }
}
