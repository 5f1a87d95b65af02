using System;
using System.IO;
using System.Linq;
using System.Text;
using Xunit;

namespace Rabit.Vision.Tests.Pictures;

public sealed class PictureFileTests : IDisposable
{
    private readonly SamplePictures.TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("a.png", 0x89)]
    [InlineData("a.ppm", 'P')]
    [InlineData("a.PPM", 'P')]
    public void Load_OfSave_GivesTheSame(string name, int firstByte)
    {
        RgbPicture picture = SamplePictures.Random(21, 13, seed: 5);
        string path = _folder.File(name);

        PictureFile.Save(path, picture);
        RgbPicture again = PictureFile.Load(path);

        Assert.Equal(firstByte, File.ReadAllBytes(path)[0]);
        Assert.Equal((21, 13), (again.Width, again.Height));
        Assert.Equal(picture.Pixels, again.Pixels);
    }

    [Theory]
    [InlineData("P6\n2 1\n255\n")]
    [InlineData("P6 2 1 255 ")]
    [InlineData("P6\n# a camera\n2 # columns\n\t1\r\n255\n")]
    public void Load_PpmHeaders_AreUnderstood(string header)
    {
        byte[] file = Encoding.ASCII.GetBytes(header).Concat(new byte[] { 1, 2, 3, 10, 32, 35 }).ToArray();

        RgbPicture picture = PictureFile.Load(Write("x.ppm", file));

        Assert.Equal((2, 1), (picture.Width, picture.Height));
        Assert.Equal([1, 2, 3, 10, 32, 35], picture.Pixels);
    }

    [Theory]
    [InlineData("P6\n2 1\n65535\n      ", "only 255")]
    [InlineData("P6\n0 1\n255\n      ", "size")]
    [InlineData("P6\n99999 99999\n255\n      ", "size")]
    [InlineData("P6\n99999999999999999999 1\n255\n      ", "header")]
    [InlineData("P6\n-2 1\n255\n      ", "header")]
    [InlineData("P62 1\n255\n      ", "header")]
    [InlineData("P6\n2 1\n255\n12345", "cut off")]
    [InlineData("P6\n2 1\n255", "header")]
    [InlineData("P6\n# no end", "header")]
    [InlineData("P6", "header")]
    [InlineData("", "empty")]
    [InlineData("P5\n2 1\n255\n  ", "only PNG and binary PPM")]
    [InlineData("hello", "only PNG and binary PPM")]
    public void Load_WrongText_SaysWhy(string file, string reason)
    {
        string path = Write("x.ppm", Encoding.ASCII.GetBytes(file));

        PictureException fault = Assert.Throws<PictureException>(() => PictureFile.Load(path));

        Assert.StartsWith(path + ": ", fault.Message, StringComparison.Ordinal);
        Assert.Contains(reason, fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Load_Jpeg_SaysWhatIsRead()
    {
        string path = Write("x.png", [0xFF, 0xD8, 0xFF, 0xE0, 0, 16]);

        PictureException fault = Assert.Throws<PictureException>(() => PictureFile.Load(path));

        Assert.Equal(path + ": that is a JPEG; only PNG and binary PPM (P6) are read", fault.Message);
    }

    [Fact]
    public void Load_NothingThere_SaysSo()
    {
        Assert.Contains(
            "no such file", Assert.Throws<PictureException>(() => PictureFile.Load(_folder.File("none.png"))).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "folder", Assert.Throws<PictureException>(() => PictureFile.Load(_folder.Path)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Save_NowhereToWrite_SaysSo()
    {
        string path = _folder.File(Path.Combine("missing", "a.png"));

        PictureException fault = Assert.Throws<PictureException>(
            () => PictureFile.Save(path, SamplePictures.Random(2, 2, seed: 1)));

        Assert.Contains("cannot be written", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void LoadInto_OtherSize_SaysWhich()
    {
        string path = Write("x.png", Convert.FromBase64String(SamplePictures.Rgb));
        byte[]? buffer = null;

        PictureException fault = Assert.Throws<PictureException>(
            () => PictureFile.LoadInto(path, 4, 4, new byte[48], ref buffer));

        Assert.Contains("4 x 5 pixels", fault.Message, StringComparison.Ordinal);
        Assert.Contains("4 x 4", fault.Message, StringComparison.Ordinal);
    }

    private string Write(string name, byte[] bytes)
    {
        string path = _folder.File(name);
        File.WriteAllBytes(path, bytes);
        return path;
    }
}
