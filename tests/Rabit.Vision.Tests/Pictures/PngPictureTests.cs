using System;
using System.Linq;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Pictures;

public class PngPictureTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData(SamplePictures.Rgb, false)]
    [InlineData(SamplePictures.Rgba, false)]
    [InlineData(SamplePictures.Palette, false)]
    [InlineData(SamplePictures.Grey, true)]
    [InlineData(SamplePictures.GreyAlpha, true)]
    public void Decode_FileOfAnotherProgram_GivesItsPixels(string file, bool isGrey)
    {
        RgbPicture picture = PngPicture.Decode(Convert.FromBase64String(file), "sample");

        Assert.Equal((SamplePictures.Width, SamplePictures.Height), (picture.Width, picture.Height));
        Assert.Equal(SamplePictures.Pixels(isGrey), picture.Pixels);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(3, 2)]
    [InlineData(1, 700)]
    [InlineData(640, 48)]
    public void Decode_OfEncode_GivesTheSame(int width, int height)
    {
        RgbPicture picture = SamplePictures.Random(width, height, seed: width);

        RgbPicture again = PngPicture.Decode(PngPicture.Encode(picture), "own");

        Assert.Equal((width, height), (again.Width, again.Height));
        Assert.Equal(picture.Pixels, again.Pixels);
    }

    [Fact]
    public void Encode_SmoothPicture_IsSmallerThanItsPixels()
    {
        byte[] pixels = Enumerable.Range(0, 64 * 64 * 3).Select(i => (byte)(i / 192)).ToArray();

        Assert.InRange(PngPicture.Encode(new RgbPicture(64, 64, pixels)).Length, 60, pixels.Length / 4);
    }

    [Theory]
    [InlineData(SamplePictures.SixteenBits, "16 bits per channel")]
    [InlineData(SamplePictures.Interlaced, "interlaced")]
    public void Decode_OtherKind_SaysWhy(string file, string reason)
    {
        PictureException fault = Assert.Throws<PictureException>(
            () => PngPicture.Decode(Convert.FromBase64String(file), "f1.png"));

        Assert.StartsWith("f1.png: ", fault.Message, StringComparison.Ordinal);
        Assert.Contains(reason, fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Decode_CutOffAnywhere_SaysSo()
    {
        byte[] file = Convert.FromBase64String(SamplePictures.Rgb);
        for (int length = 0; length < file.Length; length++)
        {
            byte[] part = file.Take(length).ToArray();
            Assert.Throws<PictureException>(() => PngPicture.Decode(part, "cut"));
        }
    }

    [Fact]
    public void Decode_AnyBitFlipped_IsRefused()
    {
        byte[] file = Convert.FromBase64String(SamplePictures.Palette);
        for (int bit = 0; bit < file.Length * 8; bit++)
        {
            byte[] damaged = (byte[])file.Clone();
            damaged[bit / 8] ^= (byte)(1 << (bit % 8));
            Assert.Throws<PictureException>(() => PngPicture.Decode(damaged, "bit " + bit));
        }
    }

    [Fact]
    public void Decode_DamagedInsideIntactChunks_IsRefusedOrWhole()
    {
        const int Seed = 11;
        output.WriteLine($"seed {Seed}");
        var random = new Random(Seed);
        byte[] file = PngPicture.Encode(SamplePictures.Random(30, 20, seed: 3));
        int refused = 0;
        for (int run = 0; run < 300; run++)
        {
            // The checksum of the chunk is made to fit again: what is left is the packing, the filters and the sum of
            // the pixels.
            byte[] damaged = (byte[])file.Clone();
            int length = (int)PngPicture.GetNumber(damaged, 33);
            damaged[41 + random.Next(length)] ^= (byte)(1 + random.Next(255));
            PutNumber(damaged, 41 + length, Checksums.Crc32(damaged, 37, length + 4));
            try
            {
                PngPicture.Decode(damaged, "damaged");
            }
            catch (PictureException)
            {
                refused++;
            }
        }

        Assert.InRange(refused, 299, 300);   // a bit of padding may mean nothing
    }

    [Theory]
    [InlineData(0, 5)]
    [InlineData(0xFFFFFFFF, 0xFFFFFFFF)]
    [InlineData(16_385, 1)]
    [InlineData(16_000, 16_000)]
    public void Decode_HostileSize_IsRefusedAtOnce(uint width, uint height)
    {
        byte[] file = Convert.FromBase64String(SamplePictures.Rgb);
        PutNumber(file, 16, width);
        PutNumber(file, 20, height);
        PutNumber(file, 29, Checksums.Crc32(file, 12, 17));

        PictureException fault = Assert.Throws<PictureException>(() => PngPicture.Decode(file, "huge"));

        Assert.Contains("size", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Checksums_KnownTexts_AreRight()
    {
        byte[] check = "123456789"u8.ToArray();
        Assert.Equal(0xCBF43926, Checksums.Crc32(check, 0, check.Length));
        byte[] wikipedia = "Wikipedia"u8.ToArray();
        Assert.Equal(0x11E60398u, Checksums.Adler32(1, wikipedia, 0, wikipedia.Length));
    }

    private static void PutNumber(byte[] data, int at, uint value)
    {
        for (int i = 0; i < 4; i++)
            data[at + i] = (byte)(value >> (24 - (8 * i)));
    }
}
