using System;
using System.IO;
using System.Linq;
using System.Text;
using Rabit.Vision.Tests.Pictures;
using Xunit;

namespace Rabit.Vision.Tests.Templates;

/// <summary>The file of a template: whole ones come back as they were, all others are refused by name.</summary>
public sealed class TemplateFileTests : IDisposable
{
    private readonly string _path = Path.Combine(Path.GetTempPath(), $"{Guid.NewGuid():N}.template");
    private readonly ObjectTemplate _template;

    public TemplateFileTests()
    {
        _template = new TemplateTrainingOptions { Name = "car" }.CreateTemplate();
        var random = new Random(5);
        _template.Weights = Enumerable.Range(0, _template.CellsLong * _template.CellsWide * HogFeatures.Dimensions)
            .Select(_ => (float)(random.NextDouble() - 0.5)).ToArray();
        (_template.Bias, _template.Threshold, _template.Offset) = (-0.123456789, 0.1, 1e-5);
    }

    public void Dispose() => File.Delete(_path);

    [Fact]
    public void Load_WhatWasSaved_IsTheSame()
    {
        _template.Save(_path);
        ObjectTemplate read = ObjectTemplate.Load(_path);
        Assert.Equal(File.ReadAllBytes(_path), TemplateFile.Format(read));
        Assert.Equal(_template.Weights, read.Weights);
        Assert.Equal(
            ("car", 4.8, 2.0, 0.15, -0.123456789),
            (read.Name, read.LengthMetres, read.WidthMetres, read.MetresPerPixel, read.Bias));
    }

    [Fact]
    public void Load_NamedPipe_IsRefusedAndNotWaitedFor()
    {
        if (!Directory.Exists("/proc/self"))
            return;   // named pipes are looked for on Linux
        SamplePictures.MakePipe(_path);
        Assert.Equal(
            _path + ": it is a pipe, not a file",
            Assert.Throws<PictureException>(() => ObjectTemplate.Load(_path)).Message);
    }

    [Fact]
    public void Parse_LineEndsOfWindows_IsTheSame()
    {
        string text = Encoding.ASCII.GetString(TemplateFile.Format(_template)).Replace("\n", "\r\n");
        Assert.Equal(_template.Weights, TemplateFile.Parse(Encoding.ASCII.GetBytes(text), "a").Weights);
    }

    [Fact]
    public void Parse_AnyByteChanged_IsRefused()
    {
        byte[] file = TemplateFile.Format(_template);
        var random = new Random(6);
        for (int i = 0; i < 300; i++)
        {
            byte[] changed = [.. file];
            changed[random.Next(file.Length)] ^= (byte)(1 << random.Next(8));
            var error = Assert.Throws<PictureException>(() => TemplateFile.Parse(changed, "my.template"));
            Assert.StartsWith("my.template: it is no template of Rabit: ", error.Message, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Parse_CutAnywhere_IsRefused()
    {
        byte[] file = TemplateFile.Format(_template);
        for (int length = 0; length < file.Length - 1; length += 1 + (length / 7))
            Assert.Throws<PictureException>(() => TemplateFile.Parse(file.Take(length).ToArray(), "a"));
    }

    // The checksum fits: it was written so.
    [Theory]
    [InlineData("lengthMetres 4.8", "lengthMetres 1e308", "the object is")]
    [InlineData("lengthMetres 4.8", "lengthMetres NaN", "the object is NaN")]
    [InlineData("cellsLong 12", "cellsLong 2000000000", "a window of 2000000000 x 6 cells")]
    [InlineData("cellsLong 12", "cellsLong -1", "cellsLong in line 7 is no whole number")]
    [InlineData("cellPixels 4", "cellPixels 0", "cells of 0 pixels")]
    [InlineData("headings 12", "headings 0", "0 headings")]
    [InlineData("metresPerPixel 0.15", "metresPerPixel 0", "a pixel of 0 m")]
    [InlineData("metresPerPixel 0.15", "metresPerPixels 0.15", "line 5 is not \"metresPerPixel\"")]
    [InlineData("weights 936", "weights 937", "it has 937 weights; its window needs 936")]
    [InlineData("weights 936\n", "weights 936\n0 0\n", "line 16 has 2 weights, not 13")]
    [InlineData("weights 936\n", "weights 936\n1e39 0 0 0 0 0 0 0 0 0 0 0 0\n", "weight 1 in line 16")]
    [InlineData("weights 936\n", "weights 936\n0 0 0 0 0 0 0 0 0 0 0 0 0\n", "there is more behind the weights")]
    [InlineData("slope 2", "slope -2", "the slope above 0")]
    [InlineData("rabit-template 1", "rabit-template 2", "it does not begin with")]
    public void Parse_WrongValue_NamesIt(string line, string instead, string fault)
    {
        string text = Encoding.ASCII.GetString(TemplateFile.Format(_template));
        Assert.Contains(line, text, StringComparison.Ordinal);
        byte[] body = Encoding.ASCII.GetBytes(
            text.Substring(0, text.IndexOf("crc32", StringComparison.Ordinal)).Replace(line, instead));
        byte[] end = Encoding.ASCII.GetBytes($"crc32 {Checksums.Crc32(body, 0, body.Length):x8}\n");
        var error = Assert.Throws<PictureException>(() => TemplateFile.Parse([.. body, .. end], "a"));
        Assert.Contains(fault, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Load_NoFile_NamesIt()
    {
        Assert.StartsWith(
            _path, Assert.Throws<PictureException>(() => ObjectTemplate.Load(_path)).Message, StringComparison.Ordinal);
        File.WriteAllBytes(_path, new byte[(4 << 20) + 1]);
        Assert.Contains(
            "at most 4194304", Assert.Throws<PictureException>(() => ObjectTemplate.Load(_path)).Message,
            StringComparison.Ordinal);
        Assert.Throws<PictureException>(() => _template.Save(Path.Combine(_path, "none", "a")));
    }
}
