using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Vision.Tests.Jpeg;
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

    // A link as well: who opens it is blocked too.
    [Theory]
    [InlineData("pipe.png", "it is a pipe, not a file")]
    [InlineData("link.png", "it is a pipe, not a file")]
    [InlineData("/dev/zero", "it is a device, not a file")]
    public void Load_NoFile_IsRefusedAtOnce(string name, string fault)
    {
        if (!Directory.Exists("/proc/self"))
            return;
        SamplePictures.MakePipe(_folder.File("pipe.png"));
        using (Process link = Process.Start("ln", $"-s pipe.png \"{_folder.File("link.png")}\"")!)
            link.WaitForExit();
        string path = name[0] == '/' ? name : _folder.File(name);

        Assert.Equal($"{path}: {fault}", Assert.Throws<PictureException>(() => PictureFile.Load(path)).Message);
    }

    [Theory]
    [InlineData("P6\n2 1\n255\n")]
    [InlineData("P6 2 1 255 ")]
    [InlineData("P6\n# a camera\n2 # columns\n\t1\r\n255\n")]
    [InlineData("P6\n2 1\n255# 8 bits\n")]
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
    [InlineData("P6\n2 1\n255# without an end of line", "cut off")]
    [InlineData("P6\n# no end", "header")]
    [InlineData("P6", "header")]
    [InlineData("", "empty")]
    [InlineData("P5\n2 1\n255\n1", "cut off")]
    [InlineData("P5\n2 1\n256\n123", "cut off")]
    [InlineData("P5\n2 1\n65536\n1234", "65535")]
    [InlineData("P5\n2 1\n0\n1234", "its largest value is 0")]
    [InlineData("P4\n2 1\n  ", "only JPEG, PNG and binary PPM")]
    [InlineData("hello", "only JPEG, PNG and binary PPM")]
    public void Load_WrongText_SaysWhy(string file, string reason)
    {
        string path = Write("x.ppm", Encoding.ASCII.GetBytes(file));

        PictureException fault = Assert.Throws<PictureException>(() => PictureFile.Load(path));

        Assert.StartsWith(path + ": ", fault.Message, StringComparison.Ordinal);
        Assert.Contains(reason, fault.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("P5 2 2 255 ", new byte[] { 0, 7, 200, 255 }, new byte[] { 0, 7, 200, 255 })]
    [InlineData("P5 2 2 100 ", new byte[] { 0, 50, 100, 120 }, new byte[] { 0, 128, 255, 255 })]
    [InlineData("P5 2 2 65535 ", new byte[] { 0, 0, 1, 0, 128, 0, 255, 255 }, new byte[] { 0, 1, 128, 255 })]
    [InlineData("P5 2 2 16383 ", new byte[] { 0, 0, 32, 0, 63, 255, 255, 255 }, new byte[] { 0, 128, 255, 255 })]
    public void Load_Pgm_GivesGreyOf8Bits(string header, byte[] content, byte[] grey)
    {
        RgbPicture picture = PictureFile.Load(Write("x", Encoding.ASCII.GetBytes(header).Concat(content).ToArray()));

        Assert.Equal((2, 2), (picture.Width, picture.Height));
        Assert.Equal(grey.SelectMany(g => new[] { g, g, g }), picture.Pixels);
    }

    [Fact]
    public void Load_Jpeg_ByItsFirstBytes()
    {
        string path = Write("x.png", JpegFiles.Read("420.jpg"));

        Assert.Equal(JpegPicture.Decode(JpegFiles.Read("420.jpg"), "x").Pixels, PictureFile.Load(path).Pixels);
    }

    [Fact]
    public void Load_JpegThatIsNotRead_NamesFileAndReason()
    {
        string path = Write("x.jpg", JpegFiles.Read("arithmetic.jpg"));

        PictureException fault = Assert.Throws<PictureException>(() => PictureFile.Load(path));

        Assert.StartsWith(path + ": it is a JPEG with arithmetic coding", fault.Message, StringComparison.Ordinal);
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

        PictureException fault = Assert.Throws<PictureException>(
            () => new PictureReader().LoadInto(path, 4, 4, new byte[48]));

        Assert.Contains("4 x 5 pixels", fault.Message, StringComparison.Ordinal);
        Assert.Contains("4 x 4", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void LoadInto_KindsInTurn_GivesEach()
    {
        var reader = new PictureReader();
        RgbPicture jpeg = JpegPicture.Decode(JpegFiles.Read("grey.jpg"), "x");
        string[] paths =
            [Write("a.jpg", JpegFiles.Read("grey.jpg")), _folder.File("a.png"), _folder.File("a.ppm"), _folder.File("b.png")];
        foreach (string path in paths.Skip(1))
            PictureFile.Save(path, jpeg);
        foreach (string path in paths)
        {
            byte[] pixels = new byte[jpeg.Pixels.Length];
            reader.LoadInto(path, 61, 43, pixels);
            Assert.Equal(jpeg.Pixels, pixels);
        }
    }

    private string Write(string name, byte[] bytes)
    {
        string path = _folder.File(name);
        File.WriteAllBytes(path, bytes);
        return path;
    }
}
