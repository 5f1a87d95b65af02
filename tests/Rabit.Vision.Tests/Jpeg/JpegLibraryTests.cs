using System;
using System.IO;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Jpeg;

/// <summary>The decoder with libturbojpeg does what it does without, and reads progressive files too.</summary>
public sealed class JpegLibraryTests(ITestOutputHelper output)
{
    public static TheoryData<string, int, int, int, string> Decodable => JpegDecoderTests.Decodable;

    [Theory]
    [MemberData(nameof(Decodable))]
    public void Decode_EverySampling_IsLibjpegsToTheBit(string file, int width, int height, int channels, string hash)
    {
        RgbPicture picture = JpegPicture.Decode(JpegFiles.Read(file), file);

        Assert.Equal((width, height), (picture.Width, picture.Height));
        Assert.Equal(hash, JpegFiles.HashOf(picture.Pixels, channels));
    }

    [TurboJpegFact]
    public void Decode_Progressive_GivesThePicture()
    {
        string[] row = JpegFiles.Expected.Single(r => r[0] == "progressive.jpg");
        byte[] file = JpegFiles.Read("progressive.jpg");
        var decoder = new JpegDecoder();

        RgbPicture picture = JpegPicture.Decode(file, "x");

        Assert.Equal("libturbojpeg", decoder.Engine);
        Assert.Equal(row[4], JpegFiles.HashOf(picture.Pixels, 3));
    }

    [TurboJpegFact]
    public void Decode_ProgressiveCutAnywhere_IsRefusedOrWhole()
    {
        byte[] file = JpegFiles.Read("progressive.jpg");

        int refused = JpegFiles.CountRefusedCuts(file, mayUseLibrary: true);

        Assert.InRange(refused, file.Length - 4, file.Length);
    }

    [TurboJpegFact]
    public void Decode_ProgressiveOfCountlessScans_IsRefused()
    {
        byte[] file = JpegFiles.Read("progressive.jpg");
        int last = Enumerable.Range(0, file.Length - 1).Last(at => file[at] == 0xFF && file[at + 1] == 0xDA);
        byte[] scan = file.Skip(last).Take(file.Length - 2 - last).ToArray();
        byte[] bomb = file.Take(last).Concat(Enumerable.Repeat(scan, 400).SelectMany(s => s)).Concat(file.Skip(last))
            .ToArray();

        PictureException fault = Assert.Throws<PictureException>(() => JpegPicture.Decode(bomb, "x"));

        Assert.Contains("scans", fault.Reason, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("arithmetic.jpg", "arithmetic")]
    [InlineData("cmyk.jpg", "CMYK")]
    public void Decode_KindThatIsNotRead_IsRefusedByName(string file, string reason)
        => Assert.Contains(
            reason,
            Assert.Throws<PictureException>(() => JpegPicture.Decode(JpegFiles.Read(file), "x")).Reason,
            StringComparison.Ordinal);

    [Fact]
    public void New_WithoutTheLibrary_IsOurs()
    {
        var decoder = new JpegDecoder(mayUseLibrary: false);
        byte[] file = JpegFiles.Read("progressive.jpg");

        Assert.Equal("Rabit", decoder.Engine);
        Assert.Contains(
            "progressive", Assert.Throws<PictureException>(() => decoder.Open(file, 0, file.Length, "x")).Reason,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Decode_Mutations_EndAsWithoutTheLibrary() => Mutate(seed: 12, count: 1_500);

    [Theory, Trait("Category", "Long")]
    [InlineData(3)]
    public void Decode_ManyMutations_EndAsWithoutTheLibrary(int seed) => Mutate(seed, count: 10_000);

    [Fact]
    public void Decode_OneAfterTheOther_AllocatesNothing()
    {
        var decoder = new JpegDecoder();
        byte[][] files = [JpegFiles.Read("420-wide.jpg"), JpegFiles.Read("grey.jpg"), JpegFiles.Read("422-wide.jpg")];
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

    // Where the library finds fault, ours decides. A picture that both give is the same, but for values that no encoder
    // writes, with which each calculates on in its own way: the library itself gives others without its SIMD.
    private void Mutate(int seed, int count)
    {
        string[] names =
            ["grey.jpg", "444.jpg", "420.jpg", "410.jpg", "420-restarts.jpg", "420-separate.jpg", "progressive.jpg"];
        var numbers = new SeededNumbers(seed);
        var (library, own) = (new JpegDecoder(), new JpegDecoder(mayUseLibrary: false));
        (int both, int others, int onlyLibrary, int onlyOwn) = (0, 0, 0, 0);
        for (int at = 0; at < count; at++)
        {
            byte[] file = JpegHostileTests.Change(JpegFiles.Read(names[at % names.Length]), numbers);
            byte[]? first = TryDecode(library, file);
            byte[]? second = TryDecode(own, file);
            if (first is not null && second is not null)
            {
                both++;
                others += first.SequenceEqual(second) ? 0 : 1;
            }

            onlyLibrary += first is not null && second is null ? 1 : 0;
            onlyOwn += first is null && second is not null ? 1 : 0;
        }

        string text = $"seed {seed}: {both} decoded by both, {others} of them to other pixels, {onlyLibrary} with the "
            + $"library only, {onlyOwn} without";
        output.WriteLine(text);
        Assert.True(onlyOwn == 0 && others <= both / 50, text);
        Assert.True(both > count / 50);
    }

    private static byte[]? TryDecode(JpegDecoder decoder, byte[] file)
    {
        try
        {
            decoder.Open(file, 0, file.Length, "x");
            byte[] pixels = new byte[decoder.Width * decoder.Height * 3];
            decoder.Decode(pixels);
            return pixels;
        }
        catch (PictureException)
        {
            return null;
        }
    }
}

/// <summary>A test of libturbojpeg.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class TurboJpegFactAttribute : FactAttribute
{
    public TurboJpegFactAttribute()
    {
        if (new JpegDecoder().Engine != "libturbojpeg")
            Skip = "libturbojpeg is not installed here (Debian: libturbojpeg0).";
    }
}
