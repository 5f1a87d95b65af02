using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Vision.Tests.Jpeg;

public sealed class JpegDecoderTests
{
    public static TheoryData<string, int, int, int, string> Decodable
    {
        get
        {
            var data = new TheoryData<string, int, int, int, string>();
            foreach (string[] row in JpegFiles.Expected)
            {
                if (row[0] is not ("progressive.jpg" or "arithmetic.jpg" or "cmyk.jpg"))
                    data.Add(row[0], Number(row[1]), Number(row[2]), Number(row[3]), row[4]);
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Decodable))]
    public void Decode_EverySampling_IsLibjpegsToTheBit(string file, int width, int height, int channels, string hash)
    {
        RgbPicture picture = JpegFiles.Decode(JpegFiles.Read(file), file);

        Assert.Equal((width, height), (picture.Width, picture.Height));
        Assert.Equal(hash, JpegFiles.HashOf(picture.Pixels, channels));
    }

    [Fact]
    public void Decode_NoHuffmanTables_TakesThoseOfTheStandard()
    {
        byte[] file = JpegFiles.Read("422-wide.jpg");
        byte[] asCamera = JpegFiles.Without(file, 0xC4);

        Assert.True(asCamera.Length < file.Length - 400);
        Assert.Equal(JpegFiles.Decode(file, "a").Pixels, JpegFiles.Decode(asCamera, "b").Pixels);
    }

    [Fact]
    public void Decode_BytesAfterTheEndAndAPictureInside_GivesThePicture()
    {
        byte[] file = JpegFiles.Read("420.jpg");
        byte[] thumbnail = Encoding.ASCII.GetBytes("Exif\0\0").Concat(JpegFiles.Read("grey.jpg")).ToArray();
        byte[] changed = JpegFiles.With(file, 0xE1, thumbnail).Concat(JpegFiles.Read("444.jpg")).ToArray();

        Assert.Equal(JpegFiles.Decode(file, "a").Pixels, JpegFiles.Decode(changed, "b").Pixels);
    }

    [Fact]
    public void Decode_NoEndMarker_GivesThePicture()
    {
        byte[] file = JpegFiles.Read("420.jpg");

        Assert.Equal(
            JpegFiles.Decode(file, "a").Pixels, JpegFiles.Decode(file.Take(file.Length - 2).ToArray(), "b").Pixels);
    }

    [Fact]
    public void Decode_ExtendedSequentialAndTablesOf16Bits_GivesThePicture()
    {
        byte[] file = JpegFiles.Read("grey.jpg");
        byte[] changed = JpegFiles.Without(file, 0xDB);
        byte[] steps = file.Skip(JpegFiles.Find(file, 0xDB) + 1).Take(64).ToArray();
        changed = JpegFiles.With(
            changed, 0xDB, new byte[] { 0x10 }.Concat(steps.SelectMany(s => new byte[] { 0, s })).ToArray());
        changed[JpegFiles.Find(changed, 0xC0) - 3] = 0xC1;

        Assert.Equal(JpegFiles.Decode(file, "a").Pixels, JpegFiles.Decode(changed, "b").Pixels);
    }

    [Theory]
    [InlineData("progressive.jpg", "progressive")]
    [InlineData("arithmetic.jpg", "arithmetic")]
    [InlineData("cmyk.jpg", "CMYK")]
    public void Decode_KindThatIsNotRead_IsRefusedByName(string file, string reason)
        => AssertRefused(JpegFiles.Read(file), reason);

