#:property PublishAot=false
// a program of one file, run as "dotnet run eng/draw-icon.cs -- src/icon.png", is named after what it does
#pragma warning disable MA0048

// Draws the icon of the packages, 128 x 128 pixels: a rabbit's head on a blue field. Ellipses only, each pixel the mean
// of 4 x 4 samples. The same program gives the same picture; the PNG is checked in, so a build does not need this.
using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;

const int Size = 128;
const int Samples = 4;
using var rows = new MemoryStream();
for (int y = 0; y < Size; y++)
{
    rows.WriteByte(0);   // no filter
    for (int x = 0; x < Size; x++)
        rows.Write(Pixel(x, y));
}

using FileStream file = File.Create(args[0]);
file.Write([0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A]);
byte[] header = new byte[13];
BinaryPrimitives.WriteInt32BigEndian(header, Size);
BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), Size);
header[8] = 8;   // bits per channel
header[9] = 6;   // red, green, blue, alpha
Chunk("IHDR", header);
using var packed = new MemoryStream();
using (var zip = new ZLibStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
    zip.Write(rows.ToArray());
Chunk("IDAT", packed.ToArray());
Chunk("IEND", []);

void Chunk(string type, byte[] data)
{
    byte[] chunk = new byte[data.Length + 12];
    BinaryPrimitives.WriteInt32BigEndian(chunk, data.Length);
    for (int index = 0; index < 4; index++)
        chunk[4 + index] = (byte)type[index];
    data.CopyTo(chunk, 8);
    BinaryPrimitives.WriteUInt32BigEndian(chunk.AsSpan(8 + data.Length), Crc(chunk.AsSpan(4, 4 + data.Length)));
    file.Write(chunk);
}

// CRC-32 of PNG (W3C, "Portable Network Graphics Specification", annex D).
static uint Crc(ReadOnlySpan<byte> bytes)
{
    uint crc = 0xFFFFFFFF;
    foreach (byte value in bytes)
    {
        crc ^= value;
        for (int bit = 0; bit < 8; bit++)
            crc = (crc & 1) != 0 ? (crc >> 1) ^ 0xEDB88320 : crc >> 1;
    }

    return ~crc;
}

static byte[] Pixel(int x, int y)
{
    double red = 0, green = 0, blue = 0, alpha = 0;
    for (int sample = 0; sample < Samples * Samples; sample++)
    {
        uint color = Color(x + ((sample % Samples + 0.5) / Samples), y + ((sample / Samples + 0.5) / Samples));
        double weight = color >> 24;
        red += weight * ((color >> 16) & 0xFF);
        green += weight * ((color >> 8) & 0xFF);
        blue += weight * (color & 0xFF);
        alpha += weight;
    }

    return alpha == 0
        ? [0, 0, 0, 0]
        : [(byte)(red / alpha), (byte)(green / alpha), (byte)(blue / alpha), (byte)(alpha / (Samples * Samples))];
}

// Alpha, red, green, blue; what lies on top comes first.
static uint Color(double x, double y)
{
    const uint None = 0, Blue = 0xFF1F5FA8, White = 0xFFFFFFFF, Pink = 0xFFF2B8C6, Dark = 0xFF16324F;
    if (!IsInField(x, y))
        return None;
    if (IsInEllipse(x, y, 50, 82, 4.5, 6, 0) || IsInEllipse(x, y, 78, 82, 4.5, 6, 0))
        return Dark;
    if (IsInEllipse(x, y, 64, 96, 5, 3.5, 0))
        return Pink;
    if (IsInEllipse(x, y, 47, 42, 5, 22, -0.22) || IsInEllipse(x, y, 81, 42, 5, 22, 0.22))
        return Pink;
    return IsInEllipse(x, y, 64, 86, 32, 27, 0) || IsInEllipse(x, y, 47, 41, 11, 31, -0.22)
        || IsInEllipse(x, y, 81, 41, 11, 31, 0.22)
        ? White
        : Blue;
}

static bool IsInEllipse(
    double x, double y, double centerX, double centerY, double radiusX, double radiusY, double turnedBy)
{
    double dx = x - centerX, dy = y - centerY;
    double along = ((dx * Math.Cos(turnedBy)) + (dy * Math.Sin(turnedBy))) / radiusX;
    double across = ((dy * Math.Cos(turnedBy)) - (dx * Math.Sin(turnedBy))) / radiusY;
    return (along * along) + (across * across) <= 1;
}

// A square with round corners.
static bool IsInField(double x, double y)
{
    const double Radius = 22;
    double dx = Math.Max(0, Math.Max(Radius - x, x - (Size - Radius)));
    double dy = Math.Max(0, Math.Max(Radius - y, y - (Size - Radius)));
    return (dx * dx) + (dy * dy) <= Radius * Radius;
}
