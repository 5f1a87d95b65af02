using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using Xunit;

namespace Rabit.Vision.Tests.Pictures;

/// <summary>Pictures of thermal cameras: 16 bits, as PGM and as PNG.</summary>
public sealed class CountsTests : IDisposable
{
    private static readonly ushort[] Counts = [0, 1, 255, 256, 7300, 65535];

    private readonly string _path = Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString("N"));
    private readonly PictureReader _reader = new();

    public void Dispose() => File.Delete(_path);

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void LoadCountsInto_SixteenBits_GivesTheValues(bool isPng)
    {
        File.WriteAllBytes(_path, isPng ? Png(16) : Pgm(65535));
        ushort[] read = new ushort[7];
        _reader.LoadCountsInto(_path, 3, 2, read);
        Assert.Equal([.. Counts, 0], read);

        // As colours: the upper bits.
        Assert.Equal([0, 0, 0, 0, 0, 0], _reader.Load(_path).Pixels.Take(6));
        Assert.Equal(255, _reader.Load(_path).Pixels[17]);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void LoadCountsInto_EightBits_IsRefused(bool isPng)
    {
        File.WriteAllBytes(_path, isPng ? Png(8) : Pgm(255));
        var error = Assert.Throws<PictureException>(() => _reader.LoadCountsInto(_path, 3, 2, new ushort[6]));
        Assert.Equal("it has no 16 bits of grey, as the pictures of a thermal camera have", error.Reason);
    }

    [Fact]
    public void LoadCountsInto_WrongSizeOrCut_IsRefused()
    {
        File.WriteAllBytes(_path, Pgm(65535));
        Assert.Throws<PictureException>(() => _reader.LoadCountsInto(_path, 2, 3, new ushort[6]));
        Assert.Throws<ArgumentException>(() => _reader.LoadCountsInto(_path, 3, 2, new ushort[5]));
        File.WriteAllBytes(_path, Pgm(65535).Take(20).ToArray());
        Assert.Throws<PictureException>(() => _reader.LoadCountsInto(_path, 3, 2, new ushort[6]));
    }

    private static byte[] Pgm(int most)
        => [.. Encoding.ASCII.GetBytes($"P5\n3 2\n{most}\n"), .. Bytes(most > 255 ? 16 : 8)];

    private static byte[] Bytes(int bits)
        => [.. Counts.SelectMany(c => bits == 16 ? new[] { (byte)(c >> 8), (byte)c } : [(byte)c])];

    private static byte[] Png(int bits)
    {
        byte[] pixels = Bytes(bits);
        byte[] lines = [0, .. pixels.Take(pixels.Length / 2), 0, .. pixels.Skip(pixels.Length / 2)];
        using var packed = new MemoryStream();
        using (var deflate = new DeflateStream(packed, CompressionLevel.Fastest, leaveOpen: true))
            deflate.Write(lines, 0, lines.Length);
        uint adler = Checksums.Adler32(1, lines, 0, lines.Length);
        byte[] data = [0x78, 0x9C, .. packed.ToArray(), .. Number(adler)];
        return
        [
            .. PngPicture.Signature,
            .. Chunk("IHDR", [.. Number(3), .. Number(2), (byte)bits, 0, 0, 0, 0]),
            .. Chunk("IDAT", data),
            .. Chunk("IEND", []),
        ];
    }

    private static byte[] Chunk(string name, byte[] data)
    {
        byte[] body = [.. Encoding.ASCII.GetBytes(name), .. data];
        return [.. Number((uint)data.Length), .. body, .. Number(Checksums.Crc32(body, 0, body.Length))];
    }

    private static byte[] Number(uint value)
        => [(byte)(value >> 24), (byte)(value >> 16), (byte)(value >> 8), (byte)value];
}