    [Theory]
    [InlineData(0xC3, 8, 40, 30, "lossless")]
    [InlineData(0xC5, 8, 40, 30, "hierarchical")]
    [InlineData(0xC1, 12, 40, 30, "12 bits")]
    [InlineData(0xC0, 8, 0, 30, "size")]
    [InlineData(0xC0, 8, 40, 0, "size")]
    [InlineData(0xC0, 8, 65535, 65535, "size")]
    [InlineData(0xC0, 8, 16384, 3000, "cut off")]
    public void Decode_OtherFrame_IsRefusedByNameAndTakesNoMemory(
        int marker, int bits, int width, int height, string reason)
    {
        byte[] file = JpegFiles.Read("grey.jpg");
        int frame = JpegFiles.Find(file, 0xC0);
        file[frame - 3] = (byte)marker;
        byte[] header = [(byte)bits, (byte)(height >> 8), (byte)height, (byte)(width >> 8), (byte)width];
        header.CopyTo(file, frame);
        var decoder = new JpegDecoder(mayUseLibrary: false);

        PictureException fault = Assert.Throws<PictureException>(() => decoder.Open(file, 0, file.Length, "x"));

        Assert.Contains(reason, fault.Reason, StringComparison.Ordinal);
        if (Allocated.IsSupported)
            Assert.True(Allocated.By(() => Refuse(decoder, file)) < 100_000);
    }

    [Fact]
    public void Decode_CutAnywhere_IsRefusedOrWhole()
    {
        byte[] file = JpegFiles.Read("420-restarts.jpg");

        int refused = JpegFiles.CountRefusedCuts(file, mayUseLibrary: false);

        Assert.InRange(refused, file.Length - 4, file.Length - 1);
    }

    [Fact]
    public void Decode_RestartMarkerMissing_SaysSo()
    {
        byte[] file = JpegFiles.Read("422-restart-each.jpg");
        int marker = Enumerable.Range(0, file.Length - 1).First(at => file[at] == 0xFF && file[at + 1] == 0xD3);
        file[marker + 1] = 0xD5;

        AssertRefused(file, "restart marker 4 is missing");
    }

    [Fact]
    public void Decode_NotOpenOrTwice_IsRefused()
    {
        var decoder = new JpegDecoder(mayUseLibrary: false);
        byte[] file = JpegFiles.Read("grey.jpg");
        byte[] pixels = new byte[61 * 43 * 3];

        Assert.Throws<InvalidOperationException>(() => decoder.Decode(pixels));
        decoder.Open(file, 0, file.Length, "x");
        Assert.Throws<ArgumentException>(() => decoder.Decode(new byte[61 * 43]));
        decoder.Decode(pixels);
        Assert.Throws<InvalidOperationException>(() => decoder.Decode(pixels));
    }

    [Fact]
    public void Decode_OneAfterTheOther_AllocatesNothing()
    {
        var decoder = new JpegDecoder(mayUseLibrary: false);
        var files = new List<byte[]>
        {
            JpegFiles.Read("420-wide.jpg"), JpegFiles.Read("422-wide.jpg"), JpegFiles.Read("440-wide.jpg"),
            JpegFiles.Read("grey.jpg"), JpegFiles.Read("411.jpg"), JpegFiles.Read("420-separate.jpg"),
        };
        byte[] pixels = new byte[200 * 130 * 3];
        void DecodeAll()
        {
            foreach (byte[] file in files)
            {
                decoder.Open(file, 0, file.Length, "x");
                decoder.Decode(pixels);
            }
        }

        DecodeAll();

        Assert.Equal(0, Allocated.By(DecodeAll));
    }

    private static int Number(string text) => int.Parse(text, CultureInfo.InvariantCulture);

    private static void Refuse(JpegDecoder decoder, byte[] file)
    {
        try
        {
            decoder.Open(file, 0, file.Length, "x");
        }
        catch (PictureException)
        {
        }
    }

    private static void AssertRefused(byte[] file, string reason)
    {
        PictureException fault = Assert.Throws<PictureException>(() => JpegFiles.Decode(file, "x.jpg"));
        Assert.StartsWith("x.jpg: ", fault.Message, StringComparison.Ordinal);
        Assert.Contains(reason, fault.Reason, StringComparison.Ordinal);
    }
}
